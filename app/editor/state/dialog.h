/// What may cover the window.
#pragma once

#include <array>

#include "core/base/names.h"

namespace batten::editor {

/// What covers the window and asks for an answer.
enum class Dialog {
    none,
    welcome,
    open_file,
    save_file,
    open_table,
    open_picture,
    unsaved_changes,
    changed_file,  ///< another program changed the file that is to be saved
    recovery,      ///< documents that a session left unsaved
    command_palette,
    command_form,
    key_sheet,
    about,
    at_work  ///< a command that takes long, and can be canceled
};

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::Dialog> {
    using enum editor::Dialog;
    static constexpr std::array table{Named{none, "none", ""},
                                      Named{welcome, "welcome", "Welcome"},
                                      Named{open_file, "open-file", "Open"},
                                      Named{save_file, "save-file", "Save"},
                                      Named{open_table, "open-table", "Open table"},
                                      Named{open_picture, "open-picture", "Add picture"},
                                      Named{unsaved_changes, "unsaved-changes", "Unsaved changes"},
                                      Named{changed_file, "changed-file", "The file has changed"},
                                      Named{recovery, "recovery", "Recover"},
                                      Named{command_palette, "command-palette", "Commands"},
                                      Named{command_form, "command-form", "Command"},
                                      Named{key_sheet, "key-sheet", "Keys and gestures"},
                                      Named{about, "about", "About Batten"},
                                      Named{at_work, "at-work", "At work"}};
};

}  // namespace batten::core
