/// The pictures on the buttons of the tool bar, as strokes.
#pragma once

#include "app/editor/command_spec.h"
#include "render/color.h"

struct ImDrawList;

namespace batten::ui {

/// Where and how an icon is drawn; `size_px` is the side of the square around (x, y).
struct IconPlace {
    float x_px = 0.0F;
    float y_px = 0.0F;
    float size_px = 16.0F;
};

/// Draws the icon of the command that `spec` describes; nothing for a command without one.
void draw_icon(ImDrawList* list, const editor::CommandSpec& spec, const IconPlace& place, render::Color color);

}  // namespace batten::ui
