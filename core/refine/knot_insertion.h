/// Inserts knots without changing the curve (shape-keeping).
#pragma once

#include "core/curve/curve.h"

namespace batten::core {

/// The same curve with `u` inserted `times` (>= 1) more often. Errors: parameter_not_finite; parameter_outside_domain;
/// multiplicity_full when the multiplicity would exceed p, or the p+1 of an end knot and, with Tears::allow, of every
/// knot of an open curve. Cost O(times p) plus the copying. Source: Boehm 1980; The NURBS Book, A5.1.
[[nodiscard]] Result<Curve> insert_knot(const Curve& curve, double u, int times = 1, Tears tears = Tears::refuse);

/// The same curve with one knot more in the middle of every non-empty span of the domain that has one. Cost O(n p).
[[nodiscard]] Result<Curve> insert_midpoint_knots(const Curve& curve);

}  // namespace batten::core
