/// The curve with other control points, evenly spaced knots and another degree, near an old one (shape-changing).
#pragma once

#include "core/base/progress.h"
#include "core/curve/approximation.h"

namespace batten::core {

/// The curve of degree `degree` with `count` control points over evenly spaced knots and equal weights, clamped, or
/// periodic where `curve` is, that is nearest to `curve` by least squares at equal shares of the length: so it is run
/// through at an even speed, over the old domain. An open curve keeps its ends to the last bit. Corners are rounded.
/// The error is a bound of the largest distance where both are run through at an even speed. Errors:
/// degree_out_of_range; too_few_points (p+1; 2 when periodic); curve_stands_still for a curve that is a single point;
/// equations_singular; not_computable. Cost O((m + n) p^2) for m and n control points, and the measuring of the length.
[[nodiscard]] Result<Approximation> rebuild(const Curve& curve, std::size_t count, int degree,
                                            const Progress& progress = {});

}  // namespace batten::core
