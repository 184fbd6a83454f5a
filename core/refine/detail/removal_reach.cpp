#include "core/refine/detail/removal_reach.h"

#include <algorithm>
#include <utility>

#include "core/curve/detail/trusted.h"
#include "core/refine/detail/curve_arrays.h"

namespace batten::core {

namespace {

std::vector<double> without_some(std::span<const double> stored, double u, std::size_t count) {
    const auto first = std::lower_bound(stored.begin(), stored.end(), u);
    std::vector<double> knots;
    knots.reserve(stored.size() - count);
    knots.insert(knots.end(), stored.begin(), first);
    knots.insert(knots.end(), first + static_cast<std::ptrdiff_t>(count), stored.end());
    return knots;
}

// The values from index `first` on, but those from there to `end` replaced; of a period the indices go round.
template <class T>
std::vector<T> exchanged(std::span<const T> values, std::size_t first, std::size_t end, std::span<const T> part) {
    std::vector<T> result;
    const std::size_t n = values.size();
    result.reserve(n - (end - first) + part.size());
    if (end <= n) {
        result.insert(result.end(), values.begin(), values.begin() + static_cast<std::ptrdiff_t>(first));
        result.insert(result.end(), part.begin(), part.end());
        result.insert(result.end(), values.begin() + static_cast<std::ptrdiff_t>(end), values.end());
        return result;
    }
    // Beyond the end of the period comes its beginning.
    const std::size_t count = n - (end - first) + part.size();
    const std::size_t beyond = first + part.size() - count;
    result.insert(result.end(), part.end() - static_cast<std::ptrdiff_t>(beyond), part.end());
    result.insert(result.end(), values.begin() + static_cast<std::ptrdiff_t>(end - n),
                  values.begin() + static_cast<std::ptrdiff_t>(first));
    result.insert(result.end(), part.begin(), part.end() - static_cast<std::ptrdiff_t>(beyond));
    return result;
}

}  // namespace

std::optional<CurveInReach> curve_in_reach(const Curve& curve, double u) {
    const auto knots = curve.knots().values();
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t n = curve.control_points().size();
    const std::size_t unrolled = knots.size() - p - 1;
    if (!(curve.domain().lower < u && u < curve.domain().upper)) return std::nullopt;
    const auto run = std::equal_range(knots.begin(), knots.end(), u);
    const auto first_knot = static_cast<std::size_t>(run.first - knots.begin());
    const auto end_knot = static_cast<std::size_t>(run.second - knots.begin());
    // The spans from p knots before the run to p knots behind it, and one more: there the curve does not change.
    const std::size_t first = first_knot > 2 * p + 1 ? first_knot - 2 * p - 1 : 0;
    const std::size_t end = std::min(end_knot + p, unrolled);
    if (curve.is_periodic() && (first == 0 || end == unrolled || end - first + p > n)) return std::nullopt;
    std::vector<double> near(knots.begin() + static_cast<std::ptrdiff_t>(first),
                             knots.begin() + static_cast<std::ptrdiff_t>(end + p + 1));
    std::vector<Point> points;
    std::vector<double> weights;
    for (std::size_t i = first; i < end; ++i) {
        points.push_back(curve.control_points()[i % n]);
        weights.push_back(curve.weights()[i % n]);
    }
    const bool is_rational = !are_equal(weights);
    return CurveInReach{Trusted::curve(Trusted::knots(curve.degree(), false, KnotKind::custom, std::move(near)),
                                       std::move(points), std::move(weights), is_rational),
                        first};
}

Curve with_part_exchanged(const Curve& curve, const CurveInReach& reach, const Curve& part, double u) {
    const std::size_t first = reach.first_point;
    const std::size_t old_count = reach.curve.control_points().size();
    const std::size_t removed = old_count - part.control_points().size();
    std::vector<double> knots = without_some(curve.knots().stored(), u, removed);
    const auto p = static_cast<std::size_t>(curve.degree());
    if (curve.is_periodic()) knots = unroll_period(knots, p, p);
    std::vector<double> weights = exchanged(curve.weights(), first, first + old_count, part.weights());
    const bool is_rational = curve.is_rational() && !are_equal(weights);
    return Trusted::curve(Trusted::knots_of_kind_or_custom(curve.degree(), curve.is_periodic(), curve.knots().kind(),
                                                           SharedArray(std::move(knots))),
                          exchanged(curve.control_points(), first, first + old_count, part.control_points()),
                          std::move(weights), is_rational);
}

}  // namespace batten::core
