/// Degree elevation of clamped curves up to degree 3, from their Bézier points.
#pragma once

#include "core/curve/curve.h"

namespace batten::core {

/// Whether `curve` is one that low_elevation() knows: clamped, of degree 1 to 3.
bool has_low_elevation(const Curve& curve);

/// The same curve in degree p + 1. A new control point is the mean of the p+1 blossoms whose arguments are its own p+1
/// knots without one of them. Since every new knot is at least double, these arguments are the two ends of one span,
/// and the point is one of the elevated Bézier piece, or, in degree 3, a, b, b, c around a simple knot b: then
/// (b(a, b, b) + 2 b(a, b, c) + b(b, b, c)) / 4, of which two are Bézier points and one is an old control point.
/// Error: not_computable. Cost: at most 3 combinations for each new point.
[[nodiscard]] Result<Curve> low_elevation(const Curve& curve);

}  // namespace batten::core
