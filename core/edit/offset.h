/// The curve at a constant distance beside another one.
#pragma once

#include <optional>

#include "core/base/progress.h"
#include "core/curve/approximation.h"

namespace batten::core {

/// The curve C(u) + distance * N(u), where N is the unit normal to the left of the direction of travel (so a negative
/// distance lies to the right), over the same domain.
/// - Straight lines, circles and arcs: exact up to rounding, over the same knots in the same degree.
/// - Degree 1: the polygon of the parallel legs, mitred where they meet; exact, same knots and weights.
/// - All others: a cubic, clamped or periodic, that meets the true offset and its derivative at the old knots and at as
///   many parameters between them as it takes for the error to be at most `tolerance`.
/// The error is a bound of the largest distance, at equal parameters, between result and true offset; of lines,
/// circles and arcs what samples find of the rounding. What comes near another part of the curve is not cut away. A
/// distance of 0 gives the curve itself. Errors: vector_not_finite; tolerance_not_positive; curve_stands_still where
/// there is no direction; curve_has_corner where the direction jumps, beyond degree 1 (split there first);
/// offset_too_far where the distance reaches the radius of curvature on that side, so that the offset would have a
/// cusp; leg_vanishes, likewise for a polygon; tolerance_not_reached; not_computable. Source: Hermite interpolation of
/// the offset, whose derivative is C' (1 - distance * curvature).
[[nodiscard]] Result<Approximation> offset(const Curve& curve, double distance, double tolerance,
                                           const Progress& progress = {});

/// The offset of a straight line, a circle or an arc of one, exact up to rounding, over the same knots in the same
/// degree; none for other curves, and where the distance reaches the radius of curvature. Cost O(n p^2).
std::optional<Curve> exact_offset(const Curve& curve, double distance);

}  // namespace batten::core
