#include "core/evaluate/detail/subdivide.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/curve/detail/bspline.h"

namespace batten::core {

namespace {

constexpr double noise_in_ulps = 32.0;
constexpr double largest_piece_in_views = 64.0;

// The most that the inner control points count together at any point of the piece. For equal weights it is 1 - 2^(1-p),
// reached in the middle; for others at most that of inner weights all as large, and end weights all as small, as the
// extreme ones.
double inner_share_of_equal_weights(std::size_t count) {
    return 1.0 - std::ldexp(1.0, 2 - static_cast<int>(count));
}

double largest_inner_share(std::span<const HomogeneousPoint> points) {
    const double share = inner_share_of_equal_weights(points.size());
    double largest_inner = 0.0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) largest_inner = std::max(largest_inner, points[i].z);
    const double end_to_inner = std::min(points.front().z, points.back().z) / largest_inner;
    return share / ((1.0 - share) * end_to_inner + share);
}

double largest_coordinate(const Box& box) {
    const double x = std::max(std::abs(box.lower.x), std::abs(box.upper.x));
    return std::max({x, std::abs(box.lower.y), std::abs(box.upper.y)});
}

}  // namespace

std::pair<BezierPiece, BezierPiece> cut_piece(const BezierPiece& piece, double u) {
    assert(piece.interval.lower < u && u < piece.interval.upper);
    const Ratio ratio = ratio_between(piece.interval.lower, piece.interval.upper, u);
    BezierPiece left{{piece.interval.lower, u}, piece.span, {}};
    BezierPiece right{{u, piece.interval.upper}, piece.span, piece.points};
    left.points.reserve(piece.points.size());
    const std::size_t p = piece.points.size() - 1;
    for (std::size_t level = 0; level <= p; ++level) {
        left.points.push_back(right.points.front());
        for (std::size_t i = 0; i + level < p; ++i)
            right.points[i] = blend(right.points[i], right.points[i + 1], ratio);
    }
    return {std::move(left), std::move(right)};
}

double middle(Interval interval) {
    return interval.lower + 0.5 * interval.length();
}

Box control_box(std::span<const HomogeneousPoint> points) {
    Box box;
    for (const HomogeneousPoint& point : points) box.include(project(point));
    return box;
}

double distance_to_segment(Point point, Point a, Point b) {
    const Vector along = b - a;
    const double length_squared = dot(along, along);
    if (length_squared == 0.0) return distance(point, a);
    return distance(point, a + std::clamp(dot(point - a, along) / length_squared, 0.0, 1.0) * along);
}

double chord_deviation_bound(std::span<const HomogeneousPoint> points) {
    const Point a = project(points.front());
    const Point b = project(points.back());
    double largest = 0.0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
        largest = std::max(largest, distance_to_segment(project(points[i]), a, b));
    return largest == 0.0 ? 0.0 : largest * largest_inner_share(points);
}

double chord_deviation_bound(std::span<const Point> points) {
    double largest = 0.0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
        largest = std::max(largest, distance_to_segment(points[i], points.front(), points.back()));
    return largest * inner_share_of_equal_weights(points.size());
}

double rounding_of_halving(const Box& box) {
    return noise_in_ulps * std::numeric_limits<double>::epsilon() * largest_coordinate(box);
}

bool is_divisible(Interval interval, const Box& box) {
    const double half = middle(interval);
    return interval.lower < half && half < interval.upper && std::isfinite(largest_coordinate(box));
}

bool is_small_beside(const Box& box, const Box& view, double tolerance) {
    const Vector piece_size = box.size();
    const Vector view_size = view.size();
    const double largest = std::max(largest_piece_in_views * std::max(view_size.x, view_size.y), tolerance);
    return std::max(piece_size.x, piece_size.y) <= largest;
}

}  // namespace batten::core
