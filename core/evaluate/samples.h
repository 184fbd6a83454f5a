/// Many points of a curve.
#pragma once

#include <span>

#include "core/curve/curve.h"

namespace batten::core {

/// The points at `parameters` as point_at gives them, up to rounding, many times faster where they ascend; `points` has
/// as many places. In the last digits a point depends on the processor and on its neighbors. Cost O(p) for a point
/// where several are asked for in a span, and O(p^3) for such a span; O(p^2) for any other point, and O(log n) where it
/// is far from the one before. No threads.
void sample(const Curve& curve, std::span<const double> parameters, std::span<Point> points);

}  // namespace batten::core
