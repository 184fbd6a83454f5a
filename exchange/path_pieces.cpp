#include "exchange/path_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/evaluate/bezier_pieces.h"
#include "exchange/cubic_pieces.h"

namespace batten::exchange {

namespace {

using core::Point;
using core::Vector;

// The piece as an arc of a circle where nothing but rounding is against it: its legs are equally long, and the weight
// is the sine of half the angle between them.
std::optional<PathPiece> circular_piece(std::span<const Point> points, std::span<const double> weights) {
    constexpr double rounding = 16.0 * std::numeric_limits<double>::epsilon();
    const Vector first = points[1] - points[0];
    const Vector second = points[2] - points[1];
    const double leg = core::robust_length(first);
    const double half_chord = core::robust_length(points[2] - points[0]) / 2.0;
    const double height = core::robust_length(points[1] - core::middle(points[0], points[2]));
    double farthest = 0.0;
    for (const Point point : points) farthest = std::max({farthest, std::abs(point.x), std::abs(point.y)});
    if (!(leg > 0.0 && height > 0.0 && half_chord > 0.0) || !std::isfinite(leg + farthest)) return std::nullopt;
    const double weight = weights[1] / (std::sqrt(weights[0]) * std::sqrt(weights[2]));
    const double share = rounding * (1.0 + farthest / leg);
    // Where the chord is short the angle is known less well by it.
    const bool is_circle =
        std::abs(core::robust_length(second) - leg) <= share * leg && std::abs(weight - half_chord / leg) <= share;
    if (!is_circle) return std::nullopt;
    return PathPiece{.degree = 0,
                     .points = {points[0], points[2]},
                     .radius = leg * half_chord / height,
                     .is_counterclockwise = core::cross(first, second) > 0.0};
}

PathPiece plain_piece(std::span<const Point> points) {
    PathPiece piece{.degree = static_cast<int>(points.size()) - 1};
    std::copy(points.begin(), points.end(), piece.points.begin());
    return piece;
}

void add_cubics(PathPieces& result, std::span<const Point> points, std::span<const double> weights, double tolerance) {
    const bool is_full = result.pieces.size() >= most_path_pieces;
    const CubicPieces cubics = cubic_pieces(points, weights, is_full ? HUGE_VAL : tolerance);
    for (const CubicPiece& cubic : cubics.pieces)
        result.pieces.push_back({.degree = cubic.degree, .points = cubic.points});
    result.error = std::max(result.error, cubics.error);
}

}  // namespace

PathPieces path_pieces(const core::Curve& curve, double tolerance) {
    const core::BezierPieces pieces = core::bezier_pieces(curve);
    const int p = curve.degree();
    PathPieces result;
    result.pieces.reserve(pieces.size());
    const bool is_torn = curve.is_torn();
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const std::span<const Point> points = pieces.points(k);
        const std::span<const double> weights = pieces.weights(k);
        const std::size_t first = result.pieces.size();
        if (p == 1 || (p <= 3 && weights.empty()))
            result.pieces.push_back(plain_piece(points));
        else if (const auto arc = p == 2 ? circular_piece(points, weights) : std::nullopt)
            result.pieces.push_back(*arc);
        else
            add_cubics(result, points, weights, tolerance);
        // Neighbors agree to the last bit, whatever rounding made of their ends.
        const bool is_joined = first > 0 && !is_torn;
        result.pieces[first].points[0] = is_joined ? result.pieces[first - 1].end() : points.front();
        result.pieces.back().set_end(points.back());
    }
    if (curve.is_periodic()) result.pieces.back().set_end(result.pieces.front().start());
    return result;
}

}  // namespace batten::exchange
