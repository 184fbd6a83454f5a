/// The area inside a closed curve and its center of gravity.
#pragma once

#include <optional>

#include "core/curve/curve.h"

namespace batten::core {

/// What a closed curve encloses.
struct Area {
    double signed_area = 0.0;       ///< positive when run through counter-clockwise; parts run round twice count twice
    double error = 0.0;             ///< of the area, an estimate from above
    std::optional<Point> centroid;  ///< of the signed area; none where that cannot be told from zero, as in a figure 8
};

/// The area by Green's theorem, with the integrals along the curve by adaptive Gauss-Kronrod, which is exact for
/// polynomial pieces (after halving, for high degrees):
///     A = 1/2 integral of det(C, C'),    centroid = 1/(3A) integral of C det(C, C')
/// computed from the middle of the curve, so that nothing cancels far from the origin. Error: curve_not_closed, unless
/// the curve is periodic or its ends meet to 1e-9 of its size, or where it is torn inside.
[[nodiscard]] Result<Area> enclosed_area(const Curve& curve);

}  // namespace batten::core
