/// The choice of a format in the file dialog.
#pragma once

#include <string>
#include <vector>

#include "app/ui/panels.h"

namespace batten::ui {

/// Whether the dialog is about files with curves, whose format can be chosen.
bool asks_for_format(editor::Dialog dialog);

/// The endings of all files with curves, which can be read, or written.
std::vector<std::string> endings_of_curves(bool is_saving);

/// The field, at the lower left of the dialog.
void draw_format_choice(const PanelContext& context);

/// Whether what the canvas shows is to be drawn as a figure, instead of curves to be written.
bool draws_figure(const PanelContext& context);

/// A sentence on what the chosen format, or that of the name, does to curves; empty for Batten's own, and in dialogs
/// that are not about curves.
std::string format_note(const PanelContext& context);
void draw_format_note(const PanelContext& context);

}  // namespace batten::ui
