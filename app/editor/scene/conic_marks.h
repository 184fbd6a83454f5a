/// The conic of the quadratic piece at the parameter: the rest of it, its shoulder and its angle.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// The conic beyond the arc, faintly, and the triangle of its three points. Nothing where the degree is not 2 or the
/// piece is straight. The frame must have a curve.
void draw_conic_below(CanvasFrame& frame);

/// The middle M of the chord, the shoulder X and the way from M to the corner that it divides; half the angle at the
/// corner where the legs are equally long. Likewise.
void draw_conic_above(CanvasFrame& frame);

}  // namespace batten::editor
