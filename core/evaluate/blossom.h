/// The polar form of one polynomial piece: symmetric, affine in each argument, equal to the curve on the diagonal.
#pragma once

#include <span>

#include "core/curve/curve.h"

namespace batten::core {

/// The blossom b(a_1, ..., a_p) of the homogeneous piece over `span` (a non-empty span of the domain).
/// Control point i is b(u_{i+1}, ..., u_{i+p}) for every span s with i <= s <= i+p. `arguments` has p values, of any
/// size. Cost O(p^2). Source: Ramshaw 1987.
HomogeneousPoint blossom(const Curve& curve, std::size_t span, std::span<const double> arguments);

}  // namespace batten::core
