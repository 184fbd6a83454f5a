#include "exchange/dxf/bulged_polyline.h"

#include <algorithm>
#include <cmath>

#include "core/curve/knot_kinds.h"
#include "core/make/shapes.h"

namespace batten::exchange {

namespace {

using core::Point;
using core::Vector;

struct Leg {
    Point from{};
    Point to{};
    double bulge = 0.0;
};

// The control points of quadratic pieces, one after the other.
struct Pieces {
    std::vector<Point> points{};
    std::vector<double> weights{};

    void add(Point point, double weight) {
        points.push_back(point);
        weights.push_back(weight);
    }
};

// Half of the chord, turned to the side on which an arc to the left lies.
Vector half_to_the_right(const Leg& leg) {
    const Vector d = leg.to - leg.from;
    return 0.5 * Vector{d.y, -d.x};
}

// All but the first point. With b = tan(a/4) of the angle a, tan(a/2) = 2b / (1 - b^2) and cos(a/2) = (1 - b^2) / (1 +
// b^2).
void add_leg(Pieces& pieces, const Leg& leg) {
    constexpr double bulge_of_right_angle = 0.41421356237309509 * (1.0 + 1e-12);
    const double b = leg.bulge;
    const Point middle = core::middle(leg.from, leg.to);
    if (std::abs(b) > bulge_of_right_angle) {
        const Point top = middle + b * half_to_the_right(leg);
        const double half = b / (1.0 + std::hypot(1.0, b));
        add_leg(pieces, {leg.from, top, half});
        return add_leg(pieces, {top, leg.to, half});
    }
    const double square = b * b;
    pieces.add(middle + (2.0 * b / (1.0 - square)) * half_to_the_right(leg), (1.0 - square) / (1.0 + square));
    pieces.add(leg.to, 1.0);
}

// Calls `visit` with each leg of some length.
template <class Visit>
void visit_legs(std::span<const Point> points, std::span<const double> bulges, bool is_closed, Visit visit) {
    const std::size_t count = is_closed ? points.size() : points.size() - 1;
    for (std::size_t i = 0; i < count; ++i) {
        const Leg leg{points[i], points[(i + 1) % points.size()], bulges[i]};
        if (leg.from != leg.to) visit(leg);
    }
}

core::Result<core::Curve> straight(std::span<const Point> points, std::span<const double> bulges, bool is_closed) {
    std::vector<Point> corners;
    Point end = points.front();
    visit_legs(points, bulges, is_closed, [&](const Leg& leg) {
        corners.push_back(leg.from);
        end = leg.to;
    });
    constexpr std::size_t least_closed = 3;
    const bool can_be_closed = is_closed && corners.size() >= least_closed;
    if (!can_be_closed) corners.push_back(end);
    return core::polyline(corners, can_be_closed);
}

core::Result<core::Curve> closed_curve(Pieces pieces) {
    const std::size_t count = pieces.points.size() / 2;
    std::vector<double> period;
    for (std::size_t k = 0; k < count; ++k) period.insert(period.end(), 2, static_cast<double>(k));
    period.push_back(static_cast<double>(count));
    // Control point i belongs to the knots i-1 and i of the period, so that the first of them is the last inner one.
    pieces.points.pop_back();
    pieces.weights.pop_back();
    std::rotate(pieces.points.begin(), pieces.points.end() - 1, pieces.points.end());
    std::rotate(pieces.weights.begin(), pieces.weights.end() - 1, pieces.weights.end());
    return core::KnotVector::make_periodic(2, std::move(period)).and_then([&](core::KnotVector knots) {
        return core::Curve::make(std::move(knots), std::move(pieces.points), std::move(pieces.weights));
    });
}

core::Result<core::Curve> open_curve(Pieces pieces) {
    const auto count = static_cast<double>(pieces.points.size() / 2);
    return core::make_knots(core::KnotKind::piecewise_bezier, 2, pieces.points.size(), {0.0, count})
        .and_then([&](core::KnotVector knots) {
            return core::Curve::make(std::move(knots), std::move(pieces.points), std::move(pieces.weights));
        });
}

}  // namespace

core::Result<core::Curve> bulged_polyline(std::span<const Point> points, std::span<const double> bulges,
                                          bool is_closed) {
    if (points.empty()) return core::polyline(points);
    Pieces pieces;
    bool has_arcs = false;
    visit_legs(points, bulges, is_closed, [&](const Leg& leg) { has_arcs = has_arcs || leg.bulge != 0.0; });
    if (!has_arcs) return straight(points, bulges, is_closed);
    visit_legs(points, bulges, is_closed, [&](const Leg& leg) {
        if (pieces.points.empty()) pieces.add(leg.from, 1.0);
        add_leg(pieces, leg);
    });
    return is_closed ? closed_curve(std::move(pieces)) : open_curve(std::move(pieces));
}

}  // namespace batten::exchange
