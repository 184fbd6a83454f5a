/// The control points: discs in their colors, selection, weight rings.
#pragma once

#include "app/editor/scene/shown_points.h"

namespace batten::editor {

/// The control points where they are too dense for their size, without outlines, to lie below the curve.
void draw_dense_points(CanvasFrame& frame, const ShownPoints& points);

/// The control points in full size; the first one is boxed, which tells the direction of the curve. The frame must have
/// a curve.
void draw_control_points(CanvasFrame& frame, const ShownPoints& points);

}  // namespace batten::editor
