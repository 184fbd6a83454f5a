/// Hodographs: the derivatives of a curve, as curves.
#pragma once

#include "core/curve/curve.h"

namespace batten::core {

/// The curve C'(u), over the same domain.
///
/// Of a polynomial curve it has degree p - 1, the knots without the first and the last one, and the control points
/// p (P_{i+1} - P_i) / (u_{i+p+1} - u_{i+1}). Of a polygon (p = 1), whose derivative jumps from leg to leg, it has
/// degree 1, each leg's derivative twice, and a tear at every corner. Of a rational curve it has degree 2p, with the
/// control points of the Bernstein form on every span and the weights of w(u)^2.
///
/// Where C' jumps, at knots of multiplicity p, the hodograph is torn. The hodograph of a periodic curve is periodic
/// unless it jumps. Errors: degree_out_of_range when a rational curve has a degree above 12; point_not_finite when a
/// derivative is too large for a double. Cost O(n), rational O(n p^2). Source: The NURBS Book, equation 3.8; for the
/// rational form the products of Bernstein polynomials (Farin 2002, section 13.2).
[[nodiscard]] Result<Curve> hodograph(const Curve& curve);

/// The curve C''(u), over the same domain.
///
/// Of a polynomial curve it is the hodograph of the hodograph; 0 where the degree is 1. Of a rational curve it has
/// degree 3p, with the control points of the Bernstein form on every span and the weights of w(u)^3. It is torn at
/// knots of multiplicity p - 1 and more. Errors as above, degree_out_of_range for a rational curve of degree above 8.
/// Cost O(n), rational O(n p^2).
[[nodiscard]] Result<Curve> second_hodograph(const Curve& curve);

}  // namespace batten::core
