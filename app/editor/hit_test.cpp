#include "app/editor/hit_test.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "app/editor/weight_ring.h"
#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/nearest.h"

namespace batten::editor {
namespace {

/// How near the pointer must be, in design pixels.
namespace reach {
constexpr double point = 9.0;  ///< C(u) and control points
constexpr double ring = 4.0;
constexpr double knot = 8.0;
constexpr double curve = 6.0;
constexpr double leg = 5.0;
}  // namespace reach

/// Keeps the nearest of the things offered that are within reach, the first of equally near ones.
class Nearest {
  public:
    explicit Nearest(double reach_px) : distance_(reach_px) {}

    void offer(const Hover& thing, double distance) {
        if (!(distance <= distance_) || (found_ && distance == distance_)) return;
        distance_ = distance;
        found_ = thing;
    }
    const std::optional<Hover>& found() const { return found_; }

  private:
    double distance_;
    std::optional<Hover> found_;
};

double distance_to_segment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 along = b - a;
    const double squared = glm::dot(along, along);
    const double t = squared > 0.0 ? std::clamp(glm::dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + t * along);
}

/// The pointer on the canvas and what it needs to find things.
struct CanvasPointer {
    const EditorState& state;
    glm::dvec2 position_px;

    const render::Camera& camera() const { return state.view.camera; }
    double px(double design_px) const { return design_px * state.view.interface_scale; }
    bool shows(Overlay overlay) const { return state.view.overlays.is_shown(overlay); }
    double distance_to(core::Point world) const {
        return glm::distance(position_px, render::screen_from_world(camera(), world));
    }

    /// The nearest point of `curve`, if it is within reach.
    std::optional<core::CurveSample> on_curve(const core::Curve& curve) const {
        if (!is_near_control_box(curve)) return std::nullopt;
        const core::CurveSample sample =
            core::nearest_point(curve, core::Point(render::world_from_screen(camera(), position_px)));
        if (distance_to(sample.point) > px(reach::curve)) return std::nullopt;
        return sample;
    }

    bool is_near_control_box(const core::Curve& curve) const {
        const core::Box box = core::control_box(curve);
        const glm::dvec2 left_top = render::screen_from_world(camera(), {box.lower.x, box.upper.y});
        const glm::dvec2 right_bottom = render::screen_from_world(camera(), {box.upper.x, box.lower.y});
        const double margin = px(reach::curve);
        return position_px.x >= left_top.x - margin && position_px.x <= right_bottom.x + margin &&
               position_px.y >= left_top.y - margin && position_px.y <= right_bottom.y + margin;
    }
};

/// C(u) or a control point, whichever is nearer; the point where they coincide, because at the end of a clamped curve
/// it could not be grabbed otherwise.
std::optional<Hover> hit_parameter_or_points(const CanvasPointer& pointer, const core::Curve& curve) {
    Nearest nearest(pointer.px(reach::point));
    const std::size_t point_count = pointer.shows(Overlay::polygon) ? curve.control_points().size() : 0;
    for (std::size_t i = 0; i < point_count; ++i)
        nearest.offer(HoveredPoint{i}, pointer.distance_to(curve.control_points()[i]));
    nearest.offer(HoveredParameter{}, pointer.distance_to(core::point_at(curve, pointer.state.parameter())));
    return nearest.found();
}

std::optional<Hover> hit_rings(const CanvasPointer& pointer, const core::Curve& curve) {
    Nearest nearest(pointer.px(reach::ring));
    for (std::size_t i = 0; i < curve.control_points().size(); ++i)
        if (const auto radius = weight_ring_radius_px(pointer.state, i))
            nearest.offer(HoveredWeightRing{i}, std::abs(pointer.distance_to(curve.control_points()[i]) - *radius));
    return nearest.found();
}

std::optional<Hover> hit_knots(const CanvasPointer& pointer, const core::Curve& curve) {
    Nearest nearest(pointer.px(reach::knot));
    const std::span<const double> stored = curve.knots().stored();
    for (std::size_t i = 0; i < stored.size(); ++i) {
        const bool is_topmost = i + 1 == stored.size() || stored[i + 1] != stored[i];
        if (!is_topmost || !curve.domain().contains(stored[i])) continue;
        nearest.offer(HoveredKnot{i}, pointer.distance_to(core::point_at(curve, stored[i])));
    }
    return nearest.found();
}

std::optional<Hover> hit_legs(const CanvasPointer& pointer, const core::Curve& curve) {
    Nearest nearest(pointer.px(reach::leg));
    const std::span<const core::Point> points = curve.control_points();
    const std::size_t count = curve.is_periodic() ? points.size() : points.size() - 1;
    for (std::size_t i = 0; i < count; ++i)
        nearest.offer(HoveredLeg{i}, distance_to_segment(
                                         pointer.position_px, render::screen_from_world(pointer.camera(), points[i]),
                                         render::screen_from_world(pointer.camera(), points[(i + 1) % points.size()])));
    return nearest.found();
}

std::optional<Hover> hit_active_curve(const CanvasPointer& pointer, const core::Curve& curve) {
    if (const auto hit = hit_parameter_or_points(pointer, curve)) return hit;
    if (pointer.shows(Overlay::polygon))
        if (const auto hit = hit_rings(pointer, curve)) return hit;
    if (pointer.shows(Overlay::knots))
        if (const auto hit = hit_knots(pointer, curve)) return hit;
    if (const auto sample = pointer.on_curve(curve)) return HoveredCurve{sample->u};
    if (pointer.shows(Overlay::polygon)) return hit_legs(pointer, curve);
    return std::nullopt;
}

Hover hit_other_curves(const CanvasPointer& pointer) {
    Nearest nearest(pointer.px(reach::curve));
    const core::Document& document = pointer.state.shown();
    for (std::size_t i = 0; i < document.curves.size(); ++i) {
        if (i == document.active || !document.curves[i].visible) continue;
        if (const auto sample = pointer.on_curve(*document.curves[i].curve))
            nearest.offer(HoveredOtherCurve{i}, pointer.distance_to(sample->point));
    }
    return nearest.found().value_or(HoveredNothing{});
}

}  // namespace

Hover hit_canvas(const EditorState& state, glm::dvec2 position_px) {
    const CanvasPointer pointer{state, position_px};
    const core::DocumentCurve* active = state.shown().active_curve();
    if (active != nullptr && active->visible)
        if (const auto hit = hit_active_curve(pointer, *active->curve)) return *hit;
    return hit_other_curves(pointer);
}

}  // namespace batten::editor
