/// Inserts many knots at once without changing the curve (shape-keeping).
#pragma once

#include "core/curve/curve.h"

namespace batten::core {

/// The same curve with all of `added`, in any order; a value that stands there twice is inserted twice. Control points
/// out of reach keep every bit. Cost: at most p blends for each knot plus the copying, so O(p) for each point of the
/// result. Errors, of the least offending value: parameter_not_finite;
/// parameter_outside_domain; multiplicity_full when a multiplicity would exceed p, or the p+1 of an end knot and, with
/// Tears::allow, of every knot of an open curve: there the curve may be pulled apart afterward. Source: Boehm and
/// Prautzsch 1985; The NURBS Book, A5.4.
[[nodiscard]] Result<Curve> refine_knots(const Curve& curve, std::vector<double> added, Tears tears = Tears::refuse);

}  // namespace batten::core
