/// Boxes and hulls around curves.
#pragma once

#include <span>
#include <vector>

#include "core/curve/curve.h"

namespace batten::core {

/// The smallest box that contains the curve, right to rounding: of the ends of all pieces and the zeros of x' and y',
/// which are found globally. Empty where numbers on the way are beyond what doubles can hold. Source: variation
/// diminishing.
Box tight_box(const Curve& curve);

/// The convex hull of `points`, which are finite, counter-clockwise, without collinear points; fewer than three points
/// come back as they are. Cost O(n log n). Source: Andrew 1979.
std::vector<Point> convex_hull(std::span<const Point> points);

/// Whether the closed polygon of `points` is convex: it goes around once and never turns back by more than `angle`
/// (>= 0, radians). Points may repeat or lie on an edge; points on a line are convex where they go along it and back
/// once. Cost O(n).
bool is_convex(std::span<const Point> points, double angle = 1e-9);

/// A piece of a curve and what is known to contain it.
struct SpanHull {
    Interval interval;        ///< the piece's parameters
    std::vector<Point> hull;  ///< of its p+1 control points, as convex_hull gives it
};

/// The hulls of all non-empty spans, in order. Each piece lies in its own (strong convex hull property).
std::vector<SpanHull> span_hulls(const Curve& curve);

}  // namespace batten::core
