/// Commands that choose what the joint tool does.
#pragma once

#include "app/editor/command.h"
#include "app/editor/state/joint_tool.h"

namespace batten::editor {

inline constexpr std::size_t joint_operation_count = core::Names<JointOperation>::table.size();
inline constexpr std::size_t joint_continuity_count = core::Names<core::GeometricContinuity>::table.size();

/// One command for each operation, which takes the joint tool for it.
const CommandSpec& joint_operation_spec(JointOperation operation);

template <JointOperation operation>
struct UseJointTool {
    static const CommandSpec& spec() { return joint_operation_spec(operation); }
};

/// One command for each continuity that the tool can make.
const CommandSpec& joint_continuity_spec(core::GeometricContinuity continuity);

template <core::GeometricContinuity continuity>
struct UseJointContinuity {
    static const CommandSpec& spec() { return joint_continuity_spec(continuity); }
};

/// Chooses the continuity, as keys do.
struct SetJointContinuity {
    core::GeometricContinuity continuity;
    static const CommandSpec& spec();
};

/// On which sides the tool's offsets are, and what they have at corners and at the ends of an open curve.
struct SetJointOffset {
    bool both_sides;
    core::OffsetCorners corners;
    core::OffsetCaps caps;
    static const CommandSpec& spec();
};

/// The radius of the tool's fillets, and the distances of its chamfers.
struct SetJointRadius {
    double radius;
    static const CommandSpec& spec();
};

}  // namespace batten::editor
