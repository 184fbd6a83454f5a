/// The frame of every dialog: a dimmed window, a panel in it with a title and a cross.
#pragma once

#include <optional>
#include <string>

#include "app/ui/panels.h"

namespace batten::ui {

struct DialogFrame {
    std::string title;
    glm::dvec2 size{480.0, 320.0};      ///< in design pixels; made smaller where the window is
    bool is_at_top = false;             ///< near the window's upper edge instead of in its middle
    std::optional<Rectangle> beside{};  ///< from the upper left corner of this place, with nothing dimmed
    bool closes_on_outside = true;      ///< a click beside it closes it
};

/// Begins the dialog over `window`; end_dialog() must follow. Returns whether the user wants it closed: by the cross,
/// by Escape or by a click beside it.
bool begin_dialog(const PanelContext& context, const Rectangle& window, const DialogFrame& frame);
void end_dialog();

/// What of a dialog's width is its two margins each, and what of its height is not its contents.
float dialog_padding_px(const PanelContext& context);
float dialog_head_px(const PanelContext& context);

/// The sentence of an error, wrapped, as part of a dialog; nothing for an empty one.
void draw_dialog_error(const PanelContext& context, const std::string& sentence);

}  // namespace batten::ui
