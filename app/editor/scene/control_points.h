/// The control points: discs in their colors, selection, weight rings.
#pragma once

#include "app/editor/scene/shown_points.h"

namespace batten::editor {

/// The control points where they are too dense for their size, without outlines, to lie below the curve.
void draw_dense_points(CanvasFrame& frame, const ShownPoints& points);

/// The control points in full size; the first one is boxed, which tells the direction of the curve. The frame must have
/// a curve.
void draw_control_points(CanvasFrame& frame, const ShownPoints& points);

/// Control point `i` in full size wherever it is on its way, with the ring of `weight`; the first one boxed.
void draw_moving_point(CanvasFrame& frame, glm::dvec2 place, std::size_t i, double weight);

}  // namespace batten::editor
