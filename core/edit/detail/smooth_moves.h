/// Control points moved by least squares so that the ends of a curve stay, and its smoothness does.
#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/edit/detail/kept_smoothness.h"
#include "core/evaluate/detail/spline_system.h"

namespace batten::core {

/// The sum of R_j^(order)(u) P_j over the functions of `basis`, taken near the curve's own place so that nothing
/// cancels far from the origin: a derivative as it is, for order 0 the point less the place of control point
/// `basis.first`.
Vector sum_of_basis(const Curve& curve, const RationalBasis& basis, std::size_t order);

/// What the moves of the control points of a curve shall do, at best, and what they must not.
class SmoothMoves {
  public:
    /// The moves shall meet `goals` in the sense of least squares. Control points with `is_held` (empty: none) stay,
    /// and so do the ends of an open curve and what smoothness_conditions() names. Cost O(n p^2).
    SmoothMoves(const Curve& curve, std::vector<MoveCondition> goals, std::vector<bool> is_held = {});

    /// The curve with the best moves, where the squares of the moves count `weight` (>= 0) beside the errors, of which
    /// the largest coefficient counts 1; none where the goals determine no such moves.
    std::optional<Curve> with_weight(double weight, const Progress& progress = {}) const;

  private:
    std::optional<std::vector<Vector>> moves_with(double root, const std::vector<Vector>& lacking,
                                                  const Progress& progress) const;
    void require_kept(SplineSystem& system, MoveCondition condition, Vector lacking, double largest) const;
    void require_end(SplineSystem& system, double end, double largest) const;
    void hold_points(SplineSystem& system, double root, double largest) const;
    Curve with_ends(Curve moved) const;

    const Curve& curve_;
    std::vector<MoveCondition> goals_;
    std::vector<MoveCondition> kept_;
    std::vector<bool> is_held_;
    EndPoints fixed_;
    std::vector<double> free_ends_;  // that no control point makes alone
};

}  // namespace batten::core
