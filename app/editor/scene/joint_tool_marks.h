/// What the joint tool shows: the places picked, what jumps between them, and the part that would go.
#pragma once

#include "app/editor/pointer/joint_mode.h"
#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

void draw_picked_joint(CanvasFrame& frame, const PickingJoint& mode);

}  // namespace batten::editor
