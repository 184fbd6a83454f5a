/// How the control polygon comes to the curve.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// The color of the polygon after `round` rounds, 0 to 3.
render::Color round_color(const Theme& theme, std::size_t round);

/// The polygons after one, two and three rounds of midpoint insertion, below the curve.
void draw_polygon_rounds(CanvasFrame& frame);

/// From each corner in the picture a line to the point of the curve at its Greville abscissa, where the distance is
/// told; none where they are too many.
void draw_polygon_distances(CanvasFrame& frame);

}  // namespace batten::editor
