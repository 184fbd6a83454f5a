/// Clamps and unclamps the ends of an open curve without changing its shape.
#pragma once

#include "core/curve/curve.h"
#include "core/curve/curve_end.h"

namespace batten::core {

/// The same curve with p+1 equal knots at this end of its domain and none outside: it begins or ends in its end point.
/// Bit-equal where it is so already. Error: curve_periodic (see to_clamped, which opens it). Cost O(p^2) plus the
/// copying. Source: Boehm 1980.
[[nodiscard]] Result<Curve> clamp(const Curve& curve, CurveEnd end);

/// The same curve with different knots beyond this end of its domain, which keeps one knot there: the spans of the
/// domain are repeated outside it as if the curve were periodic, u_{p-k} - u_{p-k-1} being the k-th span from the other
/// end. Control points there are extrapolated. Errors: curve_periodic; outer_knots_too_far, which says how far they
/// could lie, when an extrapolated weight is not positive or beyond doubles; not_computable. Cost O(p^2) plus the
/// copying. Source: The NURBS Book, A12.1.
[[nodiscard]] Result<Curve> unclamp(const Curve& curve, CurveEnd end);

/// The same for both ends. A uniform kind goes over into the clamped uniform one and back.
[[nodiscard]] Result<Curve> clamp_ends(const Curve& curve);
[[nodiscard]] Result<Curve> unclamp_ends(const Curve& curve);

/// Whether the curve has p+1 equal knots at this end of its domain and none outside.
bool is_clamped_at(const KnotVector& knots, CurveEnd end);

}  // namespace batten::core
