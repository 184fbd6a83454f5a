/// Small bends of a control polygon to the wrong side, taken out.
#pragma once

#include <span>
#include <vector>

#include "core/base/geometry.h"

namespace batten::core {

/// Moves points of an open polygon, but its ends, onto the line between two others where a run of them turns to another
/// side than what is before and behind it, and none of them goes farther than `tolerance` from where it was. So the
/// curve with these control points has fewer inflections and is nowhere farther than that from where it was.
/// Cost O(n^2) for such points.
void calm_polygon(std::span<Point> points, double tolerance);

}  // namespace batten::core
