/// How far apart two curves are.
#pragma once

#include "core/curve/curve.h"

namespace batten::core {

/// The largest distance |a(u) - b(u)| over samples of both domains, matched affinely: 32 or more (4 p) in every
/// non-empty span of either curve, denser toward its ends. The number shown beside a shape-changing edit, and the
/// check behind a shape-keeping one; both curves are compared with equal parameter, so a mere reparametrization counts
/// as a deviation. Infinite where it is too large for a double.
double largest_deviation(const Curve& a, const Curve& b);

}  // namespace batten::core
