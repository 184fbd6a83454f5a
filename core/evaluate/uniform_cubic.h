/// The uniform cubic as data: the matrix form of a segment, the Hermite form, the construction with anticentroids.
#pragma once

#include <array>
#include <vector>

#include "core/curve/curve.h"

namespace batten::core {

/// Degree 3 and equally spaced knots up to rounding, all of them: unclamped or periodic.
bool is_uniform_cubic(const Curve& curve);

/// Row k of the basis matrix of a segment, times 6: coefficient a_k = sum_j matrix[k][j] P_j / 6, j = 0..3.
inline constexpr std::array<std::array<int, 4>, 4> uniform_cubic_matrix{
    {{1, 4, 1, 0}, {-3, 0, 3, 0}, {3, -6, 3, 0}, {-1, 3, -3, 1}}};

/// One segment: a_0 + a_1 t + a_2 t^2 + a_3 t^3, where t = (u - lower) / (upper - lower) runs from 0 to 1.
struct CubicSegment {
    Interval interval;
    std::size_t first_point = 0;                     ///< index of the first of its four control points, unrolled
    std::array<HomogeneousPoint, 4> coefficients{};  ///< with third coordinate 1, 0, 0, 0 where all weights are equal
};

/// How many segments a uniform cubic has, and which of them `u`, brought into the domain, is on: 0, 1, ... A joint
/// belongs to the segment that begins there, the end of the domain to the last one. Cost O(1) and O(log n).
std::size_t cubic_segment_count(const Curve& curve);
std::size_t cubic_segment_index(const Curve& curve, double u);

/// Segment `k` (below their count) of a uniform cubic. Cost O(1).
CubicSegment cubic_segment(const Curve& curve, std::size_t k);

/// The segments in order. Error: curve_not_uniform_cubic.
[[nodiscard]] Result<std::vector<CubicSegment>> cubic_segments(const Curve& curve);

/// Hermite form, after Ferguson 1964: a cubic segment by its ends and its tangents there, derivatives in t.
struct FergusonSegment {
    Interval interval;
    Point start{};
    Point end{};
    Vector start_tangent{};
    Vector end_tangent{};
};

/// Segment `k` (below their count) of a uniform polynomial cubic: start = (P_0 + 4 P_1 + P_2) / 6, tangent
/// (P_2 - P_0) / 2, and so on. Cost O(1).
FergusonSegment ferguson_segment(const Curve& curve, std::size_t k);

/// The segments in order. Errors: curve_not_uniform_cubic; curve_rational.
[[nodiscard]] Result<std::vector<FergusonSegment>> ferguson_segments(const Curve& curve);

/// The four control points of the uniform cubic segment that is this one; the inverse of ferguson_segments.
std::array<Point, 4> uniform_control_points(const FergusonSegment& segment);

/// The curve of these segments, in order and each starting where the one before ends: piecewise Bézier, the inner
/// control points a third of a tangent from the joints. Errors: too_few_points without any segment; knot_decreasing or
/// multiplicity_too_high by their intervals; point_not_finite.
[[nodiscard]] Result<Curve> curve_from_ferguson(const std::vector<FergusonSegment>& segments);

/// The construction of one joint: P_i with its neighbors makes a triangle; the joint S is its anticentroid, on the
/// median from P_i, one third of the way from it.
struct Anticentroid {
    std::size_t index = 0;       ///< i
    double u = 0.0;              ///< the knot at the joint
    Point before{};              ///< P_{i-1}
    Point vertex{};              ///< P_i
    Point after{};               ///< P_{i+1}
    Point base_middle{};         ///< M = (P_{i-1} + P_{i+1}) / 2
    Point anticentroid{};        ///< S = P_i + (M - P_i) / 3 = (P_{i-1} + 4 P_i + P_{i+1}) / 6 = C(u)
    Vector tangent{};            ///< (P_{i+1} - P_{i-1}) / 2, per knot step
    Vector second_derivative{};  ///< P_{i-1} - 2 P_i + P_{i+1} = 2 (M - P_i), per knot step squared
};

/// The construction from these three points alone, with index and u 0.
Anticentroid anticentroid_of(Point before, Point vertex, Point after);

/// The joint at control point `i` of a uniform polynomial cubic, neither the first nor the last of an open one; any
/// `i` of a periodic one, taken mod n. Cost O(1).
Anticentroid anticentroid(const Curve& curve, std::size_t i);

/// The joints in order, i = 1..n-1, or 0..n-1 with wrapped neighbors when periodic. Errors: curve_not_uniform_cubic;
/// curve_rational.
[[nodiscard]] Result<std::vector<Anticentroid>> anticentroids(const Curve& curve);

}  // namespace batten::core
