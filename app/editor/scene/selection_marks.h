/// What is selected beside points of the active curve: whole curves, and points of other curves.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// A band under the curves beside the active one that are selected as wholes.
void draw_selected_others(CanvasFrame& frame);

/// The same under the active curve, which the frame must have.
void draw_selected_active(CanvasFrame& frame);

/// The control points of other curves of which points are selected; of very many, selected ones alone, and some of
/// these.
void draw_other_points(CanvasFrame& frame);

}  // namespace batten::editor
