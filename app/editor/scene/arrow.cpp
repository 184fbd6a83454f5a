#include "app/editor/scene/arrow.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace batten::editor {

namespace {

constexpr double head_length = 10.0;
constexpr double head_width = 7.0;
constexpr double most_head = 0.6;  // of the arrow
constexpr double least_length = 0.5;

}  // namespace

void draw_arrow(Pen& pen, glm::dvec2 tail, glm::dvec2 tip, const Stroke& stroke) {
    const double length = glm::distance(tail, tip);
    if (!(length > least_length) || !std::isfinite(length)) return;
    const glm::dvec2 along = (tip - tail) / length;
    const glm::dvec2 across{-along.y, along.x};
    const double head = std::min(pen.px(head_length + stroke.width), most_head * length);
    const double half = 0.5 * head * (head_width / head_length);
    pen.segment(tail, tip - 0.8 * head * along, stroke);
    pen.fill({tip, tip - head * along + half * across, tip - head * along - half * across}, stroke.color);
}

void draw_arrow(CanvasFrame& frame, glm::dvec2 tail, glm::dvec2 tip, const Stroke& stroke) {
    draw_arrow(frame.pen, tail, tip, stroke);
    frame.marks.push_back(tip);
}

double velocity_scale(const core::Curve& curve) {
    const auto points = static_cast<double>(curve.control_points().size());
    const double spans = curve.is_periodic() ? points : points - curve.degree();
    return curve.domain().length() / spans / curve.degree();
}

double acceleration_scale(const core::Curve& curve) {
    const double p = curve.degree();
    const double velocities = velocity_scale(curve);
    return velocities * velocities * p / (p - 1.0);
}

glm::dvec2 vector_in_picture(const CanvasFrame& frame, core::Vector v) {
    const double scale = frame.state.view.camera.scale;
    return {scale * v.x, -scale * v.y};
}

}  // namespace batten::editor
