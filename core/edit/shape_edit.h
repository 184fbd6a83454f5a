/// Moves a point of the curve itself, with the least change of the control points (shape-changing).
#pragma once

#include <span>

#include "core/curve/curve.h"

namespace batten::core {

/// The curve with C(u) = `target`: of all ways to get there the one with the least sum of squared control point moves,
///     P_i += R_i(u) (target - C(u)) / sum of R_k(u)^2,
/// where R_i are the rational basis functions. Knots and weights stay, and so do control points that do not act at u;
/// where one point alone makes C(u), as at a clamped end, it is put on the target. Where the curve is smoother at a
/// knot nearby than its multiplicity promises, the least change is sought among those that keep G1 and G2 there, and
/// points up to p spans away move with it; ends that meet are such a knot, and stay together. Where none does, as in
/// degree 1, the smoothness is lost. The control points `pinned` (ascending) keep every bit, and the others make up for
/// them. Errors: parameter_not_finite; parameter_outside_domain; vector_not_finite; points_pinned where all that act at
/// u are pinned. Cost O(p^2) plus the copying. Source: The NURBS Book, 11.2.
[[nodiscard]] Result<Curve> move_curve_point(const Curve& curve, double u, Point target,
                                             std::span<const std::size_t> pinned = {});

/// The curve with C(u) = `target` and C'(u) = `derivative`, seen from `side` at a knot; again with the least change
/// that keeps the smoothness. The old derivative keeps the tangent while the point moves. Errors: those of
/// move_curve_point; tangent_not_free where the derivative is the same for all control points, as midway in a periodic
/// curve of two points.
[[nodiscard]] Result<Curve> move_curve_point_and_tangent(const Curve& curve, double u, Point target, Vector derivative,
                                                         Side side = Side::right,
                                                         std::span<const std::size_t> pinned = {});

}  // namespace batten::core
