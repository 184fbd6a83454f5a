#include "exchange/dxf/bulged_polyline.h"

#include <cmath>

#include "core/make/shapes.h"
#include "exchange/outline.h"

namespace batten::exchange {

namespace {

using core::Point;
using core::Vector;

struct Leg {
    Point from{};
    Point to{};
    double bulge = 0.0;
};

// Half of the chord, turned to the side on which an arc to the left lies.
Vector half_to_the_right(const Leg& leg) {
    const Vector d = leg.to - leg.from;
    return 0.5 * Vector{d.y, -d.x};
}

// With b = tan(a/4) of the angle a, tan(a/2) = 2b / (1 - b^2) and cos(a/2) = (1 - b^2) / (1 + b^2).
void add_leg(Outline& outline, const Leg& leg) {
    constexpr double bulge_of_right_angle = 0.41421356237309509 * (1.0 + 1e-12);
    const double b = leg.bulge;
    if (b == 0.0) return outline.line_to(leg.to);
    const Point middle = core::middle(leg.from, leg.to);
    if (std::abs(b) > bulge_of_right_angle) {
        const Point top = middle + b * half_to_the_right(leg);
        const double half = b / (1.0 + std::hypot(1.0, b));
        add_leg(outline, {leg.from, top, half});
        return add_leg(outline, {top, leg.to, half});
    }
    const double square = b * b;
    outline.conic_to(middle + (2.0 * b / (1.0 - square)) * half_to_the_right(leg), (1.0 - square) / (1.0 + square),
                     leg.to);
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

}  // namespace

core::Result<core::Curve> bulged_polyline(std::span<const Point> points, std::span<const double> bulges,
                                          bool is_closed) {
    if (points.empty()) return core::polyline(points);
    bool has_arcs = false;
    visit_legs(points, bulges, is_closed, [&](const Leg& leg) { has_arcs = has_arcs || leg.bulge != 0.0; });
    if (!has_arcs) return straight(points, bulges, is_closed);
    Outline outline(points.front());
    visit_legs(points, bulges, is_closed, [&](const Leg& leg) { add_leg(outline, leg); });
    if (is_closed) outline.close();
    return outline.curve();
}

}  // namespace batten::exchange
