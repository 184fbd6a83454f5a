/// Curves over whole knots, for tests about their control points.
#pragma once

#include "core/curve/curve.h"

namespace batten::core {

/// Over the knots -p, ..., so that the domain begins at 0.
inline Curve open_curve(int degree, std::vector<Point> points) {
    CurveDefinition definition{.degree = degree, .points = std::move(points)};
    const auto p = static_cast<std::size_t>(degree);
    for (std::size_t i = 0; i < definition.points.size() + p + 1; ++i)
        definition.knots.push_back(static_cast<double>(i) - degree);
    return Curve::make(std::move(definition)).value();
}

/// Over one period from 0.
inline Curve closed_curve(int degree, std::vector<Point> points) {
    CurveDefinition definition{.degree = degree, .points = std::move(points), .periodic = true};
    for (std::size_t i = 0; i <= definition.points.size(); ++i) definition.knots.push_back(static_cast<double>(i));
    return Curve::make(std::move(definition)).value();
}

}  // namespace batten::core
