/// The control polygons of the curves that are not active.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// Polygons and points of the visible curves beside the active one, in their order and as long as they have few points
/// together; with the overlay of labels named by the letters that follow that of the active curve: Q_{0}, Q_{1}, then
/// R_{0}...
void draw_other_polygons(CanvasFrame& frame);

}  // namespace batten::editor
