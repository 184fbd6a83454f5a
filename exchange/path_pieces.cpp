#include "exchange/path_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/evaluate/bezier_pieces.h"

namespace batten::exchange {

namespace {

using core::Point;
using core::Vector;

constexpr std::size_t most_order = core::max_degree + 1;

// C(n, k), exact below 2^53.
double binomial_of(std::size_t n, std::size_t k) {
    double value = 1.0;
    for (std::size_t i = 1; i <= k; ++i) value = value * static_cast<double>(n - k + i) / static_cast<double>(i);
    return std::round(value);
}

// A rational piece as (w x, w y, w), seen from a point near it.
struct RationalPiece {
    std::array<core::HomogeneousPoint, most_order> points{};
    std::size_t degree = 1;

    Point at(std::size_t i) const { return core::project(points[i]); }
};

RationalPiece seen_from_near(std::span<const Point> points, std::span<const double> weights) {
    RationalPiece piece{.degree = points.size() - 1};
    const double heaviest = weights.empty() ? 1.0 : *std::max_element(weights.begin(), weights.end());
    for (std::size_t i = 0; i < points.size(); ++i)
        piece.points[i] =
            core::lift(core::seen_from(points[i], points[0]), weights.empty() ? 1.0 : weights[i] / heaviest);
    return piece;
}

// The cubic with the ends of `piece` and its derivatives there.
std::array<Point, 4> hermite_cubic(const RationalPiece& piece) {
    const std::size_t p = piece.degree;
    const double third = static_cast<double>(p) / 3.0;
    const Point start = piece.at(0);
    const Point end = piece.at(p);
    const double first = third * (piece.points[1].z / piece.points[0].z);
    const double last = third * (piece.points[p - 1].z / piece.points[p].z);
    return {start, start + first * (piece.at(1) - start), end + last * (piece.at(p - 1) - end), end};
}

// A bound of the distance at equal parameters: with the weights as denominator the difference is the sum of
// B_i B_j w_i (P_i - Q_j), whose control points bound it.
double distance_bound(const RationalPiece& piece, const std::array<Point, 4>& cubic) {
    const std::size_t p = piece.degree;
    double lightest = std::numeric_limits<double>::infinity();
    std::array<Vector, most_order + 3> sums{};
    for (Vector& sum : sums) sum = {0.0, 0.0};
    for (std::size_t i = 0; i <= p; ++i) {
        const double w = piece.points[i].z;
        lightest = std::min(lightest, w);
        const double of_i = binomial_of(p, i) * w;
        for (std::size_t j = 0; j <= 3; ++j) sums[i + j] += (of_i * binomial_of(3, j)) * (piece.at(i) - cubic[j]);
    }
    double largest = 0.0;
    for (std::size_t k = 0; k <= p + 3; ++k) {
        const double size = core::robust_length(sums[k]) / binomial_of(p + 3, k);
        if (!(size <= largest)) largest = size;
    }
    return largest / lightest;
}

// Both halves, by de Casteljau's triangle.
std::array<RationalPiece, 2> halves(const RationalPiece& piece) {
    const std::size_t p = piece.degree;
    std::array<RationalPiece, 2> both{RationalPiece{.degree = p}, RationalPiece{.degree = p}};
    auto row = piece.points;
    for (std::size_t r = 0; r <= p; ++r) {
        both[0].points[r] = row[0];
        both[1].points[p - r] = row[p - r];
        for (std::size_t i = 0; i + r < p; ++i) row[i] = 0.5 * row[i] + 0.5 * row[i + 1];
    }
    return both;
}

class CubicPieces {
  public:
    CubicPieces(double tolerance, PathPieces& result) : tolerance_(tolerance), result_(result) {}

    void add(const RationalPiece& piece, Point origin, int halvings_left) {
        const std::array<Point, 4> cubic = hermite_cubic(piece);
        const double bound = distance_bound(piece, cubic);
        const bool may_halve = halvings_left > 0 && std::isfinite(bound) && result_.pieces.size() < most_path_pieces;
        if (!(bound <= tolerance_) && may_halve) {
            for (const RationalPiece& half : halves(piece)) add(half, origin, halvings_left - 1);
            return;
        }
        PathPiece written{.degree = 3};
        for (std::size_t i = 0; i < cubic.size(); ++i) written.points[i] = origin + core::vector_to(cubic[i]);
        result_.pieces.push_back(written);
        result_.error = std::isnan(bound) ? std::numeric_limits<double>::infinity() : std::max(result_.error, bound);
    }

  private:
    double tolerance_;
    PathPieces& result_;
};

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

}  // namespace

PathPieces path_pieces(const core::Curve& curve, double tolerance) {
    constexpr int most_halvings = 20;
    const core::BezierPieces pieces = core::bezier_pieces(curve);
    const int p = curve.degree();
    PathPieces result;
    result.pieces.reserve(pieces.size());
    CubicPieces cubics(tolerance, result);
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
            cubics.add(seen_from_near(points, weights), points[0], most_halvings);
        // Neighbors agree to the last bit, whatever rounding made of their ends.
        const bool is_joined = first > 0 && !is_torn;
        result.pieces[first].points[0] = is_joined ? result.pieces[first - 1].end() : points.front();
        result.pieces.back().set_end(points.back());
    }
    if (curve.is_periodic()) result.pieces.back().set_end(result.pieces.front().start());
    return result;
}

}  // namespace batten::exchange
