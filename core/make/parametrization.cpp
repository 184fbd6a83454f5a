#include "core/make/parametrization.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/base/detail/are_finite.h"
#include "core/make/detail/chord_sums.h"
#include "core/make/detail/site_means.h"

namespace batten::core {

namespace {

// Goes through all of them, because without a way out several are looked at in one step.
bool are_ascending(std::span<const double> parameters) {
    std::size_t steps = 0;
    for (std::size_t k = 1; k < parameters.size(); ++k) steps += parameters[k - 1] < parameters[k] ? 1U : 0U;
    return steps + 1 == parameters.size() && std::isfinite(parameters.front()) && std::isfinite(parameters.back());
}

Result<void> check_points(std::span<const Point> points, bool is_closed) {
    const std::size_t least = is_closed ? 3 : 2;
    if (points.size() < least)
        return refuse({.code = CurveErrorCode::data_points_too_few,
                       .value = static_cast<double>(points.size()),
                       .lower = static_cast<double>(least)});
    if (are_finite(points)) return {};
    const auto undefined = std::ranges::find_if(points, [](Point point) { return !is_finite(point); });
    return refuse(
        {.code = CurveErrorCode::data_point_not_finite, .index = static_cast<std::size_t>(undefined - points.begin())});
}

// In more digits, because rounding it would be seen in the parameters, and that of a long sum in its last ones.
long double step(Point from, Point to, Parametrization parametrization) {
    if (parametrization == Parametrization::uniform) return 1.0L;
    const long double across = static_cast<long double>(to.x) - from.x;
    const long double up = static_cast<long double>(to.y) - from.y;
    const long double chord = std::hypot(across, up);
    return parametrization == Parametrization::chordal ? chord : std::sqrt(chord);
}

// Of points at any distance from each other.
std::vector<double> shares_of_any_way(std::span<const Point> points, Parametrization parametrization, bool is_closed) {
    const std::size_t n = points.size();
    const std::size_t steps = is_closed ? n : n - 1;
    std::vector<long double> lengths(steps + 1, 0.0L);
    for (std::size_t k = 1; k <= steps; ++k)
        lengths[k] = lengths[k - 1] + step(points[k - 1], points[k % n], parametrization);
    std::vector<double> shares(steps + 1, 0.0);
    for (std::size_t k = 1; k <= steps; ++k) shares[k] = static_cast<double>(lengths[k] / lengths.back());
    return shares;
}

}  // namespace

Result<std::vector<double>> parametrize(std::span<const Point> points, Parametrization parametrization,
                                        bool is_closed) {
    if (const auto check = check_points(points, is_closed); !check) return refuse(check.error());
    auto parameters = shares_of_way(points, parametrization, is_closed);
    if (!parameters) parameters = shares_of_any_way(points, parametrization, is_closed);
    if (are_ascending(*parameters)) return *std::move(parameters);
    // Not a number where all points are one.
    std::size_t k = 1;
    while (k + 1 < parameters->size() && (*parameters)[k] > (*parameters)[k - 1]) ++k;
    return refuse(
        {.code = CurveErrorCode::points_coincide, .index = k % points.size(), .value = static_cast<double>(k - 1)});
}

Result<void> check_parameters(std::span<const Point> points, std::span<const double> parameters, bool is_closed) {
    if (const auto check = check_points(points, is_closed); !check) return check;
    const std::size_t expected = points.size() + (is_closed ? 1 : 0);
    if (parameters.size() != expected)
        return refuse({.code = CurveErrorCode::parameter_count_mismatch,
                       .value = static_cast<double>(parameters.size()),
                       .lower = static_cast<double>(expected)});
    if (are_ascending(parameters)) return {};
    for (std::size_t k = 0; k < parameters.size(); ++k)
        if (!std::isfinite(parameters[k]) || (k > 0 && !(parameters[k] > parameters[k - 1])))
            return refuse({.code = CurveErrorCode::parameters_not_increasing, .index = k});
    return {};
}

std::vector<double> averaged_knots(std::span<const double> sites, std::size_t p) {
    assert(p >= 1 && sites.size() >= p + 1 && std::is_sorted(sites.begin(), sites.end()));
    std::vector<double> knots(sites.size() + p + 1, sites.front());
    const auto inner = std::span(knots).subspan(p + 1, sites.size() - p - 1);
    mean_of_sites(sites.subspan(1), p, inner);
    std::fill(knots.end() - static_cast<std::ptrdiff_t>(p) - 1, knots.end(), sites.back());
    return knots;
}

}  // namespace batten::core
