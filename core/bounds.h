/// Boxes and hulls around curves and control points.
#pragma once

#include <span>
#include <vector>

#include "core/curve.h"

namespace batten::core {

/// The box of the control points, which contains the curve.
Box control_box(const Curve& curve);

/// The convex hull of `points`, counter-clockwise, without collinear points; fewer than three points come back as they
/// are. Cost O(n log n). Source: Andrew 1979.
std::vector<Point> convex_hull(std::span<const Point> points);

}  // namespace batten::core
