#include "core/edit/detail/offset_polygon.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

namespace batten::core {

namespace {

// Legs that turn back by less than this leave no room for a mitre.
constexpr double least_bend = 1e-12;

// Where the parallels of two legs meet: along the bisector of their normals, |m| = distance / cos(half the turn).
std::optional<Vector> mitre(Vector before, Vector after, double distance) {
    const Vector sum = turned_left(before) + turned_left(after);
    const double size = dot(sum, sum);
    if (!(size > least_bend)) return std::nullopt;
    return 2.0 * distance / size * sum;
}

}  // namespace

Result<Approximation> offset_polygon(const Curve& curve, double distance) {
    assert(curve.degree() == 1);
    const std::span<const Point> points = curve.control_points();
    const std::size_t n = points.size();
    const std::size_t legs = curve.is_periodic() ? n : n - 1;
    // The parameter at which the curve of degree 1 is at point i.
    const auto parameter = [&](std::size_t i) { return curve.knots()[i + 1]; };
    std::vector<Vector> directions;
    for (std::size_t i = 0; i < legs; ++i) {
        const Vector leg = points[(i + 1) % n] - points[i];
        const double length = robust_length(leg);
        if (!(length > 0.0)) return refuse({.code = CurveErrorCode::curve_stands_still, .value = parameter(i)});
        directions.push_back(leg / length);
    }
    CurveDefinition definition = curve.definition();
    for (std::size_t i = 0; i < n; ++i) {
        const bool is_start = i == 0 && !curve.is_periodic();
        const bool is_end = i + 1 == n && !curve.is_periodic();
        const Vector before = directions[is_start ? 0 : (i + legs - 1) % legs];
        const Vector after = directions[is_end ? legs - 1 : i];
        const auto move = mitre(before, after, distance);
        if (!move) return refuse({.code = CurveErrorCode::curve_has_corner, .value = parameter(i)});
        definition.points[i] += *move;
    }
    double error = 0.0;
    for (std::size_t i = 0; i < legs; ++i) {
        const Vector leg = definition.points[(i + 1) % n] - definition.points[i];
        if (!(dot(leg, directions[i]) > 0.0)) return refuse({.code = CurveErrorCode::leg_vanishes, .index = i});
        for (const std::size_t end : {i, (i + 1) % n}) {
            const double found = dot(definition.points[end] - points[end], turned_left(directions[i]));
            error = std::max(error, std::abs(found - distance));
        }
    }
    return Curve::make(std::move(definition)).map([&](Curve result) {
        return Approximation{std::move(result), error};
    });
}

}  // namespace batten::core
