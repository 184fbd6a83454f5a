/// The points, vectors, intervals and boxes that every other header speaks of.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace batten::core {

/// A displacement or derivative in the plane.
struct Vector {
    double x;
    double y;

    Vector() = default;
    constexpr Vector(double right, double up) : x(right), y(up) {}

    /// To the layer that paints, only where it is asked for: pictures are made of places.
    explicit constexpr operator glm::dvec2() const { return {x, y}; }

    constexpr bool operator==(const Vector&) const = default;
    constexpr Vector& operator+=(Vector v) { return *this = {x + v.x, y + v.y}; }
    constexpr Vector& operator-=(Vector v) { return *this = {x - v.x, y - v.y}; }
    constexpr Vector& operator/=(double divisor) { return *this = {x / divisor, y / divisor}; }
};

constexpr Vector operator-(Vector v) {
    return {-v.x, -v.y};
}
constexpr Vector operator+(Vector a, Vector b) {
    return {a.x + b.x, a.y + b.y};
}
constexpr Vector operator-(Vector a, Vector b) {
    return {a.x - b.x, a.y - b.y};
}
constexpr Vector operator*(double factor, Vector v) {
    return {factor * v.x, factor * v.y};
}
constexpr Vector operator*(Vector v, double factor) {
    return factor * v;
}
constexpr Vector operator/(Vector v, double divisor) {
    return {v.x / divisor, v.y / divisor};
}

/// A place in the plane. Coordinates are finite doubles in the user's units. Points differ by vectors; they cannot be
/// added to one another, nor multiplied.
struct Point {
    double x;
    double y;

    Point() = default;
    constexpr Point(double right, double up) : x(right), y(up) {}

    /// To and from the layer that paints, which knows no points.
    explicit constexpr Point(glm::dvec2 place) : x(place.x), y(place.y) {}
    constexpr operator glm::dvec2() const { return {x, y}; }

    constexpr bool operator==(const Point&) const = default;
    constexpr Point& operator+=(Vector v) { return *this = {x + v.x, y + v.y}; }
    constexpr Point& operator-=(Vector v) { return *this = {x - v.x, y - v.y}; }
};

constexpr Vector operator-(Point a, Point b) {
    return {a.x - b.x, a.y - b.y};
}
constexpr Point operator+(Point point, Vector v) {
    return {point.x + v.x, point.y + v.y};
}
constexpr Point operator-(Point point, Vector v) {
    return {point.x - v.x, point.y - v.y};
}

/// The displacement from (0, 0) to `point`.
constexpr Vector vector_to(Point point) {
    return {point.x, point.y};
}

/// Where `v` leads from (0, 0).
constexpr Point tip_of(Vector v) {
    return {v.x, v.y};
}

/// The same place in coordinates whose zero is `origin`.
constexpr Point seen_from(Point point, Point origin) {
    return tip_of(point - origin);
}

/// The point midway between two. Their coordinates may be as large as doubles are.
constexpr Point middle(Point a, Point b) {
    return {0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y};
}

/// a . b, positive where both point to the same side.
constexpr double dot(Vector a, Vector b) {
    return a.x * b.x + a.y * b.y;
}

/// The determinant x_a y_b - y_a x_b, positive where b points to the left of a.
constexpr double cross(Vector a, Vector b) {
    return a.x * b.y - a.y * b.x;
}

/// The angle from `a` to `b`, in (-pi, pi], positive to the left.
inline double angle_between(Vector a, Vector b) {
    return std::atan2(cross(a, b), dot(a, b));
}

/// `v` turned to the left by a right angle.
constexpr Vector turned_left(Vector v) {
    return {-v.y, v.x};
}

/// |v|, where its square is a double.
inline double length(Vector v) {
    return std::sqrt(dot(v, v));
}

/// |v| of any size, at a higher cost where its square is none for doubles.
inline double robust_length(Vector v) {
    const double square = dot(v, v);
    return 1e-280 < square && square < 1e300 ? std::sqrt(square) : std::hypot(v.x, v.y);
}

inline double distance(Point a, Point b) {
    return length(b - a);
}

inline bool is_finite(Vector v) {
    return std::isfinite(v.x) && std::isfinite(v.y);
}
inline bool is_finite(Point point) {
    return is_finite(vector_to(point));
}

/// (wx, wy, w): the point (x, y) with weight w, one dimension up.
/// A NURBS curve is the shadow of a B-spline through these.
using HomogeneousPoint = glm::dvec3;

/// The homogeneous point above `point` at height `weight` (> 0).
constexpr HomogeneousPoint lift(Point point, double weight) {
    assert(weight > 0.0);
    return {point.x * weight, point.y * weight, weight};
}

/// The shadow of `point` on the plane w = 1. The weight must not be zero.
constexpr Point project(HomogeneousPoint point) {
    assert(point.z != 0.0);
    return {point.x / point.z, point.y / point.z};
}

inline bool is_finite(HomogeneousPoint point) {
    return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

/// (wx, wy) of a homogeneous point or derivative.
constexpr Vector plane_part(HomogeneousPoint point) {
    return {point.x, point.y};
}

/// A closed interval of parameters, lower <= upper.
struct Interval {
    double lower = 0.0;
    double upper = 0.0;

    double length() const { return upper - lower; }
    bool contains(double u) const { return lower <= u && u <= upper; }
    double clamp(double u) const {
        assert(lower <= upper);
        return std::clamp(u, lower, upper);
    }
    bool operator==(const Interval&) const = default;
};

/// An axis-aligned rectangle; empty until the first point is included.
struct Box {
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    Point lower{infinity, infinity};
    Point upper{-infinity, -infinity};

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
