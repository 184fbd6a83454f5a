/// The control points: discs in their colors, selection, weight rings.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// All control points; the first one is boxed, which tells the direction of the curve. The frame must have a curve.
void draw_control_points(CanvasFrame& frame);

}  // namespace batten::editor
