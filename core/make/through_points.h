/// The curve through fit points.
#pragma once

#include "core/base/progress.h"
#include "core/curve/curve.h"
#include "core/make/fit_points.h"

namespace batten::core {

/// The curve with C(parameters[k]) = points[k].place. Its knots are the parameters: once inside what is smooth, twice
/// for a cubic of the local kind, p-1 times where a tangent is given or a straight line goes on smoothly, p times at
/// corners. What lies between corners, given tangents and lines depends on nothing else. Ends and corners with nothing
/// given are natural: C'' = 0, and of degree 5 C''' = C'''' = 0 (C''' = 0 where the tangent is given), which makes c2
/// and fair the curves with the least integral of |C''|^2 and |C'''|^2. Of the local kind C' is that of the parabola
/// through a point and its neighbors. A closed curve is periodic and begins at the first point; its integral is that of
/// one period. Points on a line give that line. Errors: those of check_fit_points; equations_singular; not_computable.
/// Cost O(n). Source: de Boor 1978, chapters IV and V; Schoenberg 1964.
[[nodiscard]] Result<Curve> through_points(const FitPoints& fit, const Progress& progress = {});

}  // namespace batten::core
