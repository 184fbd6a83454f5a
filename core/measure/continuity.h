/// How smooth a curve really is at its knots, beside what its knots promise.
#pragma once

#include <optional>
#include <vector>

#include "core/curve/curve.h"

namespace batten::core {

/// When two one-sided values count as equal. All are >= 0, relative and not to be confused with rounding, which is
/// allowed for besides: the error of the coordinates as given, carried through the derivatives.
struct ContinuityTolerances {
    double position = 1e-9;    ///< of the size of the curve
    double derivative = 1e-6;  ///< of the larger of the two derivatives
    double angle = 1e-6;       ///< radians between the tangents
    double curvature = 1e-6;   ///< of the largest of both curvatures and 1 / size of the curve
};

/// Where two pieces of a curve meet.
enum class JointKind {
    knot,  ///< inside the domain
    seam,  ///< of a periodic curve
    ends   ///< the two ends of an open curve, if they meet
};

/// A jump between the values on both sides.
struct Jump {
    double size = 0.0;      ///< |after - before|
    double relative = 0.0;  ///< of the larger of both, for positions of the size of the curve; 0 without a jump
};

/// The continuity at one joint. Levels are -1 (a gap) to 2.
struct JointContinuity {
    JointKind kind = JointKind::knot;
    double u = 0.0;        ///< the knot; at the ends of an open curve the lower end of the domain
    int multiplicity = 0;  ///< 0 for ends that meet
    int promised = -1;     ///< C^(p - multiplicity), what every choice of control points has; -1 for ends that meet
    Jump position{};       ///< of C
    Jump first{};          ///< of C'
    Jump second{};         ///< of C''
    std::optional<double> angle;     ///< by which the tangent turns, in (-pi, pi]; none where a side is a single point
    std::optional<double> before{};  ///< curvature before the joint; none at zero speed
    std::optional<double> after{};   ///< curvature after it
    int parametric = -1;             ///< the C level found: position, C', C'' agree
    int geometric = -1;              ///< the G level found: position, tangent direction, curvature agree
};

/// Every distinct knot inside the domain in order, the seam of a periodic curve first; last the ends of an open curve
/// if they meet. "C0 by its knots but G1 by its shape" is promised == 0 and geometric == 1. At zero speed the tangent
/// is the one-sided limit of the direction, so that a cusp, where C' and C'' agree, is G0; it has no curvature.
std::vector<JointContinuity> joint_continuity(const Curve& curve, const ContinuityTolerances& tolerances = {});

/// The same for the knots in `range` alone, and without the ends. Cost O(p^3) for each of them, and O(n).
std::vector<JointContinuity> joint_continuity_within(const Curve& curve, Interval range,
                                                     const ContinuityTolerances& tolerances = {});

/// What joins the end of an open curve to its beginning, whether they meet or not.
JointContinuity continuity_of_ends(const Curve& curve, const ContinuityTolerances& tolerances = {});

/// Whether the curve is periodic or its ends meet within the tolerance for positions, so that it encloses an area.
bool is_closed(const Curve& curve, const ContinuityTolerances& tolerances = {});

}  // namespace batten::core
