/// The transform box with its handles, and the axis or center that is being clicked.
#pragma once

#include "app/editor/pointer/canvas_mode.h"
#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// The box of the transform tool; while it is dragged only its outline, as it comes to lie, and the pivot.
void draw_transform_box(CanvasFrame& frame, const CanvasMode& mode);

/// Makes labels keep clear of the grips of that box, and off its sides where they can; it is drawn over them.
void reserve_transform_box(CanvasFrame& frame);

/// The axis from its first point to the pointer, or the center under it; nothing while none is chosen.
void draw_axis_pick(CanvasFrame& frame);

}  // namespace batten::editor
