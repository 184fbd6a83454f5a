/// Makes an open curve longer at one of its ends; the old part keeps its shape and parameters.
#pragma once

#include "core/curve/curve.h"
#include "core/curve/curve_end.h"

namespace batten::core {

/// The curve over a domain that is longer by `by` (> 0) at this end: the polynomial of its last piece simply goes on.
/// The end becomes clamped, no knot is added. Errors: curve_periodic; length_not_positive; range_empty when `by` is too
/// small beside the parameters; extension_too_far, which says how far it can go, when the denominator runs out or
/// doubles do; not_computable where not even that is known. Cost O(p^2) plus the copying. Source: blossoms.
[[nodiscard]] Result<Curve> extend_parameter(const Curve& curve, CurveEnd end, double by);

/// The same, by as much as makes the curve longer by the arc length `length` (> 0), met to about 1e-12 of it. Errors
/// likewise, and curve_stands_still when the end has no speed to go on with.
[[nodiscard]] Result<Curve> extend_length(const Curve& curve, CurveEnd end, double length);

/// The curve with a straight piece of this `length` (> 0) in the direction of its end, run through with the speed of
/// the end (the mean speed of the curve where that is 0). The joint is a knot of multiplicity p. Errors:
/// curve_periodic; length_not_positive; range_empty; curve_stands_still when the end has no direction.
[[nodiscard]] Result<Curve> extend_straight(const Curve& curve, CurveEnd end, double length);

}  // namespace batten::core
