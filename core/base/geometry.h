/// The points, vectors, intervals and boxes that every other header speaks of.
#pragma once

#include <algorithm>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace batten::core {

/// A place in the plane. Coordinates are finite doubles in the user's units.
using Point = glm::dvec2;

/// A displacement or derivative in the plane.
using Vector = glm::dvec2;

/// (wx, wy, w): the point (x, y) with weight w, one dimension up.
/// A NURBS curve is the shadow of a B-spline through these.
using HomogeneousPoint = glm::dvec3;

/// The homogeneous point above `point` at height `weight` (> 0).
inline HomogeneousPoint lift(Point point, double weight) {
    return {point.x * weight, point.y * weight, weight};
}

/// The shadow of `point` on the plane w = 1. The weight must not be zero.
inline Point project(HomogeneousPoint point) {
    return {point.x / point.z, point.y / point.z};
}

/// A closed interval of parameters, lower <= upper.
struct Interval {
    double lower = 0.0;
    double upper = 0.0;

    double length() const { return upper - lower; }
    bool contains(double u) const { return lower <= u && u <= upper; }
    double clamp(double u) const { return std::clamp(u, lower, upper); }
    bool operator==(const Interval&) const = default;
};

/// An axis-aligned rectangle; empty until the first point is included.
struct Box {
    Point lower{std::numeric_limits<double>::infinity()};
    Point upper{-std::numeric_limits<double>::infinity()};

    bool is_empty() const { return !(lower.x <= upper.x && lower.y <= upper.y); }
    Point center() const { return lower + 0.5 * (upper - lower); }
    Vector size() const { return upper - lower; }
    bool contains(Point p) const { return lower.x <= p.x && p.x <= upper.x && lower.y <= p.y && p.y <= upper.y; }
    bool intersects(const Box& other) const {
        return lower.x <= other.upper.x && other.lower.x <= upper.x && lower.y <= other.upper.y &&
               other.lower.y <= upper.y;
    }
    void include(Point p) {
        lower = {std::min(lower.x, p.x), std::min(lower.y, p.y)};
        upper = {std::max(upper.x, p.x), std::max(upper.y, p.y)};
    }
};

}  // namespace batten::core
