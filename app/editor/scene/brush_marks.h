/// The brush over the canvas: its circle, the points that it holds, and what it paints.
#pragma once

#include "app/editor/pointer/canvas_mode.h"
#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// The circle; the control points that it holds, the more strongly tinted the more they take of a move; and the part of
/// the curve that is painted.
void draw_brush(CanvasFrame& frame, const Brushing& mode);

}  // namespace batten::editor
