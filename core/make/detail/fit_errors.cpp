#include "core/make/detail/fit_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/evaluate/detail/precise_jet.h"
#include "core/evaluate/detail/span_curve.h"

namespace batten::core {

namespace {

// A distance and how far rounding may have moved it.
struct RoughError {
    double value = 0.0;
    double rounding = 0.0;
};

// Seen from the point, so that rounding is in proportion to how far its control points are.
RoughError rough_error(const Curve& curve, const Location& place, Point point) {
    const auto& [u, at] = place;
    const double share = 8.0 * static_cast<double>(at.p + 1) * std::numeric_limits<double>::epsilon();
    return with_known_degree(at.p, [&, u = u, &at = at](auto p) {
        const SpanCurve span(curve, at, p, u);
        return RoughError{robust_length(span.weighted(point)), share * span.size_seen_from(point)};
    });
}

double precise_error(const Curve& curve, const Location& place, Point point) {
    constexpr double rounding_up = 1.0 + 4.0 * std::numeric_limits<double>::epsilon();
    const PreciseHomogeneousPoint found = precise_point(curve, place.at, place.u, point);
    return rounding_up * std::hypot(found.x.rounded(), found.y.rounded());
}

}  // namespace

std::vector<double> fit_errors(const Curve& curve, std::span<const Point> points, std::span<const double> parameters,
                               double shift) {
    const auto place = [&](std::size_t k) { return located(curve.knots(), parameters[k] + shift, Side::right); };
    std::vector<double> errors;
    double least_largest = 0.0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const RoughError error = rough_error(curve, place(k), points[k]);
        errors.push_back(error.value + error.rounding);
        least_largest = std::max(least_largest, error.value - error.rounding);
    }
    for (std::size_t k = 0; k < points.size(); ++k)
        if (!(errors[k] < least_largest)) errors[k] = precise_error(curve, place(k), points[k]);
    return errors;
}

}  // namespace batten::core
