#include "core/refine/extend.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/detail/quadrature.h"
#include "core/evaluate/evaluate.h"
#include "core/evaluate/tangent.h"
#include "core/measure/arc_length.h"
#include "core/refine/clamping.h"
#include "core/refine/detail/carried_point.h"
#include "core/refine/detail/end_knots.h"
#include "core/refine/detail/largest_possible.h"

namespace batten::core {

namespace {

Result<void> check_added_length(double length) {
    if (length > 0.0 && std::isfinite(length)) return {};
    return refuse({.code = CurveErrorCode::length_not_positive, .value = length});
}

double moved_out(double u, CurveEnd end, double by) {
    return end == CurveEnd::start ? u - by : u + by;
}

Result<Curve> with_end_at(const Curve& curve, CurveEnd end, double u) {
    PreciselyCarriedSpline spline = clamped_at_start(seen_from_end(carried_precisely(curve), end));
    const double target = end == CurveEnd::end ? -u : u;
    exchange_start_knots(spline, std::vector(spline.p, target));
    std::fill(spline.knots.begin(), spline.knots.begin() + static_cast<std::ptrdiff_t>(spline.p) + 1, target);
    return settled(curve, seen_from_end(std::move(spline), end), curve.knots().kind());
}

// The curve over a longer domain, or that it runs out of positive weights.
Result<Curve> longer_if_possible(const Curve& curve, CurveEnd end, double by) {
    const double old = parameter_of(curve.domain(), end);
    const double target = moved_out(old, end, by);
    if (target == old) return refuse({.code = CurveErrorCode::range_empty, .lower = old, .upper = target});
    return with_end_at(curve, end, target);
}

double speed_at(const Curve& curve, CurveEnd end) {
    return length(derivatives_at(curve, parameter_of(curve.domain(), end), 1)[1]);
}

// No finer than lengths are measured.
constexpr double length_accuracy = 1e-12;

// Where the parameter cannot grow further because a weight runs out, this part of it is as near as is looked.
constexpr double closeness_to_failure = 1e-3;

double length_over(const Curve& curve, Interval range) {
    const auto parts = integrate_adaptively<double>(
        std::vector{PieceRange{0, range}},
        [&](std::size_t, double u) { return length(derivatives_at(curve, u, 1)[1]); },
        [](std::size_t, const RulePair<double>& rules) { return std::abs(rules.kronrod - rules.gauss); },
        [](double error, double sum) { return !(error > length_accuracy * sum); });
    double length = 0.0;
    for (const auto& part : parts) length += part.rules.kronrod;
    return length;
}

// The arc length that is added at `end` to make `longer` of `curve`.
double added_length(const Curve& curve, const Curve& longer, CurveEnd end) {
    const double old = parameter_of(curve.domain(), end);
    const double tip = parameter_of(longer.domain(), end);
    return length_over(longer, {std::min(old, tip), std::max(old, tip)});
}

// That so much `length` is too much, where a domain longer by `most` is about the longest.
Result<Curve> too_long(const Curve& curve, CurveEnd end, double length, double most, CurveError error) {
    if (!is_carried_too_far(error) || !(most > 0.0)) return refuse(error);
    const auto longest = longer_if_possible(curve, end, most);
    if (!longest) return refuse(error);
    return refuse({.code = CurveErrorCode::extension_too_far,
                   .value = length,
                   .upper = rounded_down(added_length(curve, *longest, end))});
}

// Newton's iteration in a bracket that shrinks: the added length grows with the parameter.
Result<Curve> longer_by(const Curve& curve, CurveEnd end, double length) {
    Interval bracket{0.0, std::numeric_limits<double>::infinity()};
    double by = length / speed_at(curve, end);
    for (;;) {
        auto longer = longer_if_possible(curve, end, by);
        const bool is_narrow = bracket.upper - bracket.lower <= closeness_to_failure * bracket.upper;
        if (!longer && std::isfinite(bracket.upper) && is_narrow)
            return too_long(curve, end, length, bracket.lower, longer.error());
        const double found = longer ? added_length(curve, *longer, end) : std::numeric_limits<double>::infinity();
        if (std::abs(found - length) <= length_accuracy * length) return longer;
        (found < length ? bracket.lower : bracket.upper) = by;
        double next = std::isinf(bracket.upper) ? 2.0 * by : bracket.lower + 0.5 * bracket.length();
        const double newton = longer ? by + (length - found) / speed_at(*longer, end) : next;
        if (bracket.lower < newton && newton < bracket.upper && newton < 4.0 * by) next = newton;
        if (next == bracket.lower || next == bracket.upper)
            return longer ? longer : too_long(curve, end, length, bracket.lower, longer.error());
        by = next;
    }
}

void add_straight_piece(CurveDefinition& definition, CurveEnd end, Vector step, double u) {
    const auto p = static_cast<std::size_t>(definition.degree);
    const auto at_start = end == CurveEnd::start;
    const Point from = at_start ? definition.points.front() : definition.points.back();
    const double weight = at_start ? definition.weights.front() : definition.weights.back();
    const auto place = [&](auto& values) { return at_start ? values.begin() : values.end(); };
    for (std::size_t i = 1; i <= p; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(p);
        definition.points.insert(place(definition.points), from + share * step);
        definition.weights.insert(place(definition.weights), weight);
    }
    definition.knots.erase(at_start ? definition.knots.begin() : definition.knots.end() - 1);
    definition.knots.insert(place(definition.knots), p + 1, u);
}

}  // namespace

Result<Curve> extend_parameter(const Curve& curve, CurveEnd end, double by) {
    if (const auto check = check_added_length(by); !check) return refuse(check.error());
    if (curve.is_periodic()) return refuse({.code = CurveErrorCode::curve_periodic});
    auto longer = longer_if_possible(curve, end, by);
    if (longer || !is_carried_too_far(longer.error())) return longer;
    const double most =
        largest_possible(by, [&](double part) { return longer_if_possible(curve, end, part).has_value(); });
    if (!(most > 0.0)) return longer;
    return refuse({.code = CurveErrorCode::extension_too_far, .value = by, .upper = most});
}

Result<Curve> extend_length(const Curve& curve, CurveEnd end, double length) {
    if (const auto check = check_added_length(length); !check) return refuse(check.error());
    if (curve.is_periodic()) return refuse({.code = CurveErrorCode::curve_periodic});
    if (!curvature_at(curve, parameter_of(curve.domain(), end)))
        return refuse({.code = CurveErrorCode::curve_stands_still, .value = parameter_of(curve.domain(), end)});
    return longer_by(curve, end, length);
}

Result<Curve> extend_straight(const Curve& curve, CurveEnd end, double length) {
    if (const auto check = check_added_length(length); !check) return refuse(check.error());
    const auto clamped = clamp(curve, end);
    if (!clamped) return refuse(clamped.error());
    const double old = parameter_of(curve.domain(), end);
    const auto tangent = tangent_at(*clamped, old);
    if (!tangent) return refuse({.code = CurveErrorCode::curve_stands_still, .value = old});
    double speed = speed_at(*clamped, end);
    if (!(speed > 0.0)) speed = arc_length(*clamped).value / clamped->domain().length();
    const double target = moved_out(old, end, length / speed);
    if (target == old) return refuse({.code = CurveErrorCode::range_empty, .lower = old, .upper = target});
    CurveDefinition definition = clamped->definition();
    add_straight_piece(definition, end, (end == CurveEnd::start ? -length : length) * *tangent, target);
    return Curve::make(std::move(definition));
}

}  // namespace batten::core
