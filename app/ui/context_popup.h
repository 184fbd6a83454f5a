/// The menu that a right click opens.
#pragma once

#include "app/ui/panels.h"

namespace batten::ui {

/// Selects what `target` names and opens the menu for it, where the pointer is.
void open_context_menu(const PanelContext& context, const editor::MenuTarget& target);

/// Whether the right button was released in this frame, which is when a menu opens.
bool asks_for_menu();

/// Draws the menu while it is open.
void draw_context_menu(const PanelContext& context);

}  // namespace batten::ui
