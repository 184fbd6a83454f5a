#include "core/edit/fair.h"

#include <algorithm>
#include <cmath>

#include "core/base/detail/gauss_rule.h"
#include "core/curve/knot_analysis.h"
#include "core/edit/shape_edit.h"
#include "core/evaluate/detail/spline_system.h"
#include "core/evaluate/evaluate.h"
#include "core/evaluate/rational_basis.h"
#include "core/measure/deviation.h"

namespace batten::core {

namespace {

// The range in which the weight of the moves is sought, in powers of ten, relative to the largest coefficient.
constexpr double least_exponent = -16.0;
constexpr double greatest_exponent = 24.0;
constexpr int halvings = 48;

// Rational functions are not integrated exactly by any rule; so many nodes more make it good enough for a measure.
constexpr std::size_t more_nodes_for_rational = 4;

// One condition on the moves D_i of the control points: sum coefficients[j] D_{first + j} = right.
struct Condition {
    std::size_t first = 0;
    std::vector<double> coefficients;
    Vector right{};
};

Vector sum_of(const Curve& curve, const RationalBasis& basis, std::size_t order) {
    // Near the curve's own place, so that nothing cancels far from the origin; the coefficients sum to zero.
    const std::span<const Point> points = curve.control_points();
    const Point origin = points[basis.first % points.size()];
    Vector sum{};
    for (std::size_t j = 0; j < basis.derivatives[order].size(); ++j)
        sum += basis.derivatives[order][j] * (points[(basis.first + j) % points.size()] - origin);
    return sum;
}

// The third derivative of the moved curve shall vanish at the nodes of an integration rule.
std::vector<Condition> third_derivatives(const Curve& curve) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const auto rule = gauss_rule(p - 2 + (curve.is_rational() ? more_nodes_for_rational : 0));
    const KnotVector& knots = curve.knots();
    std::vector<Condition> conditions;
    for (std::size_t s = p; s + p + 1 < knots.size(); ++s) {
        const double half = 0.5 * (knots[s + 1] - knots[s]);
        if (half == 0.0) continue;
        for (const GaussNode& node : rule) {
            const RationalBasis basis = rational_basis(curve, knots[s] + half * (1.0 + node.position), 3);
            const double weight = std::sqrt(half * node.weight);
            Condition condition{basis.first, basis.derivatives[3], -weight * sum_of(curve, basis, 3)};
            for (double& coefficient : condition.coefficients) coefficient *= weight;
            conditions.push_back(std::move(condition));
        }
    }
    return conditions;
}

// The jumps of the highest derivative of degree 1 or 2 shall vanish.
std::vector<Condition> jumps(const Curve& curve) {
    const int p = curve.degree();
    const auto order = static_cast<std::size_t>(p);
    const std::size_t n = curve.control_points().size();
    std::vector<Condition> conditions;
    for (const DistinctKnot& knot : distinct_knots(curve.knots())) {
        if (!knot.is_interior) continue;
        const RationalBasis before = rational_basis(curve, knot.value, p, Side::left);
        const RationalBasis after = rational_basis(curve, knot.value, p, Side::right);
        const std::size_t shift = (after.first + n - before.first % n) % n;
        Condition condition{before.first, std::vector<double>(shift + order + 1, 0.0),
                            sum_of(curve, before, order) - sum_of(curve, after, order)};
        for (std::size_t j = 0; j <= order; ++j) {
            condition.coefficients[j] -= before.derivatives[order][j];
            condition.coefficients[shift + j] += after.derivatives[order][j];
        }
        conditions.push_back(std::move(condition));
    }
    return conditions;
}

void scale_to_one(std::vector<Condition>& conditions) {
    double largest = 0.0;
    for (const Condition& condition : conditions)
        for (const double coefficient : condition.coefficients) largest = std::max(largest, std::abs(coefficient));
    if (largest == 0.0) return;
    for (Condition& condition : conditions) {
        for (double& coefficient : condition.coefficients) coefficient /= largest;
        condition.right /= largest;
    }
}

class Fairing {
  public:
    explicit Fairing(const Curve& curve)
        : curve_(curve), conditions_(curve.degree() >= 3 ? third_derivatives(curve) : jumps(curve)) {
        scale_to_one(conditions_);
        if (curve.is_periodic()) return;
        const KnotVector& knots = curve.knots();
        const std::size_t n = curve.control_points().size();
        const auto p = static_cast<std::size_t>(curve.degree());
        const auto [lower, upper] = knots.domain();
        if (knots[1] == lower)
            fixed_.known.push_back({0, Point{}});
        else
            free_ends_.push_back(lower);
        if (knots[n + p - 1] == upper)
            fixed_.known.push_back({n - 1, Point{}});
        else
            free_ends_.push_back(upper);
    }

    bool is_needed() const { return !conditions_.empty(); }

    // The fairest curve for moves that count `weight`.
    std::optional<Curve> with_weight(double weight) const {
        SplineSystem system(curve_.knots(), Point{}, fixed_);
        for (const Condition& condition : conditions_)
            system.require_sum(condition.first, condition.coefficients, condition.right);
        const double root = std::sqrt(weight);
        const std::size_t n = curve_.control_points().size();
        for (std::size_t i = 0; i < n; ++i) system.require_sum(i, std::span(&root, 1), Vector{});
        for (const double end : free_ends_) require_end(system, end, std::max(1.0, root));
        const auto moves = system.solve();
        if (!moves) return std::nullopt;
        CurveDefinition definition = curve_.definition();
        for (std::size_t i = 0; i < n; ++i) definition.points[i] += vector_to((*moves)[i]);
        const Result<Curve> faired = Curve::make(std::move(definition));
        return faired ? std::optional(with_ends(*faired)) : std::nullopt;
    }

  private:
    // An end that no control point makes alone is held by a condition that outweighs all others.
    void require_end(SplineSystem& system, double end, double largest) const {
        constexpr double outweighing = 1e6;
        RationalBasis basis = rational_basis(curve_, end, 0, Side::right);
        for (double& value : basis.derivatives[0]) value *= outweighing * largest;
        system.require_sum(basis.first, basis.derivatives[0], Vector{});
    }

    // What is left of the moves of such ends is taken back.
    Curve with_ends(Curve faired) const {
        for (const double end : free_ends_)
            if (auto corrected = move_curve_point(faired, end, point_at(curve_, end))) faired = *std::move(corrected);
        return faired;
    }

    const Curve& curve_;
    std::vector<Condition> conditions_;
    EndPoints fixed_;
    std::vector<double> free_ends_;
};

}  // namespace

Result<Approximation> fair(const Curve& curve, double distance) {
    if (!(distance > 0.0) || !std::isfinite(distance))
        return refuse({.code = CurveErrorCode::tolerance_not_positive, .value = distance});
    Approximation best{curve, 0.0};
    const Fairing fairing(curve);
    if (!fairing.is_needed()) return best;
    const auto takes = [&](double exponent) {
        const auto faired = fairing.with_weight(std::pow(10.0, exponent));
        if (!faired) return false;
        const double deviation = largest_deviation(curve, *faired);
        if (!(deviation <= distance)) return false;
        best = {*faired, deviation};
        return true;
    };
    double lower = least_exponent;
    double upper = greatest_exponent;
    if (takes(lower)) return best;
    for (int k = 0; k < halvings && upper - lower > 1e-3; ++k) {
        const double middle = 0.5 * (lower + upper);
        (takes(middle) ? upper : lower) = middle;
    }
    return best;
}

}  // namespace batten::core
