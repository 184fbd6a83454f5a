/// The lifted curve in space over the plane w = 1, where its shadow lies.
#pragma once

#include "app/editor/derived/lifted_stage.h"
#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// Draws into `box`: the rays from the origin through the control points, the plane with the curve and its polygon, the
/// lifted curve and its polygon, and the points at the view's parameter. What lies beyond the plane is seen through it.
/// The frame must have a curve. Cost: the samples, which are kept, and at most 100 control points.
void draw_lifted_picture(CanvasFrame& frame, const render::PixelBox& box);

/// The same without the panel and its title, for a picture of its own, which shows of the polygon, the points and the
/// parameter what the view does, and the names of the points where it shows labels.
void draw_lifted_curve(CanvasFrame& frame, const render::PixelBox& box);

}  // namespace batten::editor
