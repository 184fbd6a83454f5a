/// Removes knots without changing the curve by more than a tolerance.
#pragma once

#include <optional>
#include <span>

#include "core/base/progress.h"
#include "core/curve/approximation.h"

namespace batten::core {

/// What came of removing knots.
struct KnotRemoval {
    Curve curve;                      ///< the original, bit by bit, if nothing was removed
    int count = 0;                    ///< how many knots were removed
    double error = 0.0;               ///< a bound of the deviation of `curve` from the original
    std::optional<double> refused{};  ///< the deviation that the next removal asked for would have led to; it was above
                                      ///< the tolerance, or infinite because a weight would not be positive
};

/// The curve with the knot `u` removed up to `times` (>= 1) times, at most as often as it occurs; stops before the
/// deviation would exceed `tolerance` (> 0, in the units of the points). Control points out of reach keep every bit.
///
/// Each removal solves the equations of inserting the knot again, P_i = (1 - alpha_i) Q_{i-1} + alpha_i Q_i, which are
/// one more than the unknown Q: the error is spread over all of them in proportion to their weights and with
/// alternating sign, which makes the largest in the plane smallest, and they are solved from both ends toward where
/// alpha passes 1/2, so that every step divides by 1/2 or more and knots inserted before come out to the last digits.
///
/// Errors: tolerance_not_positive; parameter_not_finite; knot_not_found where `u` is no knot strictly inside the domain
/// (for a periodic curve: no knot); knot_not_removable for a seam of multiplicity 1, which is where the period begins,
/// or when only 2 points of a period are left. Cost: what the removal reaches, some 3p spans measured
/// `times` times, and one copy of everything. Source: The NURBS Book, A5.8; Lyche and Morken 1987.
[[nodiscard]] Result<KnotRemoval> remove_knot(const Curve& curve, double u, int times, double tolerance);

/// The curve without all knots inside the domain that can be spared, those that matter least first. For every span the
/// bounds of all removals that reach it are added up, and their sum stays within `tolerance` (> 0, in the units of the
/// points); the error measured in the end is smaller still. Error: tolerance_not_positive. Cost O(n p^2) for each round
/// of independent removals, of which there are some O(p log n).
[[nodiscard]] Result<KnotRemoval> remove_knots(const Curve& curve, double tolerance, const Progress& progress = {});

/// The same for the knots with one of the values `among` alone, which are ascending.
[[nodiscard]] Result<KnotRemoval> remove_knots_among(const Curve& curve, std::span<const double> among,
                                                     double tolerance);

}  // namespace batten::core
