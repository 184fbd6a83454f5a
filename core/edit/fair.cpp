#include "core/edit/fair.h"

#include <algorithm>
#include <cmath>

#include "core/base/detail/gauss_rule.h"
#include "core/curve/detail/edit_checks.h"
#include "core/curve/knot_analysis.h"
#include "core/edit/detail/smooth_moves.h"
#include "core/evaluate/rational_basis.h"
#include "core/measure/geometric_distance.h"

namespace batten::core {

namespace {

// The range in which the weight of the moves is sought, in powers of ten, relative to the largest coefficient.
constexpr double least_exponent = -16.0;
constexpr double greatest_exponent = 24.0;
constexpr int trials = 17;  // the first, and halvings of that range to a thousandth

// Rational functions are not integrated exactly by any rule; so many nodes more make it good enough for a measure.
constexpr std::size_t more_nodes_for_rational = 4;

// The third derivative of the moved curve shall vanish at the nodes of an integration rule.
std::vector<MoveCondition> third_derivatives(const Curve& curve) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const auto rule = gauss_rule(p - 2 + (curve.is_rational() ? more_nodes_for_rational : 0));
    const KnotVector& knots = curve.knots();
    std::vector<MoveCondition> conditions;
    for (std::size_t s = p; s + p + 1 < knots.size(); ++s) {
        const double half = 0.5 * (knots[s + 1] - knots[s]);
        if (half == 0.0) continue;
        for (const GaussNode& node : rule) {
            const RationalBasis basis = rational_basis(curve, knots[s] + half * (1.0 + node.position), 3);
            const double weight = std::sqrt(half * node.weight);
            MoveCondition condition{basis.first, basis.derivatives[3], -weight * sum_of_basis(curve, basis, 3)};
            for (double& coefficient : condition.coefficients) coefficient *= weight;
            conditions.push_back(std::move(condition));
        }
    }
    return conditions;
}

// The jumps of the highest derivative of degree 1 or 2 shall vanish.
std::vector<MoveCondition> jumps(const Curve& curve) {
    const int p = curve.degree();
    const auto order = static_cast<std::size_t>(p);
    std::vector<MoveCondition> conditions;
    for (const DistinctKnot& knot : distinct_knots(curve.knots())) {
        if (!knot.is_interior) continue;
        const RationalBasis before = rational_basis(curve, knot.value, p, Side::left);
        const RationalBasis after = rational_basis(curve, knot.value, p, Side::right);
        MoveCondition condition = difference_at_knot(curve, before, order, after, order);
        condition.right = sum_of_basis(curve, before, order) - sum_of_basis(curve, after, order);
        conditions.push_back(std::move(condition));
    }
    return conditions;
}

// The control points that stay when those of `part` move.
std::vector<bool> held_outside(const Curve& curve, Interval part) {
    const KnotVector& knots = curve.knots();
    const Interval domain = curve.domain();
    const double period = curve.is_periodic() ? domain.upper - domain.lower : 0.0;
    std::vector<bool> is_held;
    for (std::size_t i = 0; i < curve.control_points().size(); ++i) {
        const double place = greville_abscissa(knots, i);
        is_held.push_back(!part.contains(place) && !part.contains(place + period) && !part.contains(place - period));
    }
    return is_held;
}

std::vector<bool> with_pinned(std::vector<bool> is_held, std::span<const std::size_t> pinned) {
    for (const std::size_t i : pinned) is_held[i] = true;
    return is_held;
}

// What speaks of none of the points that move says nothing.
void forget_held(std::vector<MoveCondition>& goals, const std::vector<bool>& is_held) {
    std::erase_if(goals, [&](const MoveCondition& goal) {
        for (std::size_t j = 0; j < goal.coefficients.size(); ++j)
            if (!is_held[(goal.first + j) % is_held.size()]) return false;
        return true;
    });
}

Result<Approximation> fair_all_but(const Curve& curve, std::vector<bool> is_held, double distance,
                                   const Progress& progress) {
    if (const auto check = check_tolerance(distance); !check) return refuse(check.error());
    Approximation best{curve, 0.0};
    auto goals = curve.degree() >= 3 ? third_derivatives(curve) : jumps(curve);
    forget_held(goals, is_held);
    if (goals.empty()) return best;
    const SmoothMoves moves(curve, std::move(goals), std::move(is_held));
    int trial = 0;
    const auto takes = [&](double exponent) {
        const Progress part = part_of(progress, static_cast<double>(trial) / trials, (trial + 1.0) / trials);
        ++trial;
        const auto faired = moves.with_weight(std::pow(10.0, exponent), part);
        if (!faired) return false;
        const double deviation = geometric_distance(curve, *faired);
        if (!(deviation <= distance)) return false;
        best = {*faired, deviation};
        return true;
    };
    double lower = least_exponent;
    double upper = greatest_exponent;
    if (takes(lower)) return best;
    while (trial < trials) {
        const double middle = 0.5 * (lower + upper);
        (takes(middle) ? upper : lower) = middle;
    }
    return best;
}

}  // namespace

Result<Approximation> fair(const Curve& curve, double distance, const Progress& progress,
                           std::span<const std::size_t> pinned) {
    return fair_all_but(curve, with_pinned(std::vector<bool>(curve.control_points().size(), false), pinned), distance,
                        progress);
}

Result<Approximation> fair_part(const Curve& curve, Interval part, double distance, const Progress& progress,
                                std::span<const std::size_t> pinned) {
    if (!(part.lower < part.upper))
        return refuse({.code = CurveErrorCode::range_empty, .lower = part.lower, .upper = part.upper});
    const Interval domain = curve.domain();
    const Interval allowed{domain.lower, domain.upper + (curve.is_periodic() ? domain.length() : 0.0)};
    for (const double end : {part.lower, part.upper})
        if (!allowed.contains(end))
            return refuse({.code = CurveErrorCode::parameter_outside_domain,
                           .value = end,
                           .lower = allowed.lower,
                           .upper = allowed.upper});
    return fair_all_but(curve, with_pinned(held_outside(curve, part), pinned), distance, progress);
}

}  // namespace batten::core
