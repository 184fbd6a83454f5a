/// What the views of uniform cubics draw on the canvas; nothing for other curves.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// The triangles and medians of the joints about u; of the joint in focus its parallelogram, too.
void draw_anticentroid_triangles(CanvasFrame& frame);

/// The joints, and of the one in focus the tangent and names.
void draw_anticentroids(CanvasFrame& frame);

/// The ends of the segment at u with the tangents there, and lightly those of the segments about it.
void draw_ferguson_form(CanvasFrame& frame);

/// How the curve would go on at its ends with double, triple and phantom vertices, and the phantom ones; joints at
/// equal and collinear vertices, and straight segments.
void draw_end_vertices(CanvasFrame& frame);

/// The last joint of one curve and the first of the other, with their derivatives.
void draw_joined_cubics(CanvasFrame& frame);

}  // namespace batten::editor
