/// Splines by their definition: slow, plain and in long double, to compare the algorithms with.
#pragma once

#include "core/curve/curve.h"

namespace batten::core::reference {

/// N_{i,p}(u) over `knots` by the recursion of Cox and de Boor, with N_{i,0} = 1 on span `span` alone.
long double basis_function(std::span<const double> knots, std::size_t p, std::size_t i, std::size_t span,
                           long double u);

/// C(u) = sum N_i w_i P_i / sum N_i w_i for u in the domain, the span sought from the left end on; for a periodic curve
/// over knots unrolled here.
Point point_at(const Curve& curve, double u);

/// The distance of two points, measured by the largest coordinate of the control points of `curve`.
double relative_distance(const Curve& curve, Point a, Point b);

}  // namespace batten::core::reference
