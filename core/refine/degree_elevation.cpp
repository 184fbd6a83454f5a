#include <optional>
#include <utility>

#include "core/refine/degree.h"
#include "core/refine/detail/carried_point.h"
#include "core/refine/detail/low_elevation.h"
#include "core/refine/detail/spline_elevation.h"

namespace batten::core {

namespace {

CarriedSpline elevated_often(CarriedSpline spline, int by) {
    for (int i = 0; i < by; ++i) spline = elevated(spline, CarriedPoint{});
    return spline;
}

// The seam of a period is one run, and gains at its lower end.
std::vector<double> elevated_period(std::span<const double> period, int by) {
    std::vector<double> longer;
    for (std::size_t i = 0; i < period.size(); ++i) {
        longer.push_back(period[i]);
        const bool ends_run = i + 1 == period.size() || period[i + 1] != period[i];
        const bool is_seam_again = period[i] == period.back();
        if (ends_run && !is_seam_again) longer.insert(longer.end(), static_cast<std::size_t>(by), period[i]);
    }
    return longer;
}

// The first knot that rounding makes equal to the one before it in a copy of the period, as far as elevation looks.
std::optional<CurveError> merged_in_a_copy(std::span<const double> period) {
    constexpr std::size_t copies = 2;
    const std::size_t n = period.size() - 1;
    const std::vector<double> strip = unroll_period(period, copies * n, copies * n);
    for (std::size_t i = 1; i <= n; ++i)
        for (std::size_t first = 0; first + n < strip.size(); first += n)
            if (period[i - 1] < period[i] && strip[first + i - 1] == strip[first + i])
                return CurveError{.code = CurveErrorCode::knots_coincide, .index = i, .value = strip[first + i]};
    return std::nullopt;
}

Result<Curve> elevate_periodic(const Curve& curve, int by) {
    if (const auto merged = merged_in_a_copy(curve.knots().stored())) return refuse_computed(*merged);
    const CarriedSpline strip = elevated_often(carried(curve, 1), by);
    std::vector<double> period = elevated_period(curve.knots().stored(), by);
    // Where the period stands in the strip: its last knot at the lower end of the domain, found in both.
    const double lower = period.front();
    const auto at_lower = std::upper_bound(period.begin(), period.end(), lower) - period.begin();
    const std::size_t first_knot = strip.last_of_run(lower) + 1 - static_cast<std::size_t>(at_lower);
    const std::size_t count = period.size() - 1;
    return settled(
        curve,
        {.degree = curve.degree() + by, .knots = std::move(period), .is_periodic = true, .kind = curve.knots().kind()},
        std::span(strip.points).subspan(first_knot - strip.p, count));
}

}  // namespace

Result<Curve> elevate_degree(const Curve& curve, int by) {
    if (by < 1 || by > max_degree - curve.degree())
        return refuse({.code = CurveErrorCode::degree_out_of_range,
                       .value = static_cast<double>(curve.degree()) + static_cast<double>(by)});
    if (curve.is_periodic()) return elevate_periodic(curve, by);
    if (!has_low_elevation(curve)) return settled(curve, elevated_often(carried(curve), by), curve.knots().kind());
    const auto next = low_elevation(curve);
    return next && by > 1 ? elevate_degree(*next, by - 1) : next;
}

}  // namespace batten::core
