/// Joins two curves to one, with the continuity asked for.
#pragma once

#include "core/base/names.h"
#include "core/curve/curve.h"

namespace batten::core {

/// C: equal derivatives by the parameter. G: equal tangent directions (and curvatures), whatever the speed.
enum class JoinContinuity { c0, c1, c2, g1, g2 };

template <>
struct Names<JoinContinuity> {
    static constexpr std::array table{Named{JoinContinuity::c0, "C0", "C0"}, Named{JoinContinuity::c1, "C1", "C1"},
                                      Named{JoinContinuity::c2, "C2", "C2"}, Named{JoinContinuity::g1, "G1", "G1"},
                                      Named{JoinContinuity::g2, "G2", "G2"}};
};

struct JoinedCurve {
    Curve curve;
    double error = 0.0;  ///< how far the second curve moved: the largest deviation of its part, measured
};

/// One curve that is `first` over its domain and then `second`, changed at its beginning alone.
///
/// The second curve keeps the spacing of its knots; its domain is shifted to begin where the first one's ends, and its
/// weights are multiplied by a common factor so that they agree there. Of its control points only the first one is
/// moved for C0, the first two for C1 and G1, the first three for C2 and G2; no weight changes otherwise: P0 goes to
/// the end of the first curve; for C the others go where the derivatives there put them; for G1, P1 keeps its distance
/// from P0; for G2, P2 moves along the normal alone. Degrees are made equal by elevation, and raised until the second
/// curve, which is clamped at both ends, has at least one control point more than are moved, so that its end stays. The
/// knot at the joint has multiplicity p; for C1 and C2 it loses as many knots as rounding allows, all of 1 and 2 unless
/// weights differ.
///
/// Errors: curve_periodic; curve_stands_still where a direction or curvature is needed and an end has none; those of
/// elevate_degree and shift_domain. Source: derivatives of rational curves, The NURBS Book, 4.8.
[[nodiscard]] Result<JoinedCurve> join(const Curve& first, const Curve& second, JoinContinuity continuity);

}  // namespace batten::core
