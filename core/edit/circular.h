/// Makes pieces circular by a weight (shape-changing).
#pragma once

#include "core/curve/curve.h"

namespace batten::core {

/// The curve of degree 2 whose piece at `u` is an arc of a circle: the weight of the point in which its end tangents
/// meet becomes root(w0 w2) sin a, where a is half the angle between them; all else stays. Errors, checked in this
/// order: degree_unsuitable; parameter_not_finite; parameter_outside_domain; piece_not_bezier unless both its knots
/// occur twice at least, so that its ends are control points; points_collinear; legs_unequal unless they are equally
/// long within circle_tolerance. Source: The NURBS Book, 7.3.
[[nodiscard]] Result<Curve> make_circular(const Curve& curve, double u);

}  // namespace batten::core
