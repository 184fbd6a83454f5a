/// The de Boor construction at the view's parameter.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// The segments on which the points of levels 1 to shown_level lie, these points, and what belongs to a hovered cell.
void draw_construction(CanvasFrame& frame);

/// C(u) as a disc; hollow while the construction has not come that far.
void draw_curve_point(CanvasFrame& frame);

}  // namespace batten::editor
