#include "app/editor/hit_test.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <vector>

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

/// The active curve on the canvas, with its control points in pixels.
class ActiveCurve {
  public:
    ActiveCurve(const CanvasPointer& pointer, const core::Curve& curve) : pointer_(pointer), curve_(curve) {
        points_px_.reserve(curve.control_points().size());
        for (const core::Point& point : curve.control_points())
            points_px_.push_back(render::screen_from_world(pointer.camera(), point));
    }

    std::optional<Hover> hit() const;

  private:
    std::optional<Hover> hit_parameter_or_points() const;
    std::optional<Hover> hit_rings() const;
    std::optional<Hover> hit_knots() const;
    std::optional<Hover> hit_curve() const;
    std::optional<Hover> hit_legs() const;

    double distance_to(std::size_t point) const { return glm::distance(pointer_.position_px, points_px_[point]); }
    bool may_reach(std::size_t span, double design_px) const;
    bool may_reach_any_span(double design_px) const;
    std::size_t last_span() const { return curve_.knots().size() - static_cast<std::size_t>(curve_.degree()) - 2; }

    const CanvasPointer& pointer_;
    const core::Curve& curve_;
    std::vector<glm::dvec2> points_px_;
};

/// Whether the curve over a span, which lies among the control points that it depends on, may be so near.
bool ActiveCurve::may_reach(std::size_t span, double design_px) const {
    constexpr double rounding_px = 1.0;
    const double reach = pointer_.px(design_px) + rounding_px;
    bool is_right = true;
    bool is_left = true;
    bool is_below = true;
    bool is_above = true;
    for (std::size_t i = span - static_cast<std::size_t>(curve_.degree()); i <= span; ++i) {
        const glm::dvec2 away = points_px_[i % points_px_.size()] - pointer_.position_px;
        is_right = is_right && away.x > reach;
        is_left = is_left && away.x < -reach;
        is_below = is_below && away.y > reach;
        is_above = is_above && away.y < -reach;
    }
    return !(is_right || is_left || is_below || is_above);
}

bool ActiveCurve::may_reach_any_span(double design_px) const {
    for (auto span = static_cast<std::size_t>(curve_.degree()); span <= last_span(); ++span)
        if (may_reach(span, design_px)) return true;
    return false;
}

/// C(u) or a control point, whichever is nearer; the point where they coincide, because at the end of a clamped curve
/// it could not be grabbed otherwise.
std::optional<Hover> ActiveCurve::hit_parameter_or_points() const {
    Nearest nearest(pointer_.px(reach::point));
    const std::size_t point_count = pointer_.shows(Overlay::polygon) ? points_px_.size() : 0;
    for (std::size_t i = 0; i < point_count; ++i) nearest.offer(HoveredPoint{i}, distance_to(i));
    nearest.offer(HoveredParameter{}, pointer_.distance_to(core::point_at(curve_, pointer_.state.parameter())));
    return nearest.found();
}

std::optional<Hover> ActiveCurve::hit_rings() const {
    Nearest nearest(pointer_.px(reach::ring));
    for (std::size_t i = 0; i < points_px_.size(); ++i)
        if (const auto radius = weight_ring_radius_px(pointer_.state, i))
            nearest.offer(HoveredWeightRing{i}, std::abs(distance_to(i) - *radius));
    return nearest.found();
}

std::optional<Hover> ActiveCurve::hit_knots() const {
    Nearest nearest(pointer_.px(reach::knot));
    const std::span<const double> stored = curve_.knots().stored();
    const std::size_t offset = curve_.knots().stored_offset();
    for (std::size_t i = 0; i < stored.size(); ++i) {
        const bool is_topmost = i + 1 == stored.size() || stored[i + 1] != stored[i];
        if (!is_topmost || !curve_.domain().contains(stored[i])) continue;
        // The topmost of a stack begins a span, but at the end of the domain.
        if (offset + i <= last_span() && !may_reach(offset + i, reach::knot)) continue;
        nearest.offer(HoveredKnot{i}, pointer_.distance_to(core::point_at(curve_, stored[i])));
    }
    return nearest.found();
}

std::optional<Hover> ActiveCurve::hit_curve() const {
    if (!may_reach_any_span(reach::curve)) return std::nullopt;
    const auto sample = pointer_.on_curve(curve_);
    return sample ? std::optional<Hover>(HoveredCurve{sample->u}) : std::nullopt;
}

std::optional<Hover> ActiveCurve::hit_legs() const {
    Nearest nearest(pointer_.px(reach::leg));
    const std::size_t count = curve_.is_periodic() ? points_px_.size() : points_px_.size() - 1;
    for (std::size_t i = 0; i < count; ++i)
        nearest.offer(HoveredLeg{i}, distance_to_segment(pointer_.position_px, points_px_[i],
                                                         points_px_[(i + 1) % points_px_.size()]));
    return nearest.found();
}

std::optional<Hover> ActiveCurve::hit() const {
    if (const auto found = hit_parameter_or_points()) return found;
    if (pointer_.shows(Overlay::polygon))
        if (const auto found = hit_rings()) return found;
    if (pointer_.shows(Overlay::knots))
        if (const auto found = hit_knots()) return found;
    if (const auto found = hit_curve()) return found;
    if (pointer_.shows(Overlay::polygon)) return hit_legs();
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
        if (const auto hit = ActiveCurve(pointer, *active->curve).hit()) return *hit;
    return hit_other_curves(pointer);
}

}  // namespace batten::editor
