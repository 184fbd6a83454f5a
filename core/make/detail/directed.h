/// Data taken always in the same of its two directions, so that no rounding can tell them apart.
#pragma once

#include <span>

#include "core/curve/curve.h"

namespace batten::core {

/// Whether `points` come in the one of their two directions in which they are dealt with.
bool is_canonical(std::span<const Point> points);

/// 1 - u is exact for these values, so that reversing twice is the identity.
constexpr double reversible(double u) {
    return 1.0 - (1.0 - u);
}

/// A curve over [0, 1], whose knots are reversible, in the other direction.
Curve reversed(const Curve& curve);

}  // namespace batten::core
