/// Where programs of this system keep what belongs to a user.
#pragma once

#include <filesystem>

namespace batten::editor {

/// The folder that the environment variable `variable` names by an absolute path, else `otherwise` in the home folder;
/// empty without a home.
std::filesystem::path user_folder(const char* variable, const char* otherwise);

}  // namespace batten::editor
