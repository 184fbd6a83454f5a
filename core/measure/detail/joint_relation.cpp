#include "core/measure/detail/joint_relation.h"

#include "core/evaluate/evaluate.h"

namespace batten::core {

double parameter_before(const Curve& curve, const JointContinuity& joint) {
    return joint.kind == JointKind::ends ? curve.domain().upper : joint.u;
}

std::optional<JointRelation> joint_relation(const Curve& curve, const JointContinuity& joint, int level) {
    const Jet before = derivatives_at(curve, parameter_before(curve, joint), 2, Side::left);
    const Jet after = derivatives_at(curve, joint.u, 2, Side::right);
    const double speed = robust_length(before[1]);
    if (speed == 0.0 || robust_length(after[1]) == 0.0) return std::nullopt;
    if (joint.parametric >= level) return JointRelation{};
    JointRelation relation;
    if (joint.parametric < 1) relation.scale = robust_length(after[1]) / speed;
    relation.shift = dot(after[2] - relation.scale * relation.scale * before[2], before[1] / speed) / speed;
    return relation;
}

}  // namespace batten::core
