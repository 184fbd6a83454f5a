/// The B-spline basis functions N_{i,p} and their derivatives.
#pragma once

#include "core/base/detail/short_list.h"
#include "core/curve/knot_vector.h"

namespace batten::core {

/// A number for each of the p+1 functions.
using BasisRow = ShortList<double, 8>;

/// The p+1 functions that do not vanish on one span.
struct BasisValues {
    std::size_t span = 0;  ///< index s; value j belongs to N_{s-p+j,p}
    /// derivatives[r][j] = d^r N_{s-p+j,p} / du^r; row 0 holds the values, which sum to 1.
    ShortList<BasisRow, 1> derivatives;
};

/// The non-vanishing functions at `u` (brought into the domain) and their derivatives up to order `derivative_count`
/// (0..; those above p are zero), seen from `side` at a knot.
/// Cost O(p^2 + derivative_count^2 p + log n); the values alone, up to degree 7, take nothing from the heap. Source:
/// The NURBS Book, A2.2 and A2.3, with the same steps in another order.
BasisValues basis_functions(const KnotVector& knots, double u, int derivative_count = 0, Side side = Side::right);

/// N_{i,p}(u) alone: the spline whose control points are 1 at i, below their count, and 0 elsewhere, so for a periodic
/// vector with all its repetitions, by any of which `i` may name it. Zero outside its support and outside the domain;
/// the domain's end belongs to the last span. Cost O(p^2).
double basis_function(const KnotVector& knots, std::size_t i, double u);

/// The parameters where N_{i,p} is not zero, `i` as before, cut to the domain; one point where nothing of it is inside.
/// For a periodic vector it begins in the domain and is given whole and unwrapped, so that it may leave the domain at
/// its upper end.
Interval basis_support(const KnotVector& knots, std::size_t i);

}  // namespace batten::core
