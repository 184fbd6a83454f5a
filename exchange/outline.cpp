#include "exchange/outline.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

namespace batten::exchange {

namespace {

using core::Box;
using core::Point;

constexpr std::size_t most_outline_degree = 3;

// The points of one piece and their weights, in a degree that grows.
struct RaisedPiece {
    std::array<Point, most_outline_degree + 1> points{};
    std::array<double, most_outline_degree + 1> weights{1.0, 1.0, 1.0, 1.0};
    std::size_t degree = 1;

    void raise_to(std::size_t wanted) {
        if (degree == 1 && wanted == 2) {
            points[2] = points[1];
            points[1] = core::middle(points[0], points[2]);
        } else if (degree == 1 && wanted == 3) {
            const core::Vector third = (points[1] - points[0]) / 3.0;
            points = {points[0], points[0] + third, points[1] - third, points[1]};
        } else if (degree == 2 && wanted == 3) {
            const double w = weights[1];
            const double share = 2.0 * w / (1.0 + 2.0 * w);
            points = {points[0], points[0] + share * (points[1] - points[0]),
                      points[2] + share * (points[1] - points[2]), points[2]};
            weights = {1.0, (1.0 + 2.0 * w) / 3.0, (1.0 + 2.0 * w) / 3.0, 1.0};
        }
        degree = std::max(degree, wanted);
    }
};

std::vector<double> piece_knots(std::size_t degree, std::size_t count, bool is_closed) {
    std::vector<double> knots;
    knots.reserve(degree * (count + 1) + 2);
    for (std::size_t k = 0; k <= count; ++k)
        knots.insert(knots.end(), is_closed && k == count ? 1 : degree, static_cast<double>(k));
    if (is_closed) return knots;
    knots.insert(knots.begin(), 0.0);
    knots.push_back(static_cast<double>(count));
    return knots;
}

}  // namespace

Outline::Outline(Point start) : points_{start} {}

void Outline::append(Piece piece, std::initializer_list<Point> points) {
    assert(!is_closed_);
    if (std::all_of(points.begin(), points.end(), [this](Point point) { return point == end(); })) return;
    pieces_.push_back(piece);
    points_.insert(points_.end(), points);
}

void Outline::line_to(Point end) {
    append({.degree = 1}, {end});
}

void Outline::quadratic_to(Point corner, Point end) {
    append({.degree = 2}, {corner, end});
}

void Outline::conic_to(Point corner, double weight, Point end) {
    append({.degree = 2, .weight = weight}, {corner, end});
}

void Outline::cubic_to(Point first, Point second, Point end) {
    append({.degree = 3}, {first, second, end});
}

void Outline::close() {
    constexpr double rounded_steps = 1e-6;
    constexpr double rounded_doubles = 1e-13;
    if (is_empty()) return;
    Box box;
    double farthest = 0.0;
    for (const Point point : points_) {
        box.include(point);
        farthest = std::max({farthest, std::abs(point.x), std::abs(point.y)});
    }
    double gap = core::robust_length(end() - start());
    if (gap > rounded_steps * std::max(box.size().x, box.size().y) || !std::isfinite(gap) || pieces_.size() == 1) {
        line_to(start());
        gap = 0.0;
    }
    points_.back() = start();
    is_closed_ = true;
    closing_gap_ = gap > rounded_doubles * farthest ? gap : 0.0;
}

core::Result<core::Curve> Outline::curve() const {
    assert(!is_empty());
    std::size_t p = 1;
    for (const Piece& piece : pieces_) p = std::max<std::size_t>(p, piece.degree);
    core::CurveDefinition definition{
        .degree = static_cast<int>(p), .knots = piece_knots(p, pieces_.size(), is_closed_), .periodic = is_closed_};
    definition.points.reserve(p * pieces_.size() + 1);
    definition.weights.reserve(p * pieces_.size() + 1);
    const auto add = [&](const RaisedPiece& raised, std::size_t first) {
        definition.points.insert(definition.points.end(), raised.points.begin() + first, raised.points.begin() + p + 1);
        definition.weights.insert(definition.weights.end(), raised.weights.begin() + first,
                                  raised.weights.begin() + p + 1);
    };
    std::size_t at = 0;
    for (const Piece& piece : pieces_) {
        RaisedPiece raised{.degree = piece.degree};
        std::copy_n(points_.begin() + static_cast<std::ptrdiff_t>(at), piece.degree + 1, raised.points.begin());
        if (piece.degree == 2) raised.weights[1] = piece.weight;
        raised.raise_to(p);
        add(raised, at == 0 ? 0 : 1);
        at += piece.degree;
    }
    if (is_closed_) {
        // The last point is the first one, and the period's first knot belongs to the point p - 1.
        definition.points.pop_back();
        definition.weights.pop_back();
        const auto turn = static_cast<std::ptrdiff_t>(p) - 1;
        std::rotate(definition.points.begin(), definition.points.end() - turn, definition.points.end());
        std::rotate(definition.weights.begin(), definition.weights.end() - turn, definition.weights.end());
    } else {
        definition.kind = pieces_.size() == 1 ? core::KnotKind::bezier : core::KnotKind::piecewise_bezier;
    }
    return core::Curve::make(std::move(definition));
}

}  // namespace batten::exchange
