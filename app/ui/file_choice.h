/// What is typed and chosen in the file dialog, and what of a folder fits it; knows nothing of drawing.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/ui/folder_list.h"

namespace batten::ui {

struct FileChoice {
    std::vector<std::string> endings{".json"};  ///< of the files that are listed
    std::filesystem::path folder;               ///< where names that are typed begin
    FolderContent listed;                       ///< of `folder`, or of the one that a typed path leads to
    std::string typed;                          ///< what stands in the field
    std::string filter;                         ///< what was typed by hand, "~/curves/wa"
    std::vector<std::size_t> shown;             ///< the entries of `listed` that fit the last word of it, in order
    std::optional<std::size_t> chosen;          ///< index in `shown`
    bool is_led_by_keys = false;                ///< the last choice was made by keys
};

/// The path that `typed` means: from the home folder behind "~", absolute, or from `folder`.
std::filesystem::path meant_path(const std::filesystem::path& folder, const std::string& typed);

/// Shows `folder`, with nothing chosen and `typed` in the field. Returns why it cannot be read, and then changes
/// nothing; else an empty text.
std::string enter_folder(FileChoice& choice, const std::filesystem::path& folder, const std::string& typed);

/// Follows what was typed by hand: the list is that of the folder that it leads to and has what fits. Where
/// `chooses_best` the file of that name is chosen, else the first entry.
void follow_typed(FileChoice& choice, bool chooses_best);

/// Chooses `shown[index]` and puts its name into the field.
void choose(FileChoice& choice, std::size_t index);

/// Moves the choice by so many rows, as far as there are any. From no choice it begins at the first row, or at the last
/// one where it moves up.
void move_choice(FileChoice& choice, std::ptrdiff_t rows);

/// The path of what is chosen; none where nothing is.
std::optional<std::filesystem::path> chosen_path(const FileChoice& choice);

}  // namespace batten::ui
