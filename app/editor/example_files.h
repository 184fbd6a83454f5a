/// The files of the folder of examples, in the order of a lecture.
#pragma once

#include <filesystem>
#include <vector>

namespace batten::editor {

/// The paths of the examples in `folder`: first those that its order.txt names, one on each line without ".json", in
/// that order, then the others by name. Empty for a folder that cannot be read.
std::vector<std::filesystem::path> example_files(const std::filesystem::path& folder);

}  // namespace batten::editor
