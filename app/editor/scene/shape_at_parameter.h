/// How the curve goes on at the view's parameter: tangent, normal and osculating circle.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// The osculating circle with its radius; at a knot where the curvature jumps that from the left as well, dashed.
void draw_osculating_circle(CanvasFrame& frame);

/// The unit tangent and normal as arrows of one length on the tangent line; at a corner the tangent from the left as
/// well, dashed.
void draw_tangent_and_normal(CanvasFrame& frame);

}  // namespace batten::editor
