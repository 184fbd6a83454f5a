/// The triangle of affine combinations behind every B-spline algorithm, written once for every point type.
///
/// Over the span [u_s, u_{s+1}] a spline of degree p is determined by its p+1 local points d_j, j = 0..p, which are the
/// control points of index i = s-p+j. Level r = 1..p of the triangle turns the neighbors i-1 and i into one new point,
/// using the knots u_i and u_{i+p-r+1}; whatever the level does, these two enclose the span and so are never equal:
///
///     blending at a       (u_upper - a) / (u_upper - u_lower) d_{j-1} + (a - u_lower) / (u_upper - u_lower) d_j
///     differentiating    (p-r+1) (d_j - d_{j-1}) / (u_upper - u_lower)
///
/// p levels that blend at u give C(u) (de Boor); blending at a_1, ..., a_p gives the blossom; k levels that
/// differentiate and p-k that blend give the k-th derivative. The point type is double, Vector or HomogeneousPoint; for
/// blending alone, Point too.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>

#include "core/curve/curve.h"

namespace batten::core {

/// The p+1 local points of one span; only those of index 0..p count. On the stack, so that evaluating never allocates.
template <class P>
using LocalPoints = std::array<P, max_degree + 1>;

/// Where a parameter lies between two knots, seen from both: lower_share + upper_share = 1.
/// Both are quotients of differences, because 1 - alpha would lose the digits of a small share.
struct Ratio {
    double lower_share = 1.0;  ///< (u_upper - u) / (u_upper - u_lower)
    double upper_share = 0.0;  ///< (u - u_lower) / (u_upper - u_lower), the alpha of the books
};

/// The ratio of `u` between two knots, lower < upper.
inline Ratio ratio_between(double lower, double upper, double u) {
    assert(lower < upper);
    const double length = upper - lower;
    return {(upper - u) / length, (u - lower) / length};
}

/// lower_share a + upper_share b, computed from the nearer of the two: bit-equal to a or b where a share is 0,
/// bit-equal to both where they are equal, and of full relative accuracy for positive numbers.
template <class P>
P blend(const P& a, const P& b, Ratio ratio) {
    return ratio.upper_share <= 0.5 ? a + ratio.upper_share * (b - a) : b + ratio.lower_share * (a - b);
}

/// The affine combination at `u` of `a`, at `lower`, and `b`, at `upper`, lower < upper. A point type may have its own.
template <class P>
P blend_between(const P& a, const P& b, double lower, double upper, double u) {
    return blend(a, b, ratio_between(lower, upper, u));
}

/// One span of a knot vector: what the levels of the triangle need to know.
struct SpanKnots {
    std::span<const double> knots;
    std::size_t p = 0;  ///< degree
    std::size_t s = 0;  ///< span index, p <= s, u_s < u_{s+1}, in the domain

    SpanKnots(const KnotVector& vector, std::size_t span_index)
        : knots(vector.values()), p(static_cast<std::size_t>(vector.degree())), s(span_index) {
        assert(p <= s && s + p + 1 < knots.size() && knots[s] < knots[s + 1]);
    }

    /// The knots u_i and u_{i+p-r+1} of local point j >= r on level r >= 1, where i = s-p+j.
    double lower(std::size_t j) const { return knots[s - p + j]; }
    double upper(std::size_t j, std::size_t r) const { return knots[s + j - r + 1]; }
    Ratio ratio(std::size_t j, std::size_t r, double u) const { return ratio_between(lower(j), upper(j, r), u); }
};

/// A parameter brought into the domain, and its span.
struct Location {
    double u = 0.0;
    SpanKnots at;
};

/// Where `u` belongs, seen from `side` at a knot.
inline Location located(const KnotVector& knots, double u, Side side) {
    const auto [lower, upper] = knots.domain();
    const double inside = lower < u && u < upper ? u : knots.into_domain(u, side);
    return {inside, SpanKnots(knots, knots.span_at(inside, side))};
}

/// The local points of `curve`, seen from `origin`. Near it the coordinates are small, so that the differences which
/// make derivatives do not cancel, however far from (0, 0) the curve lies.
inline LocalPoints<HomogeneousPoint> local_points(const Curve& curve, const SpanKnots& at, Point origin = {}) {
    LocalPoints<HomogeneousPoint> points;
    const std::size_t n = curve.control_points().size();
    std::size_t i = (at.s - at.p) % n;
    for (std::size_t j = 0; j <= at.p; ++j) {
        points[j] = lift(seen_from(curve.control_points()[i], origin), curve.weights()[i]);
        if (++i == n) i = 0;
    }
    return points;
}

/// A weight divided by a power of two; the smallest double where it is too small beside it.
inline double divided_by_power(double weight, int order) {
    return std::max(std::scalbn(weight, -order), std::numeric_limits<double>::min());
}

/// The power of two of the largest weight in reach where it is so far from 1 that products of weights and coordinates
/// might overflow or vanish; else 0.
inline int extreme_order(double largest) {
    constexpr double moderate = 1e100;
    return 1.0 / moderate < largest && largest < moderate ? 0 : std::ilogb(largest);
}

/// Local points for the same shadow: where weights are extreme all are divided by one power of two.
inline LocalPoints<HomogeneousPoint> local_shadow_points(const Curve& curve, const SpanKnots& at, Point origin = {}) {
    LocalPoints<double> weights;
    const std::size_t n = curve.control_points().size();
    for (std::size_t j = 0; j <= at.p; ++j) weights[j] = curve.weights()[(at.s - at.p + j) % n];
    const int order =
        extreme_order(*std::max_element(weights.begin(), weights.begin() + static_cast<std::ptrdiff_t>(at.p) + 1));
    if (order == 0) return local_points(curve, at, origin);
    LocalPoints<HomogeneousPoint> points;
    for (std::size_t j = 0; j <= at.p; ++j)
        points[j] =
            lift(seen_from(curve.control_points()[(at.s - at.p + j) % n], origin), divided_by_power(weights[j], order));
    return points;
}

/// Level r, 1 to p, as blends at `u`, in place: points r..p are new.
template <class P>
void blend_level(LocalPoints<P>& points, const SpanKnots& at, std::size_t r, double u) {
    assert(1 <= r && r <= at.p);
    for (std::size_t j = at.p; j >= r; --j) points[j] = blend(points[j - 1], points[j], at.ratio(j, r, u));
}

/// Level r, 1 to p, as a derivative, in place: points r..p are new.
template <class P>
void differentiate_level(LocalPoints<P>& points, const SpanKnots& at, std::size_t r) {
    assert(1 <= r && r <= at.p);
    const auto factor = static_cast<double>(at.p - r + 1);
    for (std::size_t j = at.p; j >= r; --j)
        points[j] = (factor / (at.upper(j, r) - at.lower(j))) * (points[j] - points[j - 1]);
}

/// The spline at `u` after `levels_done` levels, at most p: the levels that remain blend at u. Source: de Boor 1972.
template <class P>
P de_boor(LocalPoints<P> points, const SpanKnots& at, double u, std::size_t levels_done = 0) {
    assert(levels_done <= at.p);
    for (std::size_t r = levels_done + 1; r <= at.p; ++r) blend_level(points, at, r, u);
    return points[at.p];
}

}  // namespace batten::core
