/// The rational basis functions R_i = N_i w_i / sum N_k w_k, on which a NURBS curve depends linearly by its points.
#pragma once

#include "core/curve/curve.h"
#include "core/evaluate/basis.h"

namespace batten::core {

/// The p+1 functions that do not vanish on one span.
struct RationalBasis {
    std::size_t first = 0;  ///< value j belongs to control point first + j of the unrolled curve
    /// derivatives[r][j] = d^r R_{first+j} / du^r; C^(r)(u) = sum of derivatives[r][j] P_{first+j}.
    ShortList<BasisRow, 1> derivatives;
};

/// The functions at `u` (brought into the domain) and their derivatives up to `order` (>= 0), seen from `side` at a
/// knot. For equal weights they are the basis functions themselves. Cost O(p^2 + order^2 p). Source: The NURBS
/// Book, 4.2 and 4.8.
RationalBasis rational_basis(const Curve& curve, double u, int order = 0, Side side = Side::right);

}  // namespace batten::core
