/// The rows of the file dialog: folders and files.
#pragma once

#include <cstddef>
#include <optional>

#include "app/ui/panels.h"

namespace batten::ui {

/// Brings the chosen row into sight of the current window, whose rows are `pitch_px` high.
void scroll_to_choice(FileDialogState& dialog, float pitch_px);

/// Draws the rows that are in sight; returns which one was clicked, if one was.
std::optional<std::size_t> draw_file_rows(const PanelContext& context, float pitch_px);

}  // namespace batten::ui
