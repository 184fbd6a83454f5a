/// A line and its crossings with the curve and with its control polygon.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// The line, below the curve.
void draw_probe_line(CanvasFrame& frame);

/// Discs where it crosses the curve, rings where it only touches it, squares where it crosses the polygon, a thick
/// stroke along a straight piece in it, and the handles at its two points.
void draw_line_crossings(CanvasFrame& frame);

}  // namespace batten::editor
