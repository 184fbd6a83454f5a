#include "core/refine/knot_refinement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/detail/are_finite.h"
#include "core/curve/detail/boehm.h"
#include "core/curve/detail/edit_checks.h"
#include "core/curve/detail/trusted.h"
#include "core/refine/detail/curve_arrays.h"

namespace batten::core {

namespace {

Result<void> check_multiplicity(const KnotVector& knots, double u, std::size_t times, Tears tears) {
    const Interval domain = knots.domain();
    const bool is_end = u == domain.lower || u == domain.upper;
    const bool may_tear = !knots.is_periodic() && (is_end || tears == Tears::allow);
    const int most = knots.degree() + (may_tear ? 1 : 0);
    if (static_cast<int>(times) <= most - knots.multiplicity(u)) return {};
    return refuse({.code = CurveErrorCode::multiplicity_full, .value = u, .upper = static_cast<double>(most)});
}

// `added` is ascending. The seam of a period is one knot with two names.
Result<void> check_added(const KnotVector& knots, std::span<const double> added, Tears tears) {
    const auto count = [&](double u) {
        const auto run = std::equal_range(added.begin(), added.end(), u);
        return static_cast<std::size_t>(run.second - run.first);
    };
    const Interval domain = knots.domain();
    for (std::size_t i = 0; i < added.size(); ++i) {
        const double u = added[i];
        if (const auto check = check_in_domain(knots, u); !check) return check;
        if (i > 0 && u == added[i - 1]) continue;
        const bool is_seam = knots.is_periodic() && (u == domain.lower || u == domain.upper);
        const std::size_t times = is_seam ? count(domain.lower) + count(domain.upper) : count(u);
        if (const auto check = check_multiplicity(knots, u, times, tears); !check) return check;
    }
    return {};
}

// Whether a value inside comes to a multiplicity above p, which only tears may have. `knots` are the new ones.
bool is_any_above_degree(std::size_t p, std::span<const double> knots, const InsertedRange& changed) {
    if (!changed.has_equal_knots) return false;
    const std::size_t first = std::max(changed.first, p + 1);
    const std::size_t end = std::min(changed.end, knots.size() - 2 * p - 1);
    for (std::size_t i = first; i < end; ++i)
        if (knots[i] == knots[i + p]) return true;
    return false;
}

// And no value is not a number.
bool is_ascending(std::span<const double> values) {
    std::size_t others = std::isfinite(values.front()) && std::isfinite(values.back()) ? 0 : 1;
    for (std::size_t i = 1; i < values.size(); ++i) others += values[i - 1] <= values[i] ? 0U : 1U;
    return others == 0;
}

// The arrays with `values`, which are `added` and, in a strip, its repetitions. Looks at what is new alone.
Result<NewCurveArrays> checked(const Curve& curve, const CurveArrays& arrays, std::span<const double> values,
                               std::span<const double> added, Tears tears) {
    NewCurveArrays result = refined(arrays, values);
    const bool is_at_end = added.front() == curve.domain().lower || added.back() == curve.domain().upper;
    if (is_at_end || is_any_above_degree(arrays.p, result.knots.values(), result.changed))
        if (const auto check = check_added(curve.knots(), added, tears); !check) return refuse(check.error());
    const std::size_t first = result.changed.first;
    if (!are_finite(result.points.values().subspan(first, result.changed.end - first)))
        return refuse({.code = CurveErrorCode::not_computable});
    return result;
}

// The curve of refined arrays, which is as valid as the one before.
Curve refined_curve(const Curve& from, SharedArray<double> knots, NewArray<Point> points, NewArray<double> weights) {
    const bool is_rational = from.is_rational() && !are_equal(weights.values());
    return Trusted::curve(
        Trusted::knots_of_kind_or_custom(from.degree(), from.is_periodic(), from.knots().kind(), std::move(knots)),
        SharedArray(std::move(points)), SharedArray(std::move(weights)), is_rational);
}

Result<Curve> refine_open(const Curve& curve, std::span<const double> added, Tears tears) {
    auto arrays = checked(curve, arrays_of(curve), added, added, tears);
    if (!arrays) return refuse(arrays.error());
    return refined_curve(curve, SharedArray(std::move(arrays->knots)), std::move(arrays->points),
                         std::move(arrays->weights));
}

// As many knots before and after a period as its refinement depends on, and the points of all these.
struct Strip {
    std::size_t margin;
    std::vector<double> knots;
    std::vector<Point> points;
    std::vector<double> weights;
};

Strip strip_of(const Curve& curve) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t n = curve.control_points().size();
    const std::size_t margin = 3 * p + 2;
    Strip strip{margin, unroll_period(curve.knots().stored(), margin, margin), {}, {}};
    const std::size_t first = n * margin - (margin - p);
    for (std::size_t i = 0; i + p + 1 < strip.knots.size(); ++i) {
        strip.points.push_back(curve.control_points()[(first + i) % n]);
        strip.weights.push_back(curve.weights()[(first + i) % n]);
    }
    return strip;
}

// The values and their repetitions before and after the period, strictly inside the strip; computed as unroll_period
// does, so that a repetition of a value equals the repetition of the knot that it equals.
struct Repetitions {
    std::vector<double> values;   // ascending
    std::size_t count_below = 0;  // those before the period
};

Repetitions repetitions(std::span<const double> added, Interval period, Interval strip) {
    std::vector<double> below;
    std::vector<double> above;
    for (const double u : added) {
        for (double v = period.lower + (u - period.upper); v > strip.lower; v = period.lower + (v - period.upper))
            below.push_back(v);
        for (double v = period.upper + (u - period.lower); v < strip.upper; v = period.upper + (v - period.lower))
            above.push_back(v);
    }
    std::sort(below.begin(), below.end());
    std::sort(above.begin(), above.end());
    Repetitions result{below, below.size()};
    result.values.insert(result.values.end(), added.begin(), added.end());
    result.values.insert(result.values.end(), above.begin(), above.end());
    return result;
}

// All repetitions come in, as in the endless spline.
Result<Curve> refine_periodic(const Curve& curve, std::span<const double> added) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const Strip strip = strip_of(curve);
    const CurveArrays arrays{p, strip.knots, strip.points, strip.weights, curve.is_rational()};
    const Repetitions repeated = repetitions(added, curve.domain(), arrays.domain());
    auto strip_refined = checked(curve, arrays, repeated.values, added, Tears::refuse);
    if (!strip_refined) return refuse(strip_refined.error());
    const std::size_t count = curve.control_points().size() + added.size();
    const std::size_t first_knot = strip.margin + repeated.count_below;
    NewArray<Point> points(count);
    NewArray<double> weights(count);
    std::copy_n(&strip_refined->points.data()[first_knot - p], count, points.data());
    std::copy_n(&strip_refined->weights.data()[first_knot - p], count, weights.data());
    const auto period = strip_refined->knots.values().subspan(first_knot, count + 1);
    return refined_curve(curve, SharedArray(unroll_period(period, p, p)), std::move(points), std::move(weights));
}

}  // namespace

Result<Curve> refine_knots(const Curve& curve, std::vector<double> added, Tears tears) {
    if (added.empty()) return curve;
    if (!is_ascending(added)) {
        if (!std::ranges::all_of(added, [](double u) { return std::isfinite(u); }))
            return refuse({.code = CurveErrorCode::parameter_not_finite});
        std::sort(added.begin(), added.end());
    }
    if (!curve.domain().contains(added.front()) || !curve.domain().contains(added.back()))
        return refuse(check_added(curve.knots(), added, tears).error());
    return curve.is_periodic() ? refine_periodic(curve, added) : refine_open(curve, added, tears);
}

}  // namespace batten::core
