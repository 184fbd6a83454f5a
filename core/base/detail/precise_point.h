/// Homogeneous points in twice the precision, for what a few digits are left of.
#pragma once

#include "core/base/double_double.h"
#include "core/base/geometry.h"

namespace batten::core {

struct PreciseHomogeneousPoint {
    DoubleDouble x;
    DoubleDouble y;
    DoubleDouble w;
};

inline PreciseHomogeneousPoint operator+(const PreciseHomogeneousPoint& a, const PreciseHomogeneousPoint& b) {
    return {a.x + b.x, a.y + b.y, a.w + b.w};
}

inline PreciseHomogeneousPoint operator-(const PreciseHomogeneousPoint& a, const PreciseHomogeneousPoint& b) {
    return {a.x - b.x, a.y - b.y, a.w - b.w};
}

inline PreciseHomogeneousPoint operator*(DoubleDouble factor, const PreciseHomogeneousPoint& a) {
    return {factor * a.x, factor * a.y, factor * a.w};
}

/// The homogeneous point above `point` at height `weight`, seen from `origin`.
inline PreciseHomogeneousPoint lift_precisely(Point point, double weight, Point origin) {
    return {weight * exact_sum(point.x, -origin.x), weight * exact_sum(point.y, -origin.y), weight};
}

inline HomogeneousPoint rounded(const PreciseHomogeneousPoint& point) {
    return {point.x.rounded(), point.y.rounded(), point.w.rounded()};
}

/// The affine combination at `u` of `a`, at `lower`, and `b`, at `upper`, computed from the nearer of the two.
template <class P>
P blend_precisely(const P& a, const P& b, double lower, double upper, double u) {
    const DoubleDouble length = exact_sum(upper, -lower);
    const DoubleDouble from_a = exact_sum(u, -lower);
    const DoubleDouble from_b = exact_sum(u, -upper);
    return std::abs(from_a.high) <= std::abs(from_b.high) ? a + (from_a / length) * (b - a)
                                                          : b + (from_b / length) * (b - a);
}

}  // namespace batten::core
