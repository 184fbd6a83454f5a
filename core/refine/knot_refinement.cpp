#include "core/refine/knot_refinement.h"

#include <algorithm>
#include <utility>

#include "core/curve/detail/edit_checks.h"
#include "core/refine/detail/carried_point.h"

namespace batten::core {

namespace {

Result<void> check_place(const KnotVector& knots, double u) {
    const Interval domain = knots.domain();
    if (domain.contains(u)) return {};
    return refuse(
        {.code = CurveErrorCode::parameter_outside_domain, .value = u, .lower = domain.lower, .upper = domain.upper});
}

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
        if (const auto check = check_place(knots, u); !check) return check;
        if (i > 0 && u == added[i - 1]) continue;
        const bool is_seam = knots.is_periodic() && (u == domain.lower || u == domain.upper);
        const std::size_t times = is_seam ? count(domain.lower) + count(domain.upper) : count(u);
        if (const auto check = check_multiplicity(knots, u, times, tears); !check) return check;
    }
    return {};
}

Result<Curve> refine_open(const Curve& curve, std::span<const double> added, Tears tears) {
    CarriedSpline spline = carried(curve);
    insert_ascending(spline, added);
    return settled(curve, std::move(spline), curve.knots().kind(), tears);
}

// The values and their repetitions in so many periods before and after, ascending; computed as unroll_period does, so
// that a repetition of a value equals the repetition of the knot that it equals.
std::vector<double> repetitions(std::span<const double> values, Interval period, std::size_t periods) {
    std::vector<double> all(values.begin(), values.end());
    std::vector<double> below = all;
    std::vector<double> above = all;
    for (std::size_t k = 0; k < periods; ++k) {
        for (double& u : below) u = period.lower + (u - period.upper);
        for (double& u : above) u = period.upper + (u - period.lower);
        all.insert(all.end(), below.begin(), below.end());
        all.insert(all.end(), above.begin(), above.end());
    }
    std::sort(all.begin(), all.end());
    return all;
}

// All repetitions come in, as in the endless spline. So many periods are laid out that everything on which the middle
// one depends lies inside the strip, also where a period has fewer points than the degree.
Result<Curve> refine_periodic(const Curve& curve, std::span<const double> added) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t n = curve.control_points().size();
    const std::size_t periods = p / n + 1;
    CarriedSpline spline = carried(curve, periods);
    insert_ascending(spline, repetitions(added, curve.domain(), periods));
    const std::size_t count = n + added.size();
    const std::size_t first_knot = p + periods * count;
    const auto period = std::span(spline.knots).subspan(first_knot, count + 1);
    return settled(curve,
                   {.degree = curve.degree(),
                    .knots = {period.begin(), period.end()},
                    .is_periodic = true,
                    .kind = curve.knots().kind()},
                   std::span(spline.points).subspan(first_knot - p, count));
}

}  // namespace

Result<Curve> refine_knots(const Curve& curve, std::vector<double> added, Tears tears) {
    for (const double u : added)
        if (const auto check = check_parameter_finite(u); !check) return refuse(check.error());
    std::sort(added.begin(), added.end());
    if (const auto check = check_added(curve.knots(), added, tears); !check) return refuse(check.error());
    if (added.empty()) return curve;
    return curve.is_periodic() ? refine_periodic(curve, added) : refine_open(curve, added, tears);
}

}  // namespace batten::core
