/// How far a curve is from the offset of another one.
#pragma once

#include "core/curve/curve.h"

namespace batten::core {

/// A bound of the largest distance at equal parameters between `candidate` and the points at `distance` (not 0) to the
/// left of `curve`, whose knots `candidate` has among its own and which it meets at each of its knots: at most a
/// percent above that distance where the curve does not stand still, but for rounding. The offset has a root in it; so
/// the parts of the distance along and across the curve are bounded each by its square, in Bernstein form. Cost O(p^2)
/// for each span and halving.
double offset_error_bound(const Curve& curve, const Curve& candidate, double distance);

}  // namespace batten::core
