/// Vectors as arrows.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// An arrow from `tail` to `tip`; nothing where it has no length.
void draw_arrow(Pen& pen, glm::dvec2 tail, glm::dvec2 tip, const Stroke& stroke);

/// The same on the canvas, where labels stay off it.
void draw_arrow(CanvasFrame& frame, glm::dvec2 tail, glm::dvec2 tip, const Stroke& stroke);

/// By what velocities are multiplied to be drawn, so that of a Bézier curve they are the legs at its ends. It does not
/// change while knots inside the domain move.
double velocity_scale(const core::Curve& curve);

/// The same for accelerations, in degree 2 and above: second differences of the polygon.
double acceleration_scale(const core::Curve& curve);

/// A vector of the world in pixels.
glm::dvec2 vector_in_picture(const CanvasFrame& frame, core::Vector v);

}  // namespace batten::editor
