#include "core/edit/fair.h"

#include <algorithm>
#include <cmath>

#include "core/base/detail/gauss_rule.h"
#include "core/curve/knot_analysis.h"
#include "core/edit/detail/kept_smoothness.h"
#include "core/edit/shape_edit.h"
#include "core/evaluate/detail/spline_system.h"
#include "core/evaluate/evaluate.h"
#include "core/evaluate/rational_basis.h"
#include "core/measure/continuity.h"
#include "core/measure/deviation.h"

namespace batten::core {

namespace {

// The range in which the weight of the moves is sought, in powers of ten, relative to the largest coefficient.
constexpr double least_exponent = -16.0;
constexpr double greatest_exponent = 24.0;
constexpr int trials = 17;  // the first, and halvings of that range to a thousandth

// Rational functions are not integrated exactly by any rule; so many nodes more make it good enough for a measure.
constexpr std::size_t more_nodes_for_rational = 4;

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
            MoveCondition condition{basis.first, basis.derivatives[3], -weight * sum_of(curve, basis, 3)};
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
        condition.right = sum_of(curve, before, order) - sum_of(curve, after, order);
        conditions.push_back(std::move(condition));
    }
    return conditions;
}

void scale_to_one(std::vector<MoveCondition>& conditions) {
    double largest = 0.0;
    for (const MoveCondition& condition : conditions)
        for (const double coefficient : condition.coefficients) largest = std::max(largest, std::abs(coefficient));
    if (largest == 0.0) return;
    for (MoveCondition& condition : conditions) {
        for (double& coefficient : condition.coefficients) coefficient /= largest;
        condition.right /= largest;
    }
}

void scale_rows_to_one(std::vector<MoveCondition>& conditions) {
    for (MoveCondition& condition : conditions) {
        double size = 0.0;
        for (const double coefficient : condition.coefficients) size = std::hypot(size, coefficient);
        if (size == 0.0) continue;
        for (double& coefficient : condition.coefficients) coefficient /= size;
    }
}

class Fairing {
  public:
    explicit Fairing(const Curve& curve)
        : curve_(curve),
          conditions_(curve.degree() >= 3 ? third_derivatives(curve) : jumps(curve)),
          kept_(smoothness_conditions(curve, curve.domain())) {
        scale_to_one(conditions_);
        scale_rows_to_one(kept_);
        if (curve.is_periodic()) return;
        fixed_.meet = is_closed(curve);
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

    // The fairest curve for moves that count `weight`. What keeps the smoothness at knots is met exactly, by the method
    // of multipliers: each pass makes up for what the one before lacked.
    std::optional<Curve> with_weight(double weight, const Progress& progress) const {
        const int passes = kept_.empty() ? 1 : 3;
        std::vector<Vector> lacking(kept_.size(), Vector{});
        std::optional<std::vector<Vector>> moves;
        for (int pass = 0; pass < passes; ++pass) {
            moves = moves_with(std::sqrt(weight), lacking,
                               part_of(progress, static_cast<double>(pass) / passes, (pass + 1.0) / passes));
            if (!moves) return std::nullopt;
            for (std::size_t k = 0; k < kept_.size(); ++k) lacking[k] += missed(kept_[k], *moves);
        }
        const Result<Curve> faired = with_moves(curve_, 0, *moves);
        return faired ? std::optional(with_ends(*faired)) : std::nullopt;
    }

  private:
    // How far the best moves by `root` of the weight of each; the kept conditions outweigh all but the ends.
    std::optional<std::vector<Vector>> moves_with(double root, const std::vector<Vector>& lacking,
                                                  const Progress& progress) const {
        const double largest = std::max(1.0, root);
        SplineSystem system(curve_.knots(), Point{}, fixed_);
        for (const MoveCondition& condition : conditions_)
            system.require_sum(condition.first, condition.coefficients, condition.right);
        for (std::size_t i = 0; i < curve_.control_points().size(); ++i)
            system.require_sum(i, std::span(&root, 1), Vector{});
        for (std::size_t k = 0; k < kept_.size(); ++k) require_kept(system, kept_[k], lacking[k], largest);
        for (const double end : free_ends_) require_end(system, end, largest);
        const auto points = system.solve(progress);
        if (!points) return std::nullopt;
        std::vector<Vector> moves;
        for (const Point& point : *points) moves.push_back(vector_to(point));
        return moves;
    }

    static void require_kept(SplineSystem& system, MoveCondition condition, Vector lacking, double largest) {
        constexpr double outweighing = 1e5;
        for (double& coefficient : condition.coefficients) coefficient *= outweighing * largest;
        system.require_sum(condition.first, condition.coefficients, -outweighing * largest * lacking);
    }

    static Vector missed(const MoveCondition& condition, const std::vector<Vector>& moves) {
        Vector sum{};
        for (std::size_t j = 0; j < condition.coefficients.size(); ++j)
            sum += condition.coefficients[j] * moves[(condition.first + j) % moves.size()];
        return sum;
    }

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
    std::vector<MoveCondition> conditions_;
    std::vector<MoveCondition> kept_;
    EndPoints fixed_;
    std::vector<double> free_ends_;
};

}  // namespace

Result<Approximation> fair(const Curve& curve, double distance, const Progress& progress) {
    if (!(distance > 0.0) || !std::isfinite(distance))
        return refuse({.code = CurveErrorCode::tolerance_not_positive, .value = distance});
    Approximation best{curve, 0.0};
    const Fairing fairing(curve);
    if (!fairing.is_needed()) return best;
    int trial = 0;
    const auto takes = [&](double exponent) {
        const Progress part = part_of(progress, static_cast<double>(trial) / trials, (trial + 1.0) / trials);
        ++trial;
        const auto faired = fairing.with_weight(std::pow(10.0, exponent), part);
        if (!faired) return false;
        const double deviation = largest_deviation(curve, *faired);
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

}  // namespace batten::core
