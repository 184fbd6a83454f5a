/// Bézier curves by their points.
#pragma once

#include <utility>
#include <vector>

#include "core/curve/curve.h"

namespace batten::core {

/// Over [0, 1], of as high a degree as there are points for; without weights all are 1.
inline Curve bezier(std::vector<Point> points, std::vector<double> weights = {}) {
    const auto p = static_cast<int>(points.size()) - 1;
    std::vector<double> knots(points.size(), 0.0);
    knots.insert(knots.end(), points.size(), 1.0);
    return Curve::make({.degree = p, .knots = knots, .points = std::move(points), .weights = std::move(weights)})
        .value();
}

}  // namespace batten::core
