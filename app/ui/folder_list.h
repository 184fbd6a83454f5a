/// What a folder holds that the file dialog can use.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace batten::ui {

struct FolderEntry {
    std::string name;
    bool is_folder = false;
};

struct FolderContent {
    std::filesystem::path folder;      ///< absolute, without "." and ".."
    std::vector<FolderEntry> entries;  ///< folders first, then files, each by name
    std::string problem;               ///< why the folder cannot be read; else empty
    bool is_missing = false;           ///< there is no such folder, which is the problem then
};

/// Reads `folder`: its folders, and the files whose names end in one of `endings`, in any case. Hidden entries are left
/// out.
FolderContent read_folder(const std::filesystem::path& folder, const std::vector<std::string>& endings = {".json"});

/// Whether a person expects `a` before `b`: 2 before 10, and a beside A.
bool comes_before(std::string_view a, std::string_view b);

/// The indices of the entries whose names have `text` in them, whatever the case, in order.
std::vector<std::size_t> entries_with(const std::vector<FolderEntry>& entries, std::string_view text);

}  // namespace batten::ui
