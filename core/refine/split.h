/// Cuts a curve into parts (shape-keeping).
#pragma once

#include "core/curve/curve.h"

namespace batten::core {

/// The part of the curve over [a, b]; both new ends are clamped, knots keep their values, and an end of an open curve's
/// domain stays as it is, clamped or not. For a periodic curve `a` is any parameter of the domain and b at most one
/// period above it; b <= a means b one period later, so that the part crosses the seam, and a = b opens the curve at a.
/// Errors: parameter_not_finite; parameter_outside_domain; range_empty when b <= a in an open curve. Cost O(p^2) plus
/// the copying.
[[nodiscard]] Result<Curve> sub_curve(const Curve& curve, double a, double b);

/// The two parts before and after `u`; a periodic curve, which has no ends, is opened there into one clamped curve over
/// [u, u + period]. Errors: parameter_not_finite; parameter_outside_domain; parameter_at_end for an end of an open
/// curve. Cost O(p^2) plus the copying.
[[nodiscard]] Result<std::vector<Curve>> split(const Curve& curve, double u);

}  // namespace batten::core
