/// The labels of pictures, set by Dear ImGui.
#pragma once

#include "app/ui/fonts.h"
#include "render/draw_list.h"

struct ImDrawList;

namespace batten::ui {

/// Draws one label of a picture whose upper left corner is at `corner_px` of the window.
void draw_label(ImDrawList* list, const render::Label& label, glm::vec2 corner_px, const Fonts& fonts);

}  // namespace batten::ui
