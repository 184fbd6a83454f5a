#include "core/make/parametrization.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/base/detail/double_double.h"

namespace batten::core {

namespace {

Result<void> check_points(std::span<const Point> points, bool is_closed) {
    const std::size_t least = is_closed ? 3 : 2;
    if (points.size() < least)
        return refuse({.code = CurveErrorCode::data_points_too_few,
                       .value = static_cast<double>(points.size()),
                       .lower = static_cast<double>(least)});
    for (std::size_t k = 0; k < points.size(); ++k)
        if (!is_finite(points[k])) return refuse({.code = CurveErrorCode::data_point_not_finite, .index = k});
    return {};
}

// In more digits, because rounding it would be seen in the parameters, and that of a long sum in its last ones.
long double step(Point from, Point to, Parametrization parametrization) {
    if (parametrization == Parametrization::uniform) return 1.0L;
    const long double across = static_cast<long double>(to.x) - from.x;
    const long double up = static_cast<long double>(to.y) - from.y;
    const long double chord = std::hypot(across, up);
    return parametrization == Parametrization::chordal ? chord : std::sqrt(chord);
}

}  // namespace

Result<std::vector<double>> parametrize(std::span<const Point> points, Parametrization parametrization,
                                        bool is_closed) {
    if (const auto check = check_points(points, is_closed); !check) return refuse(check.error());
    const std::size_t n = points.size();
    const std::size_t steps = is_closed ? n : n - 1;
    std::vector<long double> lengths(steps + 1, 0.0L);
    for (std::size_t k = 1; k <= steps; ++k)
        lengths[k] = lengths[k - 1] + step(points[k - 1], points[k % n], parametrization);
    std::vector<double> parameters(steps + 1, 0.0);
    for (std::size_t k = 1; k <= steps; ++k) {
        parameters[k] = static_cast<double>(lengths[k] / lengths.back());
        // Not a number where all points are one.
        if (!(parameters[k] > parameters[k - 1]))
            return refuse(
                {.code = CurveErrorCode::points_coincide, .index = k % n, .value = static_cast<double>(k - 1)});
    }
    return parameters;
}

Result<void> check_parameters(std::span<const Point> points, std::span<const double> parameters, bool is_closed) {
    if (const auto check = check_points(points, is_closed); !check) return check;
    const std::size_t expected = points.size() + (is_closed ? 1 : 0);
    if (parameters.size() != expected)
        return refuse({.code = CurveErrorCode::parameter_count_mismatch,
                       .value = static_cast<double>(parameters.size()),
                       .lower = static_cast<double>(expected)});
    for (std::size_t k = 0; k < parameters.size(); ++k)
        if (!std::isfinite(parameters[k]) || (k > 0 && !(parameters[k] > parameters[k - 1])))
            return refuse({.code = CurveErrorCode::parameters_not_increasing, .index = k});
    return {};
}

std::vector<double> averaged_knots(std::span<const double> sites, std::size_t p) {
    assert(p >= 1 && sites.size() >= p + 1 && std::is_sorted(sites.begin(), sites.end()));
    std::vector<double> knots(p + 1, sites.front());
    knots.reserve(sites.size() + p + 1);
    for (std::size_t j = 1; j + p < sites.size(); ++j) {
        // Seen from the first of them, so that the mean never leaves them, however close they are.
        DoubleDouble sum;
        for (std::size_t i = j; i < j + p; ++i) sum = sum + exact_sum(sites[i], -sites[j]);
        const double mean = (sites[j] + sum / static_cast<double>(p)).rounded();
        knots.push_back(std::clamp(mean, sites[j], sites[j + p - 1]));
    }
    knots.insert(knots.end(), p + 1, sites.back());
    return knots;
}

}  // namespace batten::core
