/// The joints of the active curve that edits keep.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// A square around a corner, a ring around a smooth joint and two around one of steady curvature: of knots that are
/// seen, and of ends. Nothing where knots are hidden.
void draw_marked_joints(CanvasFrame& frame);

}  // namespace batten::editor
