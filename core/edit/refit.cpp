#include "core/edit/refit.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/base/detail/gauss_rule.h"
#include "core/curve/knot_analysis.h"
#include "core/edit/detail/smooth_moves.h"
#include "core/edit/point_edit.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/deviation.h"

namespace batten::core {

namespace {

// Rational functions are not integrated exactly by any rule; so many nodes more make it good enough for a fit.
constexpr std::size_t more_nodes_for_weights = 4;

// What moves count beside errors, so that control points stay which the errors do not tell anything about.
constexpr double next_to_nothing = 1e-20;

// The ends of the spans of both curves in their domain.
std::vector<double> all_breaks(const Curve& a, const Curve& b) {
    std::vector<double> breaks;
    for (const Curve* curve : {&a, &b})
        for (const DistinctKnot& knot : distinct_knots(curve->knots()))
            if (curve->domain().contains(knot.value)) breaks.push_back(knot.value);
    std::ranges::sort(breaks);
    breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
    return breaks;
}

// The moved pattern shall be where `truth` is at the nodes of an integration rule.
std::vector<MoveCondition> places_of(const Curve& truth, const Curve& pattern) {
    const auto degree = static_cast<std::size_t>(std::max(truth.degree(), pattern.degree()));
    const bool has_weights = truth.is_rational() || pattern.is_rational();
    const auto rule = gauss_rule(degree + 1 + (has_weights ? more_nodes_for_weights : 0));
    const auto breaks = all_breaks(truth, pattern);
    const std::span<const Point> points = pattern.control_points();
    std::vector<MoveCondition> goals;
    for (std::size_t s = 0; s + 1 < breaks.size(); ++s) {
        const double half = 0.5 * (breaks[s + 1] - breaks[s]);
        for (const GaussNode& node : rule) {
            const double u = breaks[s] + half * (1.0 + node.position);
            const RationalBasis basis = rational_basis(pattern, u);
            const double weight = std::sqrt(half * node.weight);
            const Vector there = point_at(truth, u) - points[basis.first % points.size()];
            MoveCondition goal{basis.first, basis.derivatives[0], weight * (there - sum_of_basis(pattern, basis, 0))};
            for (double& coefficient : goal.coefficients) coefficient *= weight;
            goals.push_back(std::move(goal));
        }
    }
    return goals;
}

// Whether point i of the one curve is point j of the other, over the same knots.
bool are_alike(const Curve& a, std::size_t i, const Curve& b, std::size_t j) {
    if (a.control_points()[i] != b.control_points()[j] || a.weights()[i] != b.weights()[j]) return false;
    const std::size_t count = static_cast<std::size_t>(a.degree()) + 2;
    return std::ranges::equal(a.knots().values().subspan(i, count), b.knots().values().subspan(j, count));
}

// Whether point i of the pattern is none of the truth, counted from the start or from the end.
bool differs(const Curve& pattern, const Curve& truth, std::size_t i) {
    const std::size_t n = pattern.control_points().size();
    const std::size_t m = truth.control_points().size();
    const bool is_of_start = i < m && are_alike(pattern, i, truth, i);
    const bool is_of_end = n - i <= m && are_alike(pattern, i, truth, m - (n - i));
    return !is_of_start && !is_of_end;
}

// What is far from all that differs is left as it is; in a closed curve both ways around.
std::vector<bool> held_far_away(const Curve& pattern, const Curve& truth) {
    const std::size_t n = pattern.control_points().size();
    if (pattern.degree() != truth.degree() || pattern.is_periodic() != truth.is_periodic())
        return std::vector<bool>(n, false);
    std::vector<bool> is_other(n);
    for (std::size_t i = 0; i < n; ++i) is_other[i] = differs(pattern, truth, i);
    std::vector<bool> is_held(n, true);
    const std::size_t reach = 2 * static_cast<std::size_t>(pattern.degree());
    const std::size_t steps = pattern.is_periodic() ? n + reach : n;
    std::size_t forward = reach;
    std::size_t backward = reach;
    for (std::size_t k = 0; k < steps; ++k) {
        forward = is_other[k % n] ? 0 : forward + 1;
        if (forward <= reach) is_held[k % n] = false;
        const std::size_t i = n - 1 - k % n;
        backward = is_other[i] ? 0 : backward + 1;
        if (backward <= reach) is_held[i] = false;
    }
    return is_held;
}

}  // namespace

Result<Approximation> refit(const Curve& pattern, const Curve& truth, const Progress& progress) {
    assert(pattern.domain() == truth.domain());
    if (pattern == truth) return Approximation{truth, 0.0};
    const SmoothMoves moves(pattern, places_of(truth, pattern), held_far_away(pattern, truth));
    auto curve = moves.with_weight(next_to_nothing, progress);
    if (!curve) return refuse({.code = CurveErrorCode::not_computable});
    const double error = largest_deviation(truth, *curve);
    return Approximation{*std::move(curve), error};
}

Result<Approximation> delete_points_and_refit(const Curve& curve, std::span<const std::size_t> indices,
                                              const Progress& progress) {
    const auto pattern = delete_control_points(curve, indices);
    if (!pattern) return refuse(pattern.error());
    // Without inner knots an unclamped curve gives up an outer one, and with it a part of its domain.
    if (pattern->domain() != curve.domain()) return Approximation{*pattern, largest_deviation(curve, *pattern)};
    return refit(*pattern, curve, progress);
}

}  // namespace batten::core
