#include "core/measure/bounds.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "core/base/detail/unit_interval.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/detail/piece_forms.h"

namespace batten::core {

namespace {

bool is_left_of(Point a, Point b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}

bool turns_left(Point a, Point b, Point c) {
    return cross(b - a, c - a) > 0.0;
}

// Extends the chain that begins at `base` of `hull` by `point`, dropping what would not turn left.
void extend_chain(std::vector<Point>& hull, std::size_t base, Point point) {
    while (hull.size() >= base + 2 && !turns_left(hull[hull.size() - 2], hull.back(), point)) hull.pop_back();
    hull.push_back(point);
}

// The control points of one span, in order.
std::vector<Point> control_points_of_span(const Curve& curve, std::size_t span) {
    const auto p = static_cast<std::size_t>(curve.degree());
    std::vector<Point> points;
    points.reserve(p + 1);
    for (std::size_t i = span - p; i <= span; ++i)
        points.push_back(curve.control_points()[i % curve.control_points().size()]);
    return points;
}

// The directions from each point to the next other one, and from the last to the first.
std::vector<Vector> closed_legs(std::span<const Point> points) {
    std::vector<Vector> legs;
    for (std::size_t k = 0; k < points.size(); ++k)
        if (const Vector leg = points[(k + 1) % points.size()] - points[k]; leg != Vector())
            legs.push_back(leg / robust_length(leg));
    return legs;
}

bool contains_span(const Box& box, const Curve& curve, std::size_t span) {
    const auto points = curve.control_points();
    for (std::size_t i = span - static_cast<std::size_t>(curve.degree()); i <= span; ++i)
        if (!box.contains(points[i % points.size()])) return false;
    return true;
}

// The points of a curve that a box must hold; `are_known` is false once one of them cannot be computed.
struct Extremes {
    const Curve& curve;
    Box box{};
    bool are_known = true;

    void include(double u, Side side = Side::right) {
        const Point point = point_at(curve, u, side);
        are_known = are_known && is_finite(point);
        box.include(point);
    }
};

// Takes in the places of `piece` where a coordinate turns back, and where rounding leaves open whether it does.
void include_turns(Extremes& extremes, const PieceForms& piece, const Expression& slope) {
    for (const SignRun& run : sign_runs(piece.forms, slope)) {
        if (run.sign != 0) continue;
        const double middle = run.where.lower + 0.5 * run.where.length();
        for (const double share : {run.where.lower, middle, run.where.upper})
            if (0.0 < share && share < 1.0) extremes.include(from_unit(piece.interval, share));
    }
}

}  // namespace

Box tight_box(const Curve& curve) {
    const KnotVector& knots = curve.knots();
    const auto p = static_cast<std::size_t>(curve.degree());
    Extremes extremes{.curve = curve};
    for (std::size_t s = p; s + p + 1 < knots.size(); ++s) {
        if (!(knots[s] < knots[s + 1])) continue;
        extremes.include(knots[s], Side::right);
        extremes.include(knots[s + 1], Side::left);
    }
    visit_piece_forms(
        curve, 1, [&](std::size_t span) { return !contains_span(extremes.box, curve, span); },
        [&](const PieceForms& piece) {
            include_turns(extremes, piece, hodograph_x);
            include_turns(extremes, piece, hodograph_y);
        });
    return extremes.are_known ? extremes.box : Box{};
}

std::vector<Point> convex_hull(std::span<const Point> points) {
    assert(std::all_of(points.begin(), points.end(), [](Point point) { return is_finite(point); }));
    std::vector<Point> sorted(points.begin(), points.end());
    if (sorted.size() < 3) return sorted;
    std::sort(sorted.begin(), sorted.end(), is_left_of);
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    if (sorted.size() < 3) return sorted;
    std::vector<Point> hull;
    for (const Point& point : sorted) extend_chain(hull, 0, point);
    const std::size_t lower_end = hull.size() - 1;
    for (auto point = sorted.rbegin() + 1; point != sorted.rend(); ++point) extend_chain(hull, lower_end, *point);
    hull.pop_back();
    return hull;
}

bool is_convex(std::span<const Point> points, double angle) {
    constexpr double nearly_back = std::numbers::pi - 1e-9;
    const std::vector<Vector> legs = closed_legs(points);
    double whole = 0.0;
    bool turns_left = false;
    bool turns_right = false;
    for (std::size_t k = 0; k < legs.size(); ++k) {
        const double turn = angle_between(legs[k], legs[(k + 1) % legs.size()]);
        whole += std::abs(turn);
        if (std::abs(turn) > nearly_back) continue;  // to either side
        turns_left = turns_left || turn > angle;
        turns_right = turns_right || turn < -angle;
    }
    return !(turns_left && turns_right) && whole < 3.0 * std::numbers::pi;
}

std::vector<SpanHull> span_hulls(const Curve& curve) {
    const auto knots = curve.knots().values();
    const auto p = static_cast<std::size_t>(curve.degree());
    std::vector<SpanHull> hulls;
    for (std::size_t s = p; s + p + 1 < knots.size(); ++s)
        if (knots[s] < knots[s + 1])
            hulls.push_back({{knots[s], knots[s + 1]}, convex_hull(control_points_of_span(curve, s))});
    return hulls;
}

}  // namespace batten::core
