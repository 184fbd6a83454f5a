#include "core/measure/meeting.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/measure/continuity.h"
#include "core/measure/detail/one_side.h"

namespace batten::core {

namespace {

constexpr double change_tolerance = 1e-5;

// Both curves are rounded, and what is computed from them is, too.
constexpr double more_noise = 8.0;

Box box_of_piece(const Curve& curve, double u, Side side) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t span = curve.knots().span_at(curve.knots().into_domain(u, side), side);
    const auto points = curve.control_points();
    Box box;
    for (std::size_t i = span - p; i <= span; ++i) box.include(points[i % points.size()]);
    return box;
}

// d curvature / ds = (det(t, C''') - 3 det(t, C'') (t . C'') / v) / v^3 for the unit tangent t and the speed v.
std::optional<double> change_of(const OneSide& side) {
    if (!side.curvature) return std::nullopt;
    const double speed = robust_length(side.jet[1]);
    const Vector tangent = side.jet[1] / speed;
    const double change =
        (cross(tangent, side.jet[3]) - 3.0 * cross(tangent, side.jet[2]) * (dot(tangent, side.jet[2]) / speed)) /
        speed / speed / speed;
    return std::isfinite(change) ? std::optional(change) : std::nullopt;
}

}  // namespace

Passing passing_at(const Curve& curve, double u, Side side) {
    const Box box = box_of_piece(curve, u, side);
    const Point origin = middle(box.lower, box.upper);
    const OneSide seen = look_at_side(curve, u, side, origin, rounding_in(box));
    Passing passing{.point = point_at(curve, u, side),
                    .direction = seen.tangent,
                    .curvature = seen.curvature,
                    .change = change_of(seen)};
    const double speed = robust_length(seen.jet[1]);
    if (!(speed > 0.0)) return passing;
    const double bend = robust_length(seen.jet[2]) / speed;
    passing.curvature_noise = seen.noise[2] / speed / speed;
    passing.change_noise = (seen.noise[3] + 6.0 * bend * seen.noise[2]) / speed / speed / speed;
    return passing;
}

Passing passing_at(const Curve& curve, CurveEnd end) {
    return passing_at(curve, parameter_of(curve.domain(), end), end == CurveEnd::start ? Side::right : Side::left);
}

Passing passing_beyond(const Curve& curve, CurveEnd end) {
    const Passing passing = passing_at(curve, end);
    return end == CurveEnd::end ? passing : run_back(passing);
}

Passing run_back(Passing passing) {
    if (passing.direction) passing.direction = -*passing.direction;
    if (passing.curvature) passing.curvature = -*passing.curvature;
    return passing;
}

Meeting meeting_of(const Passing& before, const Passing& after) {
    Meeting meeting{.gap = robust_length(after.point - before.point),
                    .before = before.curvature,
                    .after = after.curvature,
                    .change_before = before.change,
                    .change_after = after.change,
                    .curvature_noise = before.curvature_noise + after.curvature_noise,
                    .change_noise = before.change_noise + after.change_noise};
    if (before.direction && after.direction) meeting.angle = angle_between(*before.direction, *after.direction);
    return meeting;
}

Meeting run_back(Meeting meeting) {
    std::swap(meeting.before, meeting.after);
    std::swap(meeting.change_before, meeting.change_after);
    for (auto* value : {&meeting.angle, &meeting.before, &meeting.after})
        if (*value) *value = -**value;
    return meeting;
}

int smoothness_of(const Meeting& meeting, double size) {
    const ContinuityTolerances tolerances;
    if (!(meeting.gap <= tolerances.position * size)) return -1;
    if (!meeting.angle || !(std::abs(*meeting.angle) <= tolerances.angle)) return 0;
    if (!meeting.before || !meeting.after) return 1;
    const double bend = std::max({std::abs(*meeting.before), std::abs(*meeting.after), 1.0 / size});
    const double jump = std::abs(*meeting.after - *meeting.before);
    if (!(jump <= tolerances.curvature * bend + more_noise * meeting.curvature_noise)) return 1;
    if (!meeting.change_before || !meeting.change_after) return 2;
    const double change = std::max({std::abs(*meeting.change_before), std::abs(*meeting.change_after), bend * bend});
    const double jump_of_change = std::abs(*meeting.change_after - *meeting.change_before);
    return jump_of_change <= change_tolerance * change + more_noise * meeting.change_noise ? 3 : 2;
}

}  // namespace batten::core
