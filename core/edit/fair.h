/// Makes a curve fairer: its curvature varies less, and it stays near where it was (shape-changing).
#pragma once

#include <span>

#include "core/base/progress.h"
#include "core/curve/approximation.h"

namespace batten::core {

/// The curve over the same knots, with the same weights and the same ends, that has the least
///     integral |C'''(u)|^2 du + mu * sum of squared control point moves
/// for the least mu with which it stays within `distance` of the old curve as a shape, whatever the parameters are;
/// below degree 3 the squared jumps of the highest derivative stand for the integral. Where the curve is smoother at a
/// knot than its multiplicity promises, it stays so: G1, and from degree 3 on G2. Ends that meet are such a joint. The
/// error is geometric_distance(), a bound of the largest distance. A curve that cannot become fairer comes back as it
/// is. Error: tolerance_not_positive. Cost O(n p^2) and that of this distance for each of 17 trials. Source:
/// Kjellander 1983 and Eck and Hadenfeld 1995, with all knots at once.
/// Control points `pinned` keep every bit.
[[nodiscard]] Result<Approximation> fair(const Curve& curve, double distance, const Progress& progress = {},
                                         std::span<const std::size_t> pinned = {});

/// The same for a part of the curve: only control points move whose Greville abscissae lie in `part`, so that all spans
/// on which none of them acts keep every bit, and the curve its continuity. Of a periodic curve the part may go on over
/// the seam, up to one period beyond the domain's upper end. Where no control point lies in it, the curve comes back as
/// it is. Errors: range_empty unless part.lower < part.upper;
/// parameter_outside_domain; those of fair.
[[nodiscard]] Result<Approximation> fair_part(const Curve& curve, Interval part, double distance,
                                              const Progress& progress = {}, std::span<const std::size_t> pinned = {});

}  // namespace batten::core
