/// How smooth a curve really is at its knots, beside what its knots promise.
#pragma once

#include <optional>
#include <vector>

#include "core/curve/curve.h"
#include "core/curve/curve_end.h"
#include "core/curve/knot_analysis.h"

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
    knot,   ///< inside the domain
    seam,   ///< of a periodic curve
    ends,   ///< the two ends of an open curve, if they meet
    curves  ///< an end of one curve and one of another
};

/// A jump between the values on both sides.
struct Jump {
    double size = 0.0;      ///< |after - before|
    double relative = 0.0;  ///< of the larger of both, for positions of the size of the curve; 0 without a jump
    double rounding = 0.0;  ///< what rounding of coordinates and values may make of no jump

    bool is_rounding() const { return size <= rounding; }
};

/// How a curve goes on on one side of a joint.
struct JointSide {
    Point point{};
    Vector first{};   ///< C'
    Vector second{};  ///< C''
};

/// The continuity at one joint. Levels are -1 (a gap) to 2.
struct JointContinuity {
    JointKind kind = JointKind::knot;
    double u = 0.0;        ///< the knot; of ends the parameter behind the joint
    int multiplicity = 0;  ///< 0 for ends that meet
    int promised = -1;     ///< C^(p - multiplicity), what every choice of control points has; -1 for ends that meet
    JointSide left{};      ///< the limits from before the joint
    JointSide right{};     ///< and from behind it
    Jump position{};       ///< of C
    Jump first{};          ///< of C'
    Jump second{};         ///< of C''
    std::optional<double> angle;     ///< by which the tangent turns, in (-pi, pi]; none where a side is a single point
    std::optional<double> before{};  ///< curvature before the joint; none at zero speed
    std::optional<double> after{};   ///< curvature after it
    int parametric = -1;             ///< the C level found: position, C', C'' agree
    int geometric = -1;              ///< the G level found: position, tangent direction, curvature agree
};

/// |C'| after the joint, divided by that before: the factor between the two derivatives of a joint that is G1. None
/// where the curve stands still on a side.
std::optional<double> speed_ratio(const JointContinuity& joint);

/// The joint at `knot`, an interior one of distinct_knots(), of a curve whose control points have the box `box`, which
/// is kept by who asks for many. Cost O(p^3) however long the curve is.
JointContinuity joint_continuity_at(const Curve& curve, const DistinctKnot& knot, const Box& box,
                                    const ContinuityTolerances& tolerances = {});

/// Every distinct knot inside the domain in order, the seam of a periodic curve first; last the ends of an open curve
/// if they meet. "C0 by its knots but G1 by its shape" is promised == 0 and geometric == 1. At zero speed the tangent
/// is the one-sided limit of the direction, so that a cusp, where C' and C'' agree, is G0; it has no curvature.
std::vector<JointContinuity> joint_continuity(const Curve& curve, const ContinuityTolerances& tolerances = {});

/// The same for the knots in `range` alone, and without the ends. Cost O(p^3) for each of them, and O(n).
std::vector<JointContinuity> joint_continuity_within(const Curve& curve, Interval range,
                                                     const ContinuityTolerances& tolerances = {});

/// What joins the end of an open curve to its beginning, whether they meet or not; with the `box` of its control points
/// at the cost O(p^3).
JointContinuity continuity_of_ends(const Curve& curve, const ContinuityTolerances& tolerances = {});
JointContinuity continuity_of_ends(const Curve& curve, const Box& box, const ContinuityTolerances& tolerances = {});

/// What joins two open curves at these ends, whether they meet or not, run through from the first into the second:
/// where that is against the sense of a curve, C' changes its sign and so does the curvature. `box` contains both
/// curves' control points. Cost O(p^3).
JointContinuity continuity_between(const Curve& first, const Curve& second, JoinedEnds ends, const Box& box,
                                   const ContinuityTolerances& tolerances = {});

/// The ends of two open curves that meet within the tolerance for positions, of the size of `box`, which contains both
/// curves' control points. Cost O(p^2).
std::vector<JoinedEnds> ends_that_meet(const Curve& first, const Curve& second, const Box& box,
                                       const ContinuityTolerances& tolerances = {});

/// Whether the curve is periodic or its ends meet within the tolerance for positions, so that it encloses an area.
bool is_closed(const Curve& curve, const ContinuityTolerances& tolerances = {});

}  // namespace batten::core
