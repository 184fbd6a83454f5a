/// The insets with the derivatives C'(u) and C''(u), drawn as curves from the origin's point of view.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// Hodographs of more control points are drawn without their polygon.
inline constexpr std::size_t most_hodograph_points = 400;

/// Where in the inset `box` the picture is, with `scale` pixels for a design pixel.
render::PixelBox hodograph_area(const render::PixelBox& box, double scale);

/// Whether control point i of `hodograph`, the derivative of `curve` of that order, is a multiple of the difference of
/// that order that begins with point i of `curve`.
bool has_differences(const core::Curve& hodograph, const core::Curve& curve, std::size_t order);

/// C'(u) over the whole domain, fitted into `box` together with its origin, its control polygon where that has few
/// points, and its point at the view's parameter; the control point of a hovered leg is lit, and the place of a hovered
/// parameter. It breaks where the derivative jumps. The polygon of a rational curve's is that of its Bézier pieces. The
/// frame must have a curve.
void draw_hodograph_inset(CanvasFrame& frame, const render::PixelBox& box);

/// The same with C''(u).
void draw_second_hodograph_inset(CanvasFrame& frame, const render::PixelBox& box);

}  // namespace batten::editor
