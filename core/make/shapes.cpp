#include "core/make/shapes.h"

#include <array>
#include <utility>

#include "core/base/detail/angle.h"
#include "core/curve/knot_kinds.h"

namespace batten::core {

namespace {

Result<void> check_vertex_count(std::size_t found, std::size_t least) {
    if (found >= least) return {};
    return refuse({.code = CurveErrorCode::too_few_points,
                   .value = static_cast<double>(found),
                   .lower = static_cast<double>(least)});
}

Result<void> check_neighbors(std::span<const Point> points, bool is_closed) {
    const auto coincide = [&](std::size_t later, std::size_t earlier) -> Result<void> {
        if (points[later] != points[earlier]) return {};
        return refuse({.code = CurveErrorCode::points_coincide, .index = later, .value = static_cast<double>(earlier)});
    };
    for (std::size_t i = 1; i < points.size(); ++i)
        if (const auto check = coincide(i, i - 1); !check) return check;
    return is_closed ? coincide(points.size() - 1, 0) : Result<void>();
}

}  // namespace

Result<Curve> line(Point from, Point to) {
    return polyline(std::array{from, to});
}

Result<Curve> polyline(std::span<const Point> points, bool is_closed) {
    const auto check = check_vertex_count(points.size(), is_closed ? 3 : 2).and_then([&] {
        return check_neighbors(points, is_closed);
    });
    if (!check) return refuse(check.error());
    const KnotKind kind = is_closed ? KnotKind::periodic : KnotKind::clamped_uniform;
    const double legs = static_cast<double>(points.size()) - (is_closed ? 0.0 : 1.0);
    return make_knots(kind, 1, points.size(), {0.0, legs}).and_then([&](KnotVector knots) {
        return Curve::make(std::move(knots), {points.begin(), points.end()}, {});
    });
}

Result<Curve> regular_polygon(Point center, double radius, std::size_t sides, double start) {
    if (const auto check = check_vertex_count(sides, 3); !check) return refuse(check.error());
    if (!(radius > 0.0)) return refuse({.code = CurveErrorCode::length_not_positive, .value = radius});
    std::vector<Point> corners;
    for (std::size_t k = 0; k < sides; ++k)
        corners.push_back(center +
                          radius * unit_vector(start + 360.0 * static_cast<double>(k) / static_cast<double>(sides)));
    return polyline(corners, true);
}

Result<Curve> bezier_path(std::span<const Point> points, bool is_closed) {
    constexpr std::size_t p = 3;
    const std::size_t pieces = points.size() / p;
    if (pieces == 0 || points.size() % p != (is_closed ? 0 : 1))
        return refuse({.code = CurveErrorCode::kind_not_possible});
    if (!is_closed)
        return make_knots(KnotKind::piecewise_bezier, p, points.size(), {0.0, static_cast<double>(pieces)})
            .and_then([&](KnotVector knots) {
                return Curve::make(std::move(knots), {points.begin(), points.end()}, {});
            });
    std::vector<double> period;
    for (std::size_t k = 0; k < pieces; ++k) period.insert(period.end(), p, static_cast<double>(k));
    period.push_back(static_cast<double>(pieces));
    // Control point i belongs to the knots i-2 to i of the period, so that the first of them is number 2.
    std::vector<Point> turned(points.end() - (p - 1), points.end());
    turned.insert(turned.end(), points.begin(), points.end() - (p - 1));
    return KnotVector::make_periodic(p, std::move(period)).and_then([&](KnotVector knots) {
        return Curve::make(std::move(knots), std::move(turned), {});
    });
}

}  // namespace batten::core
