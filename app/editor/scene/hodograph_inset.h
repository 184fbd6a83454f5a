/// The insets with the derivatives C'(u) and C''(u), drawn as curves from the origin's point of view.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// C'(u) over the whole domain, fitted into `box` together with its origin, its control polygon where that has few
/// points, and its point at the view's parameter; the control point of a hovered leg is lit. It breaks where the
/// derivative jumps. The polygon of a rational curve's is that of its Bézier pieces. The frame must have a curve.
void draw_hodograph_inset(CanvasFrame& frame, const render::PixelBox& box);

/// The same with C''(u).
void draw_second_hodograph_inset(CanvasFrame& frame, const render::PixelBox& box);

}  // namespace batten::editor
