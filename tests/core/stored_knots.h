/// The knots of a curve as a list, to compare.
#pragma once

#include <vector>

#include "core/curve/curve.h"

namespace batten::core {

/// The knots that are stored.
inline std::vector<double> stored(const Curve& curve) {
    return {curve.knots().stored().begin(), curve.knots().stored().end()};
}

}  // namespace batten::core
