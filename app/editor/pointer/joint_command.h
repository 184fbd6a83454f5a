/// What the joint tool would do with the places that were picked, as a command and in words.
#pragma once

#include <optional>
#include <string>

#include "app/editor/command.h"
#include "app/editor/pointer/joint_mode.h"
#include "app/editor/state/state.h"
#include "core/refine/join.h"

namespace batten::editor {

/// The command that completes what was begun, on the committed document in which the curve of the first place is
/// active; none where places are missing or cannot be used together.
std::optional<Command> joint_command(const EditorState& state, const PickingJoint& mode);

/// The same for an operation with one place, whose curve is active.
Command command_at(JointOperation operation, double u);

/// The continuity of the tool as that of a join by shape; only the points by derivatives.
core::JoinContinuity as_join(core::GeometricContinuity continuity);

/// The parameter of a match on the curve of this place: that of an end where one was meant.
double match_parameter(const EditorState& state, const PickedCurvePlace& place);

/// What a click would do.
std::string joint_hint(const EditorState& state, const PickingJoint& mode);

}  // namespace batten::editor
