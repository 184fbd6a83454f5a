/// A point and its first two derivatives in twice the precision, for where a slow curve leaves few digits.
#pragma once

#include <array>

#include "core/base/detail/precise_point.h"
#include "core/curve/detail/bspline.h"

namespace batten::core {

/// A(u) of the homogeneous spline over the span `at`, seen from `origin`, as exact as if it were computed in some 30
/// digits. Cost O(p^2), some ten times that of the same in doubles.
PreciseHomogeneousPoint precise_point(const Curve& curve, const SpanKnots& at, double u, Point origin);

/// A(u), A'(u), A''(u), likewise. Cost O(p^2), some twenty times that of the same in doubles.
std::array<PreciseHomogeneousPoint, 3> precise_jet(const Curve& curve, const SpanKnots& at, double u, Point origin);

}  // namespace batten::core
