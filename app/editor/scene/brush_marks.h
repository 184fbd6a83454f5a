/// The brush over the canvas: its circle, the points that it holds, and what it paints.
#pragma once

#include "app/editor/pointer/canvas_mode.h"
#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// The circle, and the control points that it holds, the more strongly tinted the more they take of a move.
void draw_brush(CanvasFrame& frame, const Brushing& mode);

/// Lights the part of the active curve that the mode has painted.
void light_painted(CanvasFrame& frame, const CanvasMode& mode);

}  // namespace batten::editor
