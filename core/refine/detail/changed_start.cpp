#include "core/refine/detail/changed_start.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/curve/control_box.h"
#include "core/measure/continuity.h"
#include "core/refine/degree.h"
#include "core/refine/detail/start_change.h"

namespace batten::core {

namespace {

// A polygon whose first straight part turns, so that it begins in `start` and no vertex in it becomes a corner.
Result<ChangedStart> turned_polygon(const Curve& polygon, Point start) {
    const auto joints = joint_continuity(polygon);
    const auto corner = std::ranges::find_if(
        joints, [](const JointContinuity& joint) { return joint.kind != JointKind::ends && joint.geometric < 1; });
    const double until = corner == joints.end() ? polygon.domain().upper : corner->u;
    CurveDefinition definition = polygon.definition();
    const Point from = definition.points.front();
    const double length = distance(from, point_at(polygon, until, Side::left));
    const Vector move = start - from;
    for (std::size_t i = 1; i < definition.points.size() && definition.knots[i + 1] < until; ++i)
        definition.points[i] += (1.0 - std::min(1.0, distance(from, definition.points[i]) / length)) * move;
    definition.points.front() = start;
    return Curve::make(std::move(definition)).map([&](const Curve& changed) {
        return ChangedStart{polygon, changed, until};
    });
}

// A smooth joint of curves that meet may not turn on the spot.
Result<void> check_turn(const Curve& curve, const Passing& side, const Jet& wanted) {
    constexpr double nearly_back = std::numbers::pi - 1e-3;
    constexpr double small_gap = 1e-3;
    if (wanted.derivatives.empty()) return {};
    const Meeting meeting = meeting_of(side, passing_at(curve, CurveEnd::start));
    const bool turns_back = meeting.angle && std::abs(*meeting.angle) > nearly_back;
    if (turns_back && meeting.gap <= small_gap * robust_length(control_box(curve).size()))
        return refuse({.code = CurveErrorCode::joint_turns_back});
    return {};
}

}  // namespace

Result<Curve> seen_from_behind(const Curve& curve) {
    CurveDefinition definition = curve.definition();
    std::ranges::reverse(definition.knots);
    for (double& knot : definition.knots) knot = 0.0 - knot;
    std::ranges::reverse(definition.points);
    std::ranges::reverse(definition.weights);
    return Curve::make(std::move(definition));
}

Result<Curve> raised_to(const Curve& curve, int degree) {
    return curve.degree() < degree ? elevate_degree(curve, degree - curve.degree()) : curve;
}

Result<ChangedStart> changed_start(const Curve& curve, const Passing& side, const Jet& wanted, int least_degree) {
    if (begins_as(curve, wanted))
        return raised_to(curve, least_degree).map([&](const Curve& even) {
            return ChangedStart{even, even, curve.domain().lower};
        });
    if (const auto check = check_turn(curve, side, wanted); !check) return refuse(check.error());
    if (wanted.derivatives.empty() && curve.degree() == 1 && least_degree == 1)
        return turned_polygon(curve, wanted.point);
    const int degree = std::max(least_degree, least_degree_of_change(wanted.derivatives.size()));
    const auto even = raised_to(curve, degree);
    if (!even) return refuse(even.error());
    const double until = end_of_change(*even, wanted);
    return with_start(*even, wanted, until).map([&](const Curve& changed) {
        return ChangedStart{*even, changed, until};
    });
}

std::vector<SmoothnessLoss> seen_from_behind(std::vector<SmoothnessLoss> losses) {
    for (SmoothnessLoss& loss : losses) {
        JointContinuity& joint = loss.after;
        joint.u = 0.0 - joint.u;
        std::swap(joint.before, joint.after);
        for (auto* value : {&joint.angle, &joint.before, &joint.after})
            if (*value) *value = -**value;
    }
    return losses;
}

Result<void> check_has_ends(const Curve& curve) {
    if (curve.is_periodic()) return refuse({.code = CurveErrorCode::curve_periodic});
    const bool is_point = robust_length(control_box(curve).size()) == 0.0;
    if (!is_point && is_closed(curve)) return refuse({.code = CurveErrorCode::curve_closed});
    return {};
}

}  // namespace batten::core
