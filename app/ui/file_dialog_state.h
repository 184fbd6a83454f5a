/// What the file dialog remembers between frames.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/ui/file_choice.h"
#include "exchange/format.h"

namespace batten::ui {

/// What the file dialog shows and asks.
struct FileDialogState {
    bool was_open = false;
    FileChoice choice;
    std::string suggested_name;                       ///< where a document is saved
    std::optional<exchange::Format> format;           ///< that was chosen; none: by the ending
    bool lists_formats = false;                       ///< in the last frame, so that Escape closes that list alone
    bool draws_svg = false;                           ///< a name that ends in .svg was chosen as that of a figure
    std::optional<std::filesystem::path> to_replace;  ///< the file that saving would overwrite, asked about
    bool is_replacing = false;                        ///< the answer that keys chose; at first to keep the file
    std::string problem;                              ///< why the folder cannot be shown
    bool takes_focus = false;                         ///< the name field becomes the active one in the next frame
    bool shows_choice = false;    ///< the text was changed by the dialog, which the field must follow
    bool follows_choice = false;  ///< the list scrolls to the chosen row
};

}  // namespace batten::ui
