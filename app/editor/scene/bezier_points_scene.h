/// The Bézier points of the pieces with their names.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// For some twenty pieces in the picture, beginning with the one at u, their polygons and points: filled where these
/// are control points already, because the knots at both ends have multiplicity p.
void draw_bezier_points(CanvasFrame& frame);

}  // namespace batten::editor
