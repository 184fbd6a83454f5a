/// Curves whose measures are known, and the same curves elsewhere.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "core/curve/curve.h"

namespace batten::core {

/// The same shape, moved.
inline Curve moved(const Curve& curve, Vector offset) {
    CurveDefinition definition = curve.definition();
    for (Point& point : definition.points) point += offset;
    return Curve::make(std::move(definition)).value();
}

/// The same shape over the knots `lower` + `factor` u.
inline Curve over(const Curve& curve, double lower, double factor) {
    CurveDefinition definition = curve.definition();
    for (double& knot : definition.knots) knot = lower + factor * knot;
    return Curve::make(std::move(definition)).value();
}

/// Over [0, 1], from (a, 0) counterclockwise, of four arcs.
inline Curve ellipse(double a, double b, Point center = Point{}) {
    const double w = std::sqrt(0.5);
    return moved(Curve::make({.degree = 2,
                              .knots = {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1},
                              .points = {{a, 0}, {a, b}, {0, b}, {-a, b}, {-a, 0}, {-a, -b}, {0, -b}, {a, -b}, {a, 0}},
                              .weights = {1, w, 1, w, 1, w, 1, w, 1}})
                     .value(),
                 vector_to(center));
}

/// Of degree 1, with leg i over [i, i + 1].
inline Curve polygon(std::vector<Point> points) {
    std::vector<double> knots{0};
    for (std::size_t i = 0; i < points.size(); ++i) knots.push_back(static_cast<double>(i));
    knots.push_back(knots.back());
    return Curve::make({.degree = 1, .knots = std::move(knots), .points = std::move(points)}).value();
}

}  // namespace batten::core
