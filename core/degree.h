/// Changes the degree of a curve, with or without keeping its shape.
#pragma once

#include "core/curve.h"

namespace batten::core {

/// The same curve in degree p + `by` (by >= 1; shape-keeping). Every multiplicity grows by `by`; an unclamped vector
/// keeps as many knots outside its domain as the new degree needs. Error: degree_out_of_range. Cost O(by n p^3).
/// Source: blossoms (Ramshaw 1987): the new control points are averages of the old blossom.
[[nodiscard]] Result<Curve> elevate_degree(const Curve& curve, int by = 1);

/// The curve in degree p - 1 that agrees with this one at the Greville points of the lower degree (shape-changing,
/// exact when the curve is an elevated one); the ends of a clamped curve stay. Multiplicities shrink by one, at least
/// to one. Errors: degree_out_of_range; too_few_points (periodic: 2); weight_not_positive when weights differ too much
/// to be met in the lower degree.
[[nodiscard]] Result<Curve> reduce_degree(const Curve& curve);

/// The curve with the same control points in another degree (shape-changing): a special kind is regenerated over the
/// same domain (a Bézier polygon becomes clamped uniform when its degree falls, a piecewise one when its points do not
/// fit the degree); a custom vector is never regenerated, so its degree is elevated or reduced instead. Errors:
/// degree_out_of_range; too_few_points; those of reduce_degree.
[[nodiscard]] Result<Curve> set_degree(const Curve& curve, int degree);

}  // namespace batten::core
