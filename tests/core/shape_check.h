/// Compares curves at equal parameters.
#pragma once

#include "core/evaluate/evaluate.h"
#include "tests/core/golden_cases.h"
#include "tests/core/random_curves.h"
#include "tests/core/stored_knots.h"

namespace batten::core {

/// The largest distance of `after` from `before` over the domain of `after`, at 40 random parameters on both sides,
/// relative to the largest coordinate of the control points of `before`.
inline double shape_change(const Curve& before, const Curve& after, RandomCurves& random) {
    double largest = 0.0;
    for (int k = 0; k < 40; ++k) {
        const double u = random.parameter(after);
        for (const Side side : {Side::left, Side::right})
            largest = std::max(largest, distance(point_at(before, u, side), point_at(after, u, side)));
    }
    return largest / golden::largest_coordinate(before.control_points());
}

/// The largest difference of the control points of two curves, relative to the largest coordinate; infinite when they
/// differ in number.
inline double point_difference(const Curve& a, const Curve& b) {
    return golden::largest_difference(a.control_points(), b.control_points()) /
           golden::largest_coordinate(a.control_points());
}

/// A clamped curve of high degree with random points, knots and weights.
inline Curve high_degree_curve(int degree, std::size_t spans, RandomCurves& random) {
    const auto p = static_cast<std::size_t>(degree);
    CurveDefinition definition{.degree = degree, .knots = std::vector(p + 1, 0.0)};
    double u = 0.0;
    for (std::size_t i = 1; i < spans; ++i) definition.knots.push_back(u += random.number(0.05, 1.5));
    definition.knots.insert(definition.knots.end(), p + 1, u + 1.0);
    for (std::size_t i = 0; i < p + spans; ++i) {
        const double x = random.number(-8.0, 8.0);
        definition.points.emplace_back(x, random.number(-8.0, 8.0));
        definition.weights.push_back(random.number(0.2, 5.0));
    }
    return Curve::make(std::move(definition)).value();
}

}  // namespace batten::core
