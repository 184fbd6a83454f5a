/// Exchanges the knots at an end of a spline, keeping the piece there and so its shape.
#pragma once

#include <cassert>
#include <utility>

#include "core/curve/curve_end.h"
#include "core/curve/detail/spline.h"

namespace batten::core {

/// The spline seen from this end, which becomes its start. Its own inverse.
template <class P>
Spline<P> seen_from_end(Spline<P> spline, CurveEnd end) {
    return end == CurveEnd::end ? mirrored(std::move(spline)) : spline;
}

/// The same spline with p+1 equal knots at the start of its domain and none before. Cost O(p^2) plus the copying.
/// Source: Boehm 1980.
template <class P>
Spline<P> clamped_at_start(Spline<P> spline) {
    const std::size_t p = spline.p;
    const double a = spline.domain().lower;
    if (spline.multiplicity(a) < p) insert_ascending(spline, std::vector(p - spline.multiplicity(a), a));
    const std::size_t outside = spline.last_of_run(a) - p;
    const auto count = static_cast<std::ptrdiff_t>(outside);
    spline.knots.erase(spline.knots.begin(), spline.knots.begin() + count);
    spline.points.erase(spline.points.begin(), spline.points.begin() + count);
    spline.knots.front() = a;
    return spline;
}

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
                blend_between(spline.points[k], spline.points[k + 1], a, spline.knots[p + k + 1], values[r - 1]);
}

}  // namespace batten::core
