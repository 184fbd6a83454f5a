/// The offset of a curve of degree 1.
#pragma once

#include "core/curve/approximation.h"

namespace batten::core {

/// The polygon of the legs of `curve`, of degree 1 without tears, moved by `distance` to the left, mitred where they
/// meet; same knots and weights. The error is the largest difference between `distance` and the distance of a leg of
/// the result from the old one, which rounding makes. Errors: curve_stands_still for a leg without length;
/// curve_has_corner where the polygon turns back; leg_vanishes where a leg would shrink to nothing or turn around.
[[nodiscard]] Result<Approximation> offset_polygon(const Curve& curve, double distance);

}  // namespace batten::core
