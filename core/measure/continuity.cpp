#include "core/measure/continuity.h"

#include <cassert>
#include <cmath>

#include "core/curve/control_box.h"
#include "core/curve/knot_analysis.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/detail/one_side.h"

namespace batten::core {

namespace {

// Of a derivative, relative: some operations more than its degree has.
constexpr double rounding_of_values = 64.0 * std::numeric_limits<double>::epsilon();

// The side as it is run through the other way.
OneSide turned(OneSide side) {
    side.jet.derivatives[0] = -side.jet.derivatives[0];
    if (side.tangent) side.tangent = -*side.tangent;
    if (side.curvature) side.curvature = -*side.curvature;
    return side;
}

class JointMeter {
  public:
    JointMeter(const Box& box, const ContinuityTolerances& tolerances)
        : tolerances_(tolerances),
          origin_(middle(box.lower, box.upper)),
          size_(robust_length(seen_from(box.upper, origin_) - seen_from(box.lower, origin_))),
          rounding_(rounding_in(box)) {
        assert(tolerances.position >= 0.0 && tolerances.derivative >= 0.0);
        assert(tolerances.angle >= 0.0 && tolerances.curvature >= 0.0);
    }

    OneSide look(const Curve& curve, double u, Side side) const {
        return look_at_side(curve, u, side, origin_, rounding_);
    }

    JointContinuity measure(JointKind kind, double u, const OneSide& left, const OneSide& right) const {
        JointContinuity joint{.kind = kind, .u = u, .left = seen(left), .right = seen(right), .angle = std::nullopt};
        joint.position.size = robust_length(right.jet.point - left.jet.point);
        joint.position.relative = size_ > 0.0 ? joint.position.size / size_ : 0.0;
        joint.position.rounding = 2.0 * rounding_;
        joint.first = jump(left, right, 1);
        joint.second = jump(left, right, 2);
        if (left.tangent && right.tangent) joint.angle = angle_between(*left.tangent, *right.tangent);
        joint.before = left.curvature;
        joint.after = right.curvature;
        const bool meets = is_near(joint.position.size);
        joint.parametric = meets ? parametric_level(joint) : -1;
        joint.geometric = meets ? geometric_level(joint) : -1;
        return joint;
    }

    bool meet(Point a, Point b) const { return is_near(robust_length(b - a)); }

  private:
    bool is_near(double distance) const { return distance <= tolerances_.position * size_ + 2.0 * rounding_; }

    JointSide seen(const OneSide& side) const {
        return {side.jet.point + vector_to(origin_), side.jet[1], side.jet[2]};
    }

    static Jump jump(const OneSide& left, const OneSide& right, std::size_t order) {
        const Vector a = left.jet[order];
        const Vector b = right.jet[order];
        const double size = robust_length(b - a);
        const double larger = std::max(robust_length(a), robust_length(b));
        return {size, size > 0.0 ? size / larger : 0.0,
                left.noise[order] + right.noise[order] + rounding_of_values * larger};
    }

    bool agrees(const Jump& jump) const { return jump.relative <= tolerances_.derivative || jump.is_rounding(); }

    int parametric_level(const JointContinuity& joint) const {
        if (!agrees(joint.first)) return 0;
        return agrees(joint.second) ? 2 : 1;
    }

    int geometric_level(const JointContinuity& joint) const {
        if (!joint.angle || !(std::abs(*joint.angle) <= tolerances_.angle)) return 0;
        if (!joint.before || !joint.after) return 1;
        const double larger = std::max({std::abs(*joint.before), std::abs(*joint.after), 1.0 / size_});
        return std::abs(*joint.after - *joint.before) <= tolerances_.curvature * larger ? 2 : 1;
    }

    const ContinuityTolerances& tolerances_;
    Point origin_;  // near it differences keep their digits
    double size_;
    double rounding_;
};

constexpr Side inside_of(CurveEnd end) {
    return end == CurveEnd::start ? Side::right : Side::left;
}

}  // namespace

std::optional<double> speed_ratio(const JointContinuity& joint) {
    const double before = robust_length(joint.left.first);
    const double after = robust_length(joint.right.first);
    if (!(before > 0.0 && after > 0.0) || !std::isfinite(after / before)) return std::nullopt;
    return after / before;
}

JointContinuity joint_continuity_at(const Curve& curve, const DistinctKnot& knot, const Box& box,
                                    const ContinuityTolerances& tolerances) {
    assert(knot.is_interior);
    const Interval domain = curve.domain();
    const bool is_seam = curve.is_periodic() && knot.value == domain.lower;
    const JointMeter meter(box, tolerances);
    auto joint = meter.measure(is_seam ? JointKind::seam : JointKind::knot, knot.value,
                               meter.look(curve, is_seam ? domain.upper : knot.value, Side::left),
                               meter.look(curve, knot.value, Side::right));
    joint.multiplicity = knot.multiplicity;
    joint.promised = knot.continuity;
    return joint;
}

std::vector<JointContinuity> joint_continuity_within(const Curve& curve, Interval range,
                                                     const ContinuityTolerances& tolerances) {
    const Box box = control_box(curve);
    std::vector<JointContinuity> joints;
    for (const DistinctKnot& knot : distinct_knots(curve.knots()))
        if (knot.is_interior && range.contains(knot.value))
            joints.push_back(joint_continuity_at(curve, knot, box, tolerances));
    return joints;
}

std::vector<JointContinuity> joint_continuity(const Curve& curve, const ContinuityTolerances& tolerances) {
    auto joints = joint_continuity_within(curve, curve.domain(), tolerances);
    if (curve.is_periodic()) return joints;
    const auto ends = continuity_of_ends(curve, tolerances);
    if (ends.geometric >= 0) joints.push_back(ends);
    return joints;
}

JointContinuity continuity_of_ends(const Curve& curve, const ContinuityTolerances& tolerances) {
    return continuity_of_ends(curve, control_box(curve), tolerances);
}

JointContinuity continuity_of_ends(const Curve& curve, const Box& box, const ContinuityTolerances& tolerances) {
    const Interval domain = curve.domain();
    const JointMeter meter(box, tolerances);
    return meter.measure(curve.is_periodic() ? JointKind::seam : JointKind::ends, domain.lower,
                         meter.look(curve, domain.upper, Side::left), meter.look(curve, domain.lower, Side::right));
}

JointContinuity continuity_between(const Curve& first, const Curve& second, JoinedEnds ends, const Box& box,
                                   const ContinuityTolerances& tolerances) {
    assert(!first.is_periodic() && !second.is_periodic());
    const JointMeter meter(box, tolerances);
    const double u = parameter_of(second.domain(), ends.second);
    OneSide left = meter.look(first, parameter_of(first.domain(), ends.first), inside_of(ends.first));
    OneSide right = meter.look(second, u, inside_of(ends.second));
    if (ends.first == CurveEnd::start) left = turned(left);
    if (ends.second == CurveEnd::end) right = turned(right);
    return meter.measure(JointKind::curves, u, left, right);
}

std::vector<JoinedEnds> ends_that_meet(const Curve& first, const Curve& second, const Box& box,
                                       const ContinuityTolerances& tolerances) {
    assert(!first.is_periodic() && !second.is_periodic());
    const JointMeter meter(box, tolerances);
    std::vector<JoinedEnds> meeting;
    for (const JoinedEnds& ends : all_joined_ends)
        if (meter.meet(point_at(first, parameter_of(first.domain(), ends.first)),
                       point_at(second, parameter_of(second.domain(), ends.second))))
            meeting.push_back(ends);
    return meeting;
}

bool is_closed(const Curve& curve, const ContinuityTolerances& tolerances) {
    return curve.is_periodic() || continuity_of_ends(curve, tolerances).geometric >= 0;
}

}  // namespace batten::core
