/// A picture within a panel, drawn by Dear ImGui.
#pragma once

#include "app/ui/fonts.h"
#include "render/draw_list.h"

struct ImDrawList;

namespace batten::ui {

/// Draws the polylines, fills, markers and labels of `picture` with its upper left corner at `corner_px` of the window.
/// Ink is left out: pictures in panels have none.
void draw_picture(ImDrawList* list, const render::DrawList& picture, glm::vec2 corner_px, const Fonts& fonts);

}  // namespace batten::ui
