/// A path of straight legs and arcs of circles, each arc given by its bulge.
#pragma once

#include <span>

#include "core/curve/curve.h"

namespace batten::exchange {

/// The path through `points`, of whose legs number i, from point i to the next, is an arc with the bulge `bulges[i]`:
/// the tangent of a quarter of its angle, positive to the left, 0 for a straight leg. Closed paths return to the first
/// point and are periodic. Of degree 1 without arcs, else of degree 2 with arcs of at most a right angle in each piece;
/// exact up to rounding. Points that repeat the one before them are left out. Errors: those of core::polyline.
[[nodiscard]] core::Result<core::Curve> bulged_polyline(std::span<const core::Point> points,
                                                        std::span<const double> bulges, bool is_closed);

}  // namespace batten::exchange
