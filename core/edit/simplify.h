/// A curve with fewer control points that stays within a tolerance (shape-changing).
#pragma once

#include "core/base/progress.h"
#include "core/curve/approximation.h"

namespace batten::core {

/// Of two pieces that meet, in radians: what turns less counts as smooth.
inline constexpr double least_corner = 0.25;

/// The curve without as many knots as the tolerance (> 0, in the units of the points) allows when the control points
/// that are left are fitted to the whole curve: far fewer than remove_knots() leaves. Degree and domain stay, clamped
/// ends to the last bit, and from degree 2 on the knots of corners, where the direction turns by more than
/// `least_corner`, so that no corner becomes a tight turn. The error is a bound of the largest distance at equal
/// parameters. A curve that cannot lose a knot comes back as it is. Error: tolerance_not_positive. Cost: that of
/// remove_knots_among() and of a fit, for each of up to 40 trials. Source: Lyche and Morken 1987.
[[nodiscard]] Result<Approximation> simplify(const Curve& curve, double tolerance, const Progress& progress = {});

}  // namespace batten::core
