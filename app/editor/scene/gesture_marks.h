/// What a gesture under way shows: the selection's box, or the curve that is being drawn.
#pragma once

#include "app/editor/pointer/canvas_mode.h"
#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

void draw_gesture_marks(CanvasFrame& frame, const CanvasMode& mode);

}  // namespace batten::editor
