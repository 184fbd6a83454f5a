/// Where lines from a place meet a curve at a right angle, or touch it.
#pragma once

#include <vector>

#include "core/evaluate/tessellate.h"

namespace batten::core {

/// The places of the curve, in order of u, where the line to `from`, which is finite, stands at a right angle to the
/// curve: (C - from) . C' = 0. A place where the curve passes `from` or stands still is one too. None where that is so
/// on a stretch, as from the center of an arc. Found globally, in Bernstein form; a corner that only is nearest is
/// none. Cost: that of an expression of degree 2p to 4p in each span.
std::vector<CurveSample> perpendicular_feet(const Curve& curve, Point from);

/// Likewise the places whose tangent passes `from`: (C - from) x C' = 0.
std::vector<CurveSample> tangent_points(const Curve& curve, Point from);

}  // namespace batten::core
