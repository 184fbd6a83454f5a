/// The control points as a whole: their box, its middle, and the curve seen from there.
#pragma once

#include "core/curve/curve.h"

namespace batten::core {

/// The box of the control points, which contains the curve. Cost O(n).
Box control_box(const Curve& curve);

/// The middle of the control points' box, from which a curve is best seen. Cost O(n).
Point middle_of(const Curve& curve);

/// The same curve in coordinates whose zero is `origin`. Near it differences of coordinates keep their digits. All
/// weights are divided by one power of two, so that the largest is of the order of 1.
Curve seen_from(const Curve& curve, Point origin);

}  // namespace batten::core
