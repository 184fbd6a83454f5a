/// Marks of what is dragged on the canvas to change a shape.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// A square or a disc, larger and filled while the pointer is over it. The radius is in design pixels.
void draw_grip(CanvasFrame& frame, glm::dvec2 place_px, render::MarkerShape shape, double radius, bool is_lit);

}  // namespace batten::editor
