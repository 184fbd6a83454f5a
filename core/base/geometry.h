/// The points, vectors, intervals and boxes that every other header speaks of.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace batten::core {

/// A place in the plane. Coordinates are finite doubles in the user's units.
using Point = glm::dvec2;

/// A displacement or derivative in the plane.
using Vector = glm::dvec2;

/// a . b, positive where they point the same way.
inline double dot(Vector a, Vector b) {
    return a.x * b.x + a.y * b.y;
}

/// The determinant x_a y_b - y_a x_b: positive where b points to the left of a.
inline double cross(Vector a, Vector b) {
    return a.x * b.y - a.y * b.x;
}

/// |v|. Its square must be a double, too.
inline double length(Vector v) {
    return std::sqrt(dot(v, v));
}

/// |v| for vectors of any size, at a higher cost.
inline double robust_length(Vector v) {
    return std::hypot(v.x, v.y);
}

inline double distance(Point a, Point b) {
    return length(b - a);
}

/// `v` turned to the left by a right angle.
inline Vector turned_left(Vector v) {
    return {-v.y, v.x};
}

/// The point midway between two; their coordinates may be as large as doubles are.
inline Point middle(Point a, Point b) {
    return {0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y};
}

inline bool is_finite(Vector v) {
    return std::isfinite(v.x) && std::isfinite(v.y);
}

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
