#include "app/editor/state/user_folder.h"

#include <cstdlib>

namespace batten::editor {

namespace {

namespace fs = std::filesystem;

// An absolute path from the environment, or an empty one: relative ones are to be ignored.
fs::path folder_from(const char* variable) {
    const char* value = std::getenv(variable);
    const fs::path path = value == nullptr ? fs::path() : fs::path(value);
    return path.is_absolute() ? path : fs::path();
}

}  // namespace

fs::path user_folder(const char* variable, const char* otherwise) {
    fs::path folder = folder_from(variable);
    const fs::path home = folder_from("HOME");
    if (!folder.empty() || home.empty()) return folder;
    return home / otherwise;
}

}  // namespace batten::editor
