/// How the derivatives on both sides of a smooth joint belong together.
#pragma once

#include <optional>

#include "core/measure/continuity.h"

namespace batten::core {

/// C'_+ = scale C'_- and, where the joint is G2, C''_+ = scale^2 C''_- + shift C'_-: what any curve with the same two
/// numbers has, too, so that it is G2 as well. 1 and 0 where the derivatives agree.
struct JointRelation {
    double scale = 1.0;
    double shift = 0.0;
};

/// Where the side before a joint ends: the joint's own parameter, and that of the upper end where ends meet.
double parameter_before(const Curve& curve, const JointContinuity& joint);

/// The relation at a joint of `curve` that is G^level, level 1 or 2. None where the curve stands still. Source: Barsky
/// and DeRose 1989.
std::optional<JointRelation> joint_relation(const Curve& curve, const JointContinuity& joint, int level);

}  // namespace batten::core
