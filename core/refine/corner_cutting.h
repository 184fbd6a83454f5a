/// The insertion of one knot as data: which legs of the control polygon are cut where, before and after it happened.
#pragma once

#include <vector>

#include "core/curve/curve.h"

namespace batten::core {

/// A corner of the polygon before the insertion.
struct OldCorner {
    std::size_t index = 0;  ///< among its control points
    Point point{};
    double weight = 1.0;
};

/// One new point Q_i = (1 - alpha) P_{i-1} + alpha P_i, in homogeneous coordinates, alpha = (u - u_i) / (u_{i+p} -
/// u_i).
struct LegCut {
    std::size_t i = 0;          ///< as in the formula; of a periodic curve in the numbering of the unrolled points
    std::size_t new_index = 0;  ///< among the control points after the insertion
    Point point{};
    double weight = 1.0;
    double alpha = 0.0;
    Interval knots{};        ///< [u_i, u_{i+p}], of the knots before the insertion
    double leg_share = 0.0;  ///< where it lies on its leg in the plane: alpha w_i / w(Q_i), from 0 at P_{i-1} to 1
};

/// How inserting u once cuts the corners of a control polygon: p-m-1 of them go and p-m points come, where m is the
/// multiplicity of u before; so 0 < alpha < 1.
struct CornerCutting {
    double u = 0.0;
    int multiplicity = 0;            ///< m, below p
    std::vector<OldCorner> corners;  ///< P_{k-p}, ..., P_{k-m}, u_k the last knot that is not above u; all but the
                                     ///< first and the last one go
    std::vector<double>
        knots;  ///< u_{k-p}, ..., u_{k-m+p+1} before the insertion, over which the corners' functions are
    std::vector<LegCut> cuts;  ///< Q_{k-p+1}, ..., Q_{k-m}; cuts[j] is on the leg from corners[j] to [j+1]
};

/// What insert_knot(curve, u) does. Errors: parameter_not_finite; parameter_outside_domain; multiplicity_full where m
/// is p; too_few_points where a period of fewer than p-m points winds round itself, so that its legs are cut more than
/// once. Cost O(p). Source: Boehm 1980; The NURBS Book, A5.1.
[[nodiscard]] Result<CornerCutting> corner_cutting(const Curve& curve, double u);

/// A cutting that has happened.
struct UndoneCutting {
    CornerCutting cutting;   ///< of the older curve, by which its new points are those of the insertion
    double deviation = 0.0;  ///< a bound of how far the older curve is from the present one: but for rounding 0, as
                             ///< long as nothing but the insertion has happened to the points around
};

/// What an insertion of u did from which `curve` came, found by taking the knot out again as remove_knot() does. Where
/// points were moved since, the nearest older polygon is meant and `deviation` says how near. Errors:
/// parameter_not_finite; parameter_outside_domain; knot_not_found where u is no knot strictly inside the domain (a
/// multiple one at a periodic seam); multiplicity_full at a tear; too_few_points as above; not_computable. Cost O(p^3),
/// whatever the number of points.
[[nodiscard]] Result<UndoneCutting> corner_cutting_undone(const Curve& curve, double u);

}  // namespace batten::core
