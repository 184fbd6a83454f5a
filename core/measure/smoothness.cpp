#include "core/measure/smoothness.h"

#include <algorithm>

namespace batten::core {

namespace {

constexpr double leniency = 10.0;

ContinuityTolerances lenient() {
    ContinuityTolerances tolerances;
    tolerances.position *= leniency;
    tolerances.derivative *= leniency;
    tolerances.angle *= leniency;
    tolerances.curvature *= leniency;
    return tolerances;
}

constexpr int smoothest = 2;

// The G level of the curve with these joints, ascending, at `u`.
int level_at(const std::vector<JointContinuity>& joints, double u) {
    const auto found = std::ranges::lower_bound(joints, u, {}, [](const JointContinuity& joint) { return joint.u; });
    return found != joints.end() && found->u == u ? found->geometric : smoothest;
}

// Without the ends.
std::vector<JointContinuity> joints_at_knots(const Curve& curve, const ContinuityTolerances& tolerances = {}) {
    return joint_continuity_within(curve, curve.domain(), tolerances);
}

void add_loss_at_ends(std::vector<SmoothnessLoss>& losses, const Curve& before, const Curve& after) {
    if (before.is_periodic() || after.is_periodic()) return;
    const int level = continuity_of_ends(before).geometric;
    const JointContinuity ends = continuity_of_ends(after, lenient());
    if (ends.geometric < level) losses.push_back({level, ends});
}

}  // namespace

std::vector<SmoothnessLoss> smoothness_losses(const Curve& before, const Curve& after) {
    const auto joints = joints_at_knots(before);
    std::vector<SmoothnessLoss> losses;
    for (const JointContinuity& joint : joints_at_knots(after, lenient())) {
        const int level = level_at(joints, joint.u);
        if (joint.geometric < level) losses.push_back({level, joint});
    }
    add_loss_at_ends(losses, before, after);
    return losses;
}

}  // namespace batten::core
