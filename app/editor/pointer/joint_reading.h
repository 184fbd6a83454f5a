/// What the joint tool tells of the places that were picked, while it is not yet done.
#pragma once

#include <string>
#include <vector>

#include "app/editor/pointer/joint_mode.h"
#include "app/editor/state/state.h"

namespace batten::editor {

/// What jumps between the two ends as they are, and what would be left of it; empty where there are no two ends. What
/// is left is found of the last control points alone, so that the cost is bounded.
std::vector<std::string> joint_reading(const EditorState& state, const PickingJoint& mode);

}  // namespace batten::editor
