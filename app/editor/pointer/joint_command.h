/// What the joint tool would do with the places that were picked, as a command and in words.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/editor/command.h"
#include "app/editor/pointer/joint_mode.h"
#include "app/editor/state/state.h"

namespace batten::editor {

/// The command that completes what was begun, on the committed document in which the curve of the first place is
/// active; none where places are missing or cannot be used together.
std::optional<Command> joint_command(const EditorState& state, const PickingJoint& mode);

/// The same for an operation with one place, whose curve is active.
Command command_at(JointOperation operation, double u);

/// What jumps between the two ends as they are, and with the preview where it tells; empty where there are no two ends.
std::vector<std::string> joint_reading(const EditorState& state, const PickingJoint& mode);

/// What a click would do.
std::string joint_hint(const EditorState& state, const PickingJoint& mode);

}  // namespace batten::editor
