/// Changes the degree of a curve, with or without keeping its shape.
#pragma once

#include "core/base/progress.h"
#include "core/curve/approximation.h"

namespace batten::core {

/// The same curve in degree p + `by` (by >= 1; shape-keeping). Every multiplicity grows by `by`; an unclamped vector
/// keeps as many knots outside its domain as the new degree needs. Control points are convex combinations of the old
/// ones, so they are right to a few units in the last place in every degree. Errors: degree_out_of_range;
/// knots_coincide where knots of a period are too close for the next one; not_computable. Cost O(p^2) for each step and
/// point. Source: Prautzsch 1984; Prautzsch and Piper 1991.
[[nodiscard]] Result<Curve> elevate_degree(const Curve& curve, int by = 1);

/// The curve in degree p - 1 that agrees with this one at the Greville points of the lower degree (shape-changing,
/// exact when the curve is an elevated one); the ends of a clamped curve stay. Where the curve is smoother at a knot
/// than its multiplicity in the lower degree promises, it stays G1, and from degree 3 on G2, and the Greville points
/// are only met as well as that allows; so it does where ends meet, if that leaves p control points or more free.
/// Multiplicities shrink by one, at least to one. Errors: degree_out_of_range; too_few_points (periodic: 2);
/// weight_not_positive when weights differ too much to be met in the lower degree.
[[nodiscard]] Result<Curve> reduce_degree(const Curve& curve, const Progress& progress = {});

/// The curve in degree p - `by` (by >= 1), by so many of these steps, and a bound of the deviation they make.
/// Errors: tolerance_not_positive; deviation_too_large when it is above `tolerance` (> 0, in the units of the points);
/// not_computable; those of reduce_degree.
[[nodiscard]] Result<Approximation> reduce_degree(const Curve& curve, int by, double tolerance,
                                                  const Progress& progress = {});

/// The curve with the same control points in another degree (shape-changing): a special kind is regenerated over the
/// same domain (a Bézier polygon becomes clamped uniform when its degree falls, a piecewise one when its points do not
/// fit the degree), and so are equal spans with other ends; unequal ones are never regenerated, so their degree is
/// elevated or reduced instead. Errors: degree_out_of_range; too_few_points; those of reduce_degree.
[[nodiscard]] Result<Curve> set_degree(const Curve& curve, int degree);

}  // namespace batten::core
