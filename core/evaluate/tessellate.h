/// Turns a curve into polylines that are true to a tolerance and cover only what is seen.
#pragma once

#include <vector>

#include "core/curve/curve.h"

namespace batten::core {

/// A point of the curve together with its parameter.
struct CurveSample {
    double u = 0.0;
    Point point{};
};

/// What to draw and how well.
struct TessellationRequest {
    double tolerance = 0.0;  ///< > 0: no point of the curve is farther than this from its polyline
    Box view;                ///< parts whose hull is outside are left out
    Interval range;          ///< the parameters wanted, which are cut to the domain
};

/// The visible part of `curve` as runs of samples, in order of u; a run ends where the curve leaves the view or tears.
/// The distance from the curve to the polyline is bounded by the tolerance (convex hull of the Bézier pieces), never
/// only sampled; below the rounding of the coordinates there is no finer. Samples are points of the curve as point_at
/// gives them, and a parameter that is sampled in two views has the same point in both. No chord is much longer than 64
/// views, so a straight piece has 2 samples unless it reaches far beyond the view. Cost grows with the visible part
/// only. Source: recursive halving of the homogeneous Bézier points.
std::vector<std::vector<CurveSample>> tessellate(const Curve& curve, const TessellationRequest& request);

}  // namespace batten::core
