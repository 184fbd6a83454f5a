#include "core/make/detail/fit_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/curve/detail/bspline.h"
#include "core/evaluate/detail/precise_jet.h"

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
    LocalPoints<Vector> points;
    double farthest = 0.0;
    const auto all = curve.control_points();
    for (std::size_t j = 0; j <= at.p; ++j) {
        points[j] = all[(at.s - at.p + j) % all.size()] - point;
        farthest = std::max({farthest, std::abs(points[j].x), std::abs(points[j].y)});
    }
    const double share = 8.0 * static_cast<double>(at.p + 1) * std::numeric_limits<double>::epsilon();
    return {robust_length(de_boor(points, at, u)), share * farthest};
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
