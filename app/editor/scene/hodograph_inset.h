/// The inset with the derivative C'(u), drawn as a curve from the origin's point of view.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// C'(u) over the whole domain, fitted into `box` together with its origin, and its point at the view's parameter. It
/// breaks where the derivative jumps. The frame must have a curve.
void draw_hodograph_inset(CanvasFrame& frame, const render::PixelBox& box);

}  // namespace batten::editor
