/// The point of a curve nearest to a given one.
#pragma once

#include "core/evaluate/tessellate.h"

namespace batten::core {

/// The nearest curve point to `query`, which is finite, and its parameter, over the whole domain. A part of the curve
/// is left out only when the Bernstein form of its squared distance proves that it is no nearer, so the global minimum
/// is found; Newton's iteration finishes. The distance is right to about 1e-14 of the size of curve and query together.
/// Of points that are equally near up to that, the one with the least parameter. Source: Chen et al. 2008, Computing
/// the minimum distance between a point and a NURBS curve.
CurveSample nearest_point(const Curve& curve, Point query);

}  // namespace batten::core
