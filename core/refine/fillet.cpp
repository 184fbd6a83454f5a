#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/evaluate/evaluate.h"
#include "core/measure/continuity.h"
#include "core/refine/corner_bridge.h"
#include "core/refine/detail/largest_possible.h"
#include "core/refine/detail/touching_circle.h"

namespace batten::core {

namespace {

// Radii that are tried to find out what is allowed, as parts of the size.
constexpr double least_radius = 1e-7;
constexpr double largest_radius = 1e4;
constexpr int radii_per_decade = 8;
constexpr int halvings = 40;

// Of longer curves it takes too long.
constexpr std::size_t most_stretches = 20000;

// Arcs that turn by less, in radians, round no corner: so far a smooth knot may be off.
constexpr double least_sweep = ContinuityTolerances{}.angle;

struct FilletPick {
    PickedPlace first;
    PickedPlace second;
    bool is_one_curve;
    bool is_closed;  // the one curve

    FilletPick(PickedPlace a, PickedPlace b)
        : first(a),
          second(b),
          is_one_curve(&a.curve == &b.curve),
          is_closed(is_one_curve && core::is_closed(a.curve)) {}
};

// A touching circle as an arc of at most a half turn from the one curve to the other.
struct TouchingArc {
    TouchingCircle circle;
    double begin = 0.0;  // the angle at which it leaves the first curve
    double sweep = 0.0;  // positive to the left
    CurveEnd kept_of_first = CurveEnd::start;
    CurveEnd kept_of_second = CurveEnd::end;
};

TouchingArc arc_on(const TouchingCircle& circle) {
    const Vector from = circle.on_first - circle.center;
    const Vector to = circle.on_second - circle.center;
    TouchingArc arc{circle, std::atan2(from.y, from.x), angle_between(from, to)};
    const double turn = arc.sweep < 0.0 ? -1.0 : 1.0;
    const bool leaves_forward = turn * dot(turned_left(from), circle.along_first) > 0.0;
    const bool arrives_forward = turn * dot(turned_left(to), circle.along_second) > 0.0;
    arc.kept_of_first = leaves_forward ? CurveEnd::start : CurveEnd::end;
    arc.kept_of_second = arrives_forward ? CurveEnd::end : CurveEnd::start;
    return arc;
}

bool leaves_nothing(const Curve& curve, CurveEnd kept, double u) {
    return !is_closed(curve) && u == parameter_of(curve.domain(), kept);
}

bool is_allowed(const FilletPick& pick, const TouchingArc& arc) {
    if (!(std::abs(arc.sweep) > least_sweep)) return false;
    if (pick.is_one_curve) {
        const bool runs_on = arc.kept_of_first == CurveEnd::start && arc.kept_of_second == CurveEnd::end;
        if (!runs_on || (!pick.is_closed && !(arc.circle.u < arc.circle.v))) return false;
        return pick.is_closed || !(leaves_nothing(pick.first.curve, CurveEnd::start, arc.circle.u) ||
                                   leaves_nothing(pick.first.curve, CurveEnd::end, arc.circle.v));
    }
    return !leaves_nothing(pick.first.curve, arc.kept_of_first, arc.circle.u) &&
           !leaves_nothing(pick.second.curve, arc.kept_of_second, arc.circle.v);
}

std::optional<TouchingArc> best_arc(const FilletPick& pick, const TouchingFinder& finder, double radius) {
    const Point near_first = point_at(pick.first.curve, pick.first.u);
    const Point near_second = point_at(pick.second.curve, pick.second.u);
    std::optional<TouchingArc> best;
    double least = 0.0;
    for (const TouchingCircle& circle : finder.circles(radius)) {
        const TouchingArc arc = arc_on(circle);
        if (!is_allowed(pick, arc)) continue;
        const double cost = robust_length(circle.on_first - near_first) + robust_length(circle.on_second - near_second);
        if (best && !(cost < least)) continue;
        best = arc;
        least = cost;
    }
    return best;
}

// Quadratic pieces of at most 90 degrees, whose ends are those on the curves bit by bit.
Result<Curve> curve_of(const TouchingArc& arc, Point from, Point to, double radius) {
    constexpr double quarter = 0.5 * std::numbers::pi * (1.0 + 1e-12);
    const auto count = static_cast<int>(std::ceil(std::abs(arc.sweep) / quarter));
    const double half = 0.5 * arc.sweep / count;
    CurveDefinition definition{
        .degree = 2, .knots = {0.0}, .kind = count == 1 ? KnotKind::bezier : KnotKind::piecewise_bezier};
    const auto place = [&](double angle, double distance) {
        return arc.circle.center + distance * Vector(std::cos(angle), std::sin(angle));
    };
    for (int k = 0; k < count; ++k) {
        const double angle = arc.begin + 2.0 * k * half;
        definition.knots.insert(definition.knots.end(), 2, static_cast<double>(k) / count);
        definition.points.push_back(k == 0 ? from : place(angle, radius));
        definition.weights.push_back(1.0);
        definition.points.push_back(place(angle + half, radius / std::cos(half)));
        definition.weights.push_back(std::cos(half));
    }
    definition.knots.insert(definition.knots.end(), 3, 1.0);
    definition.points.push_back(to);
    definition.weights.push_back(1.0);
    return Curve::make(std::move(definition));
}

// The radii between which there is an arc, around the one that is nearest to `wanted` among those tried.
std::optional<Interval> possible_radii(const FilletPick& pick, const TouchingFinder& finder, double wanted) {
    const auto is_possible = [&](double radius) { return best_arc(pick, finder, radius).has_value(); };
    const double step = std::pow(10.0, 1.0 / radii_per_decade);
    std::optional<double> nearest;
    for (double radius = least_radius * finder.size(); radius <= largest_radius * finder.size(); radius *= step)
        if (is_possible(radius) &&
            (!nearest || std::abs(std::log(radius / wanted)) < std::abs(std::log(*nearest / wanted))))
            nearest = radius;
    if (!nearest) return std::nullopt;
    const auto edge = [&](double factor) {
        double inside = *nearest;
        double outside = *nearest;
        do {
            inside = outside;
            outside *= factor;
            if (outside < least_radius * finder.size()) return 0.0;
        } while (is_possible(outside) && outside < 2.0 * largest_radius * finder.size());
        for (int k = 0; k < halvings; ++k) {
            const double between = std::sqrt(inside * outside);
            (is_possible(between) ? inside : outside) = between;
        }
        return inside;
    };
    return Interval{edge(1.0 / step), edge(step)};
}

// With so few digits that it can be read.
double readable_least(const FilletPick& pick, const TouchingFinder& finder, double least) {
    const double below = rounded_down((1.0 + 1e-9) * least);
    return best_arc(pick, finder, below) ? below : rounded_down(1.001 * least);
}

CurveError why_no_fillet(const FilletPick& pick, const TouchingFinder& finder, double radius) {
    const bool has_size = least_radius * finder.size() > 0.0 && std::isfinite(largest_radius * finder.size());
    if (!has_size || finder.stretch_count() > most_stretches) return {.code = CurveErrorCode::no_fillet};
    const auto possible = possible_radii(pick, finder, radius);
    if (!possible) return {.code = CurveErrorCode::no_fillet};
    const double upper = rounded_down(possible->upper);
    if (possible->lower == 0.0) return {.code = CurveErrorCode::fillet_too_large, .value = radius, .upper = upper};
    return {.code = CurveErrorCode::fillet_not_possible,
            .value = radius,
            .lower = readable_least(pick, finder, possible->lower),
            .upper = upper};
}

}  // namespace

Result<CornerBridge> fillet(PickedPlace first, PickedPlace second, double radius) {
    if (!(radius > 0.0) || !std::isfinite(radius))
        return refuse({.code = CurveErrorCode::length_not_positive, .value = radius});
    const FilletPick pick(first, second);
    const TouchingFinder finder(first.curve, second.curve);
    const auto arc = best_arc(pick, finder, radius);
    if (!arc) return refuse_computed(why_no_fillet(pick, finder, radius));
    const auto bridge =
        curve_of(*arc, point_at(first.curve, arc->circle.u), point_at(second.curve, arc->circle.v), radius);
    if (!bridge) return refuse(bridge.error());
    return CornerBridge{*bridge, arc->circle.u, arc->circle.v, arc->kept_of_first, arc->kept_of_second};
}

}  // namespace batten::core
