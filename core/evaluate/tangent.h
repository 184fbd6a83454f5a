/// The direction of a curve, also where its speed is zero.
#pragma once

#include <optional>

#include "core/curve/curve.h"

namespace batten::core {

/// The unit vector along which the curve leaves u (Side::right) or arrives there (Side::left), in both cases in the
/// sense of growing u: the first derivative that is not zero, up to the degree, of the homogeneous curve. Derivatives
/// that rounding cannot tell from zero, given the control points of the span, count as zero. None where the piece is a
/// single point. At the ends of an open curve's domain the side is the one inside. Cost O(p^3).
std::optional<Vector> tangent_at(const Curve& curve, double u, Side side = Side::right);

}  // namespace batten::core
