/// Conversions between closed curves: clamped with ends that meet, wrapped control points, truly periodic.
#pragma once

#include "core/curve/approximation.h"

namespace batten::core {

/// The truly periodic curve for a closed one (see closing.h), over the same domain.
/// A periodic curve comes back as it is. From wrapped points the repeated ones are dropped; exact. Otherwise, where the
/// ends meet, the seam gets multiplicity p, which is exact up to the gap, and then loses as many knots as it can while
/// the deviation stays within `tolerance` (> 0, in the units of the points), so that the seam is as smooth by its knots
/// as the curve is there. Where the weights at the ends differ, the parameter is first changed by a linear rational
/// function that makes them equal; that keeps the shape and the domain, but moves knots inside it.
/// The error is measured against the curve (with changed parameter) over all spans. Errors: tolerance_not_positive;
/// ends_apart; not_computable; too_few_points when fewer than 2 remain; multiplicity_too_high for a curve that is torn
/// inside. Cost O(n p^2).
[[nodiscard]] Result<Approximation> to_periodic(const Curve& curve, double tolerance);

/// The clamped curve with the same points and the same domain: a periodic curve is opened at its seam, an open one has
/// its end knots raised to p + 1 and loses the knots outside the domain. Exact: knots are only inserted, and control
/// points out of their reach keep every bit. Cost O(p^2) at each end plus the copying. Source: Boehm 1980.
[[nodiscard]] Result<Curve> to_clamped(const Curve& curve);

/// The open, unclamped curve with wrapped control points: the n + p points of the unrolled periodic curve, the last p
/// being bit-equal to the first, over its n + 2p + 1 unrolled knots. What is not periodic goes through to_periodic,
/// whose tolerance and errors apply; a wrapped curve comes back as it is. Source: The NURBS Book, section 12.2.
[[nodiscard]] Result<Approximation> to_wrapped(const Curve& curve, double tolerance);

/// The closed curve, beginning and ending at `u`, over [u, u + length of the domain]; closed in the same way as before.
/// Shape-keeping. Where `u` is no knot of a periodic curve it is inserted. The old seam becomes a knot like any other:
/// of multiplicity p in a clamped curve, whose ends, if they differ by no more than `tolerance` (> 0), become its first
/// point, and whose parameter changes as in to_periodic where its end weights differ; the error is what closing it
/// changed. Errors: parameter_not_finite; parameter_outside_domain; tolerance_not_positive; ends_apart; those of
/// to_periodic.
[[nodiscard]] Result<Approximation> move_seam(const Curve& curve, double u, double tolerance);

}  // namespace batten::core
