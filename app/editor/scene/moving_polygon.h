/// The control polygon while a knot comes in: corners that are cut off go to the new points.
#pragma once

#include "app/editor/derived/cut_polygon.h"
#include "app/editor/scene/shown_points.h"

namespace batten::editor {

/// The line through the corners of `moving`. The frame must have the curve with the knot in it.
void draw_moving_line(CanvasFrame& frame, const MovingPolygon& moving);

/// The `points` of that curve where they are on their way, both parts of those that are one at the end.
ShownPoints moved_points(const CanvasFrame& frame, const ShownPoints& points, const MovingPolygon& moving);

/// Draws the control points of `moving`, and their names, over the picture in `list` that is around it. In the first
/// half of the way corners are called as before, both parts of one alike, in the second half as after it; names that
/// change fade out and in between. The names stay off what is drawn, and those without room are noted as unplaced.
/// Where the points are too dense for their size, only those that matter are drawn and named.
void draw_moving_points(CanvasFrame& frame, const render::DrawList& list, MovingPolygon moving);

}  // namespace batten::editor
