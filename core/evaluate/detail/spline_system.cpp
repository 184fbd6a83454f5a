#include "core/evaluate/detail/spline_system.h"

#include <cassert>
#include <utility>

#include "core/evaluate/basis.h"
#include "core/evaluate/detail/precise_jet.h"

namespace batten::core {

SplineSystem::SplineSystem(KnotVector knots, Point origin, const EndPoints& ends)
    : knots_(std::move(knots)),
      origin_(origin),
      points_(knots_.control_point_count(), Vector{}),
      shares_(knots_.control_point_count(), 1.0),
      unknown_(knots_.control_point_count(), 0),
      is_ring_(knots_.is_periodic() || ends.meet) {
    assert((ends.known.empty() && ends.bound.empty()) || !knots_.is_periodic());
    for (const KnownPoint& given : ends.known) {
        assert(given.index < points_.size());
        points_[given.index] = given.point - origin;
        unknown_[given.index] = is_known;
    }
    for (const BoundPoint& bound : ends.bound) {
        assert(bound.index < points_.size() && bound.to < points_.size());
        points_[bound.index] = (1.0 - bound.share) * (bound.from - origin);
        shares_[bound.index] = bound.share;
        unknown_[bound.index] = is_known;
    }
    for (std::size_t& unknown : unknown_)
        if (unknown != is_known) unknown = unknown_count_++;
    for (const BoundPoint& bound : ends.bound) unknown_[bound.index] = unknown_[bound.to];
    if (!is_ring_) return;
    for (std::size_t& unknown : unknown_)
        if (unknown != is_known) unknown = folded(unknown, unknown_count_);
}

void SplineSystem::require_point(double u, Point point) {
    require({.u = u, .order = 0, .origin = point, .value = {0.0, 0.0}});
}

void SplineSystem::require_derivative(double u, int order, Vector value, double weight) {
    assert(order >= 1);
    require({.u = u, .order = order, .value = value, .weight = weight});
}

void SplineSystem::require(const Site& site) {
    BasisValues basis = basis_functions(knots_, site.u, site.order);
    BasisRow& coefficients = basis.derivatives[static_cast<std::size_t>(site.order)];
    for (double& coefficient : coefficients) coefficient *= site.weight;
    const std::size_t before = equations_.size();
    // The functions sum to 1 and their derivatives to 0, so that only points have to be seen from the origin.
    require_sum(basis.span - static_cast<std::size_t>(knots_.degree()), coefficients,
                site.weight * (site.order == 0 ? site.origin - origin_ : site.value));
    if (equations_.size() > before && site.order <= 2) sites_.push_back(site);
}

void SplineSystem::require_sum(std::size_t first, std::span<const double> coefficients, Vector right) {
    const std::size_t n = points_.size();
    assert(is_ring_ || first + coefficients.size() <= n);
    const auto after = [n](std::size_t i) { return i + 1 == n ? 0 : i + 1; };
    std::size_t lowest = unknown_count_;
    std::size_t highest = 0;
    std::size_t i = first % n;
    for (std::size_t j = 0; j < coefficients.size(); ++j, i = after(i)) {
        right -= coefficients[j] * points_[i];
        if (unknown_[i] == is_known) continue;
        lowest = std::min(lowest, unknown_[i]);
        highest = std::max(highest, unknown_[i]);
    }
    if (lowest == unknown_count_) return;
    BandedEquation<Vector>& equation = equations_.emplace_back(BandedEquation<Vector>{lowest, {}, right});
    equation.coefficients.assign(highest - lowest + 1, 0.0);
    i = first % n;
    for (std::size_t j = 0; j < coefficients.size(); ++j, i = after(i))
        if (unknown_[i] != is_known) equation.coefficients[unknown_[i] - lowest] += coefficients[j] * shares_[i];
}

// One step of iterative refinement, with what the conditions lack seen in twice the precision. It makes up for rounding
// in the solution and in the coefficients. Source: Wilkinson 1963; Golub and Van Loan, Matrix Computations, 3.5.3.
std::vector<Point> SplineSystem::refined(std::vector<Point> points) const {
    const auto curve = Curve::make(knots_, points, {});
    if (!curve) return points;
    std::vector<BandedEquation<Vector>> equations = equations_;
    for (std::size_t k = 0; k < sites_.size(); ++k) {
        const Site& site = sites_[k];
        const Location at = located(knots_, site.u, Side::right);
        const auto found = site.order == 0
                               ? precise_point(*curve, at.at, at.u, site.origin)
                               : precise_jet(*curve, at.at, at.u, site.origin)[static_cast<std::size_t>(site.order)];
        equations[k].right =
            site.weight * Vector((site.value.x - found.x).rounded(), (site.value.y - found.y).rounded());
    }
    const auto correction = solve_least_squares(equations, unknown_count_);
    if (!correction) return points;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (unknown_[i] != is_known) points[i] += shares_[i] * (*correction)[unknown_[i]];
    return points;
}

std::optional<std::vector<Point>> SplineSystem::solve(const Progress& progress) const {
    const auto solution = solve_least_squares(equations_, unknown_count_, progress);
    if (!solution) return std::nullopt;
    std::vector<Point> points(points_.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i] = origin_ + points_[i];
        if (unknown_[i] != is_known) points[i] = origin_ + (points_[i] + shares_[i] * (*solution)[unknown_[i]]);
    }
    const bool is_exact = equations_.size() == unknown_count_ && sites_.size() == unknown_count_;
    return is_exact ? refined(std::move(points)) : points;
}

}  // namespace batten::core
