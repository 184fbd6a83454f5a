/// The derivatives at the ends of the curve, on the canvas.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// C' at each end as an arrow along the leg there, C'' dashed, both named; nothing where no control point is the end.
/// The frame must have a curve.
void draw_end_marks(CanvasFrame& frame);

}  // namespace batten::editor
