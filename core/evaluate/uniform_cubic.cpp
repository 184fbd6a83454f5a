#include "core/evaluate/uniform_cubic.h"

#include <cassert>
#include <utility>

#include "core/curve/detail/bspline.h"
#include "core/curve/knot_analysis.h"

namespace batten::core {

namespace {

Result<void> check_uniform_cubic(const Curve& curve) {
    if (is_uniform_cubic(curve)) return {};
    return refuse({.code = CurveErrorCode::curve_not_uniform_cubic});
}

Result<void> check_uniform_polynomial_cubic(const Curve& curve) {
    return check_uniform_cubic(curve).and_then([&]() -> Result<void> {
        if (!curve.is_rational()) return {};
        return refuse({.code = CurveErrorCode::curve_rational});
    });
}

Interval interval_of(const Curve& curve, std::size_t segment) {
    return {curve.knots()[segment + 3], curve.knots()[segment + 4]};
}

Point unrolled_point(const Curve& curve, std::size_t i) {
    return curve.control_points()[i % curve.control_points().size()];
}

// The joint of three neighbors, seen from the middle one, so that equal points give themselves.
Point joint(Point before, Point at, Point after) {
    return at + ((before - at) + (after - at)) / 6.0;
}

// Of a polynomial curve with the weight 1, whatever the one weight is that all points have.
HomogeneousPoint point_for_matrix(const Curve& curve, std::size_t i) {
    return curve.is_rational() ? curve.homogeneous_point(i) : lift(unrolled_point(curve, i), 1.0);
}

}  // namespace

bool is_uniform_cubic(const Curve& curve) {
    const KnotKind kind = curve.is_periodic() ? KnotKind::periodic : KnotKind::uniform;
    return curve.degree() == 3 && is_of_kind(curve.knots(), kind);
}

std::size_t cubic_segment_count(const Curve& curve) {
    return curve.control_points().size() - (curve.is_periodic() ? 0 : 3);
}

std::size_t cubic_segment_index(const Curve& curve, double u) {
    return curve.knots().span_at(curve.knots().into_domain(u)) - 3;
}

CubicSegment cubic_segment(const Curve& curve, std::size_t k) {
    assert(curve.degree() == 3 && k < cubic_segment_count(curve));
    CubicSegment segment{.interval = interval_of(curve, k), .first_point = k};
    for (std::size_t row = 0; row < 4; ++row) {
        HomogeneousPoint sum(0.0);
        for (std::size_t j = 0; j < 4; ++j)
            sum += static_cast<double>(uniform_cubic_matrix[row][j]) * point_for_matrix(curve, k + j);
        segment.coefficients[row] = sum / 6.0;
    }
    return segment;
}

Result<std::vector<CubicSegment>> cubic_segments(const Curve& curve) {
    if (const auto check = check_uniform_cubic(curve); !check) return refuse(check.error());
    std::vector<CubicSegment> segments;
    for (std::size_t k = 0; k < cubic_segment_count(curve); ++k) segments.push_back(cubic_segment(curve, k));
    return segments;
}

FergusonSegment ferguson_segment(const Curve& curve, std::size_t k) {
    assert(curve.degree() == 3 && !curve.is_rational() && k < cubic_segment_count(curve));
    std::array<Point, 4> P;
    for (std::size_t j = 0; j < 4; ++j) P[j] = unrolled_point(curve, k + j);
    return {.interval = interval_of(curve, k),
            .start = joint(P[0], P[1], P[2]),
            .end = joint(P[1], P[2], P[3]),
            .start_tangent = 0.5 * (P[2] - P[0]),
            .end_tangent = 0.5 * (P[3] - P[1])};
}

Result<std::vector<FergusonSegment>> ferguson_segments(const Curve& curve) {
    if (const auto check = check_uniform_polynomial_cubic(curve); !check) return refuse(check.error());
    std::vector<FergusonSegment> segments;
    for (std::size_t k = 0; k < cubic_segment_count(curve); ++k) segments.push_back(ferguson_segment(curve, k));
    return segments;
}

// The blossom of a_0 + a_1 t + a_2 t^2 + a_3 t^3 at (-2, -1, 0), (-1, 0, 1), (0, 1, 2), (1, 2, 3), seen from the start.
std::array<Point, 4> uniform_control_points(const FergusonSegment& segment) {
    const Vector chord = segment.end - segment.start;
    const Vector a1 = segment.start_tangent;
    const Vector a2 = 3.0 * chord - 2.0 * segment.start_tangent - segment.end_tangent;
    const Vector a3 = segment.start_tangent + segment.end_tangent - 2.0 * chord;
    return {segment.start + (2.0 / 3.0 * a2 - a1), segment.start - a2 / 3.0, segment.start + (a1 + 2.0 / 3.0 * a2),
            segment.start + (2.0 * a1 + 11.0 / 3.0 * a2 + 6.0 * a3)};
}

Result<Curve> curve_from_ferguson(const std::vector<FergusonSegment>& segments) {
    if (segments.empty()) return refuse({.code = CurveErrorCode::too_few_points, .value = 0.0, .lower = 4.0});
    assert(std::adjacent_find(segments.begin(), segments.end(), [](const auto& before, const auto& after) {
               return before.interval.upper != after.interval.lower || before.end != after.start;
           }) == segments.end());
    CurveDefinition curve{.degree = 3,
                          .knots = std::vector<double>(4, segments.front().interval.lower),
                          .kind = KnotKind::piecewise_bezier};
    curve.points.push_back(segments.front().start);
    for (const FergusonSegment& segment : segments) {
        curve.points.push_back(segment.start + segment.start_tangent / 3.0);
        curve.points.push_back(segment.end - segment.end_tangent / 3.0);
        curve.points.push_back(segment.end);
        curve.knots.insert(curve.knots.end(), 3, segment.interval.upper);
    }
    curve.knots.push_back(segments.back().interval.upper);
    return Curve::make(std::move(curve));
}

Anticentroid anticentroid_of(Point before, Point vertex, Point after) {
    return {.before = before,
            .vertex = vertex,
            .after = after,
            .base_middle = before + 0.5 * (after - before),
            .anticentroid = joint(before, vertex, after),
            .tangent = 0.5 * (after - before),
            .second_derivative = (before - vertex) + (after - vertex)};
}

Anticentroid anticentroid(const Curve& curve, std::size_t i) {
    const std::size_t n = curve.control_points().size();
    assert(curve.degree() == 3 && !curve.is_rational() && (curve.is_periodic() || (0 < i && i + 1 < n)));
    Anticentroid made =
        anticentroid_of(unrolled_point(curve, i + n - 1), unrolled_point(curve, i), unrolled_point(curve, i + 1));
    made.index = i % n;
    // Point i is the blossom of the knots t_{i-2}, t_{i-1}, t_i of a period: its joint is at the middle one.
    made.u = curve.knots()[made.index + 2];
    if (curve.is_periodic()) made.u = curve.knots().into_domain(made.u, Side::right);
    return made;
}

Result<std::vector<Anticentroid>> anticentroids(const Curve& curve) {
    if (const auto check = check_uniform_polynomial_cubic(curve); !check) return refuse(check.error());
    const std::size_t ends = curve.is_periodic() ? 0 : 1;
    std::vector<Anticentroid> joints;
    for (std::size_t i = ends; i + ends < curve.control_points().size(); ++i) joints.push_back(anticentroid(curve, i));
    return joints;
}

}  // namespace batten::core
