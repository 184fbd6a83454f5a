/// Farin's points on the legs of the control polygon.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// Draws the Farin points of the legs that are seen, with their names while these are few; none but the hovered one
/// where they are more than the picture can hold apart. The frame must have a curve.
void draw_farin_points(CanvasFrame& frame);

}  // namespace batten::editor
