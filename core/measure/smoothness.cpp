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

bool is_end(const JointContinuity& joint) {
    return joint.kind == JointKind::ends;
}

}  // namespace

std::vector<SmoothnessLoss> smoothness_losses(const Curve& before, const Curve& after) {
    auto joints = joint_continuity(before);
    std::erase_if(joints, is_end);
    std::vector<SmoothnessLoss> losses;
    for (const JointContinuity& joint : joint_continuity(after, lenient())) {
        if (is_end(joint)) continue;
        const int level = level_at(joints, joint.u);
        if (joint.geometric < level) losses.push_back({level, joint});
    }
    return losses;
}

}  // namespace batten::core
