/// Exchanges the knots at the clamped start of a spline, keeping its first piece and so its shape.
#pragma once

#include <cassert>

#include "core/curve/detail/spline.h"

namespace batten::core {

/// `spline` begins with p+1 knots a, of which `values` (at most p) replace the innermost ones in this order; the first
/// points become the blossoms of the first piece at their new knots. The knots themselves are left to the
/// caller. Cost O(p^2). Source: blossoms; The NURBS Book, A12.1, which this is for outer knots.
template <class P>
void exchange_start_knots(Spline<P>& spline, std::span<const double> values) {
    const std::size_t p = spline.p;
    assert(values.size() <= p);
    const double a = spline.knots[p];
    // A point has as many of the knots a as it has places to the first knot behind them; it gets the first values.
    for (std::size_t r = 1; r <= values.size(); ++r)
        for (std::size_t k = 0; k + r <= values.size(); ++k)
            spline.points[k] =
                blend(spline.points[k], spline.points[k + 1], ratio_between(a, spline.knots[p + k + 1], values[r - 1]));
}

}  // namespace batten::core
