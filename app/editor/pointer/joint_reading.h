/// What the joint tool tells of the places that were picked, while it is not yet done.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/editor/pointer/joint_mode.h"
#include "app/editor/state/state.h"

namespace batten::editor {

/// The rows of the reading for each meeting of two curves: the first has the smoothness with gap and turn, then come
/// curvature and its change.
inline constexpr std::size_t rows_of_meeting = 3;

/// What jumps between the two ends as they are, and what would be left of it; empty where there are no two ends.
/// Lengths are in the document's unit, curvatures in its inverse. What is left is found of the last control points
/// alone, so that the cost is bounded.
std::vector<std::string> joint_reading(const EditorState& state, const PickingJoint& mode);

}  // namespace batten::editor
