/// Closed curves and an independent judgment of what they enclose, for tests of shapes.
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "core/evaluate/evaluate.h"
#include "core/make/conics.h"
#include "core/make/interpolate.h"
#include "core/make/shapes.h"
#include "core/measure/area.h"
#include "core/shape/combine.h"

namespace batten::core {

inline Curve closed_polygon(std::vector<Point> corners) {
    CurveDefinition definition{.degree = 1, .knots = {0.0}, .points = corners};
    definition.points.push_back(corners.front());
    for (std::size_t i = 0; i < definition.points.size(); ++i) definition.knots.push_back(static_cast<double>(i));
    definition.knots.push_back(definition.knots.back());
    return Curve::make(std::move(definition)).value();
}

inline Curve rectangle(Point lower, Point upper) {
    return closed_polygon({lower, {upper.x, lower.y}, upper, {lower.x, upper.y}});
}

inline Curve disc(Point center, double radius) {
    return circle(center, radius).value();
}

/// A periodic cubic through points at these radii, evenly around `center`, run through `turns` times.
inline Curve rounded(Point center, const std::vector<double>& radii, int turns = 1) {
    std::vector<Point> points;
    for (std::size_t k = 0; k < radii.size(); ++k) {
        const double angle =
            2.0 * std::numbers::pi * turns * static_cast<double>(k) / static_cast<double>(radii.size());
        points.push_back(center + radii[k] * Vector(std::cos(angle), std::sin(angle)));
    }
    return interpolate(points, {.ends = ClosedEnds{}}).value().curve;
}

/// The winding number about `place` of a fine polygon in the curve, by summing angles.
inline int winding_of_samples(const Curve& curve, Point place, int count = 700) {
    const Interval domain = curve.domain();
    double sum = 0.0;
    Vector before = point_at(curve, domain.lower) - place;
    const Vector first = before;
    for (int k = 1; k <= count; ++k) {
        const Vector next = k == count ? first : point_at(curve, domain.lower + domain.length() * k / count) - place;
        sum += angle_between(before, next);
        before = next;
    }
    return static_cast<int>(std::lround(sum / (2.0 * std::numbers::pi)));
}

inline int winding_of_samples(const std::vector<Curve>& curves, Point place, int count = 700) {
    int sum = 0;
    for (const Curve& curve : curves) sum += winding_of_samples(curve, place, count);
    return sum;
}

inline double area_of(const std::vector<Curve>& curves) {
    double sum = 0.0;
    for (const Curve& curve : curves) sum += enclosed_area(curve).value().signed_area;
    return sum;
}

/// The area of what a shape encloses: of its union with nothing.
inline double area_inside(const Shape& shape) {
    return area_of(combine(shape, {}, ShapeOperation::unite).value());
}

}  // namespace batten::core
