/// Control points moved onto one line.
#pragma once

#include "core/curve/curve.h"

namespace batten::core {

/// The curve with the control points from `first` to `last` moved squarely onto the line through these two, which stay
/// (shape-changing); with p + 1 points or more a straight piece. When periodic, `last` < `first` means the way across
/// the seam. Errors: point_index_out_of_range; too_few_points (p + 1); points_coincide when `first` and `last` do.
[[nodiscard]] Result<Curve> straighten(const Curve& curve, std::size_t first, std::size_t last);

}  // namespace batten::core
