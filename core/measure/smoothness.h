/// What a curve lost of the smoothness that it had by its shape.
#pragma once

#include <vector>

#include "core/measure/continuity.h"

namespace batten::core {

/// A joint at which a curve is less smooth than it was before it was changed.
struct SmoothnessLoss {
    int before = 2;           ///< the G level there; 2 where it was no knot
    JointContinuity after{};  ///< the joint as it is now, with u, angle, curvatures and gap
};

/// Where `after`, made from `before` over the same domain, has a lower G level at a knot than `before` had there, in
/// the order of the knots; the seam of a periodic curve counts, and so do, last, the ends of an open one that met. Of
/// jumps no larger than ten of the tolerances nothing is said, so that what is smooth within them just so stays so.
/// Cost O(n p^2).
std::vector<SmoothnessLoss> smoothness_losses(const Curve& before, const Curve& after);

}  // namespace batten::core
