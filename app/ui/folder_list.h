/// What a folder holds that the file dialog can use.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace batten::ui {

struct FolderContent {
    std::filesystem::path folder;                           ///< absolute, without "." and ".."
    std::vector<std::filesystem::directory_entry> entries;  ///< folders first, then .json files, each by name
    std::string problem;                                    ///< why the folder cannot be read; else empty
};

/// Reads `folder`; hidden entries are left out.
FolderContent read_folder(const std::filesystem::path& folder);

}  // namespace batten::ui
