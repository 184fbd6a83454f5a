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

// How many of the first control points, over the same first knots, are the same in both curves.
std::size_t common_start(const Curve& a, const Curve& b) {
    const auto p = static_cast<std::size_t>(a.degree());
    const std::size_t count = std::min(a.control_points().size(), b.control_points().size());
    std::size_t i = 0;
    while (i <= p && a.knots()[i] == b.knots()[i]) ++i;
    if (i <= p) return 0;
    i = 0;
    while (i < count && a.control_points()[i] == b.control_points()[i] && a.weights()[i] == b.weights()[i] &&
           a.knots()[i + p + 1] == b.knots()[i + p + 1])
        ++i;
    return i;
}

std::size_t common_end(const Curve& a, const Curve& b) {
    const auto p = static_cast<std::size_t>(a.degree());
    const std::size_t n = a.control_points().size();
    const std::size_t m = b.control_points().size();
    std::size_t i = 0;
    while (i <= p && a.knots()[n + p - i] == b.knots()[m + p - i]) ++i;
    if (i <= p) return 0;
    i = 0;
    while (i < std::min(n, m) && a.control_points()[n - 1 - i] == b.control_points()[m - 1 - i] &&
           a.weights()[n - 1 - i] == b.weights()[m - 1 - i] && a.knots()[n - 1 - i] == b.knots()[m - 1 - i])
        ++i;
    return i;
}

// What is far from all that differs is left as it is.
std::vector<bool> held_far_away(const Curve& pattern, const Curve& truth) {
    const std::size_t n = pattern.control_points().size();
    std::vector<bool> is_held(n, false);
    if (pattern.degree() != truth.degree() || pattern.is_periodic() || truth.is_periodic()) return is_held;
    const std::size_t reach = 2 * static_cast<std::size_t>(pattern.degree());
    const std::size_t start = common_start(pattern, truth);
    const std::size_t end = common_end(pattern, truth);
    for (std::size_t i = 0; i < n; ++i) is_held[i] = i + reach < start || n - 1 - i + reach < end;
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
