/// A part of a curve replaced by another shape, joined smoothly to what stays (shape-changing).
#pragma once

#include "core/curve/approximation.h"

namespace batten::core {

/// The curve with the part between its points nearest to the ends of `shape` replaced by `shape`, in whichever
/// direction that runs, and how far the new part is from `shape`. The new part is joined with curvature (G2; in degree
/// 2 with the tangent, in degree 1 with the point) to what stays, wherefore it may lead up to `shape` where that begins
/// beside the curve; an end of the curve that `shape` reaches goes where that does. Of a closed curve the part is
/// replaced that is nearer to `shape`, also through the seam, which then is moved to the end of the part. It gets as
/// few knots as keep it within `tolerance`, not many more than twice those of `shape`, nor than 60. Control points,
/// weights and knots outside, but for those that act on the part, keep every bit; the domain stays unless the seam is
/// moved. Errors, in this order: tolerance_not_positive; range_empty where both ends of `shape` are nearest to one
/// point; not_computable. Cost O(n) and O(p^3) for each knot of the part. Source: blossoms (Ramshaw 1987) for what
/// stays; least squares with parameters corrected by projection (Hoschek 1988, Intrinsic parametrization for
/// approximation) for the part.
[[nodiscard]] Result<Approximation> redraw(const Curve& curve, const Curve& shape, double tolerance);

}  // namespace batten::core
