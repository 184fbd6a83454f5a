/// What the pointer is over in inspector and cards, and asking for it to light up; the pictures ask for themselves.
#pragma once

#include "app/ui/panels.h"

namespace batten::ui {

/// Begins a frame in which nothing was pointed at yet.
void begin_panel_hover(const PanelContext& context);

/// What the pointer is over in this frame; the last wish of a frame counts.
void wish_hover(const PanelContext& context, const editor::Hover& hover);

/// Whether the pointer is in a panel that has just been drawn.
void note_panel_hover(const PanelContext& context, bool is_inside);

/// Asks for what the pointer is over, and for nothing once it has left the panels for something else than a picture.
void settle_panel_hover(const PanelContext& context);

}  // namespace batten::ui
