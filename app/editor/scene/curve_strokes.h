/// The curves themselves: ghost, other curves, the active curve and its parts.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// The active curve before a shape-changing edit.
void draw_ghost(CanvasFrame& frame);

/// All visible curves but the active one, thinner and dimmer than that; a hovered one at full strength.
void draw_other_curves(CanvasFrame& frame);

/// A glow under the parts that belong to what is hovered; the frame must have a curve.
void draw_lit_parts(CanvasFrame& frame);

/// The active curve, its direction, and the span of the parameter in the accent color; the frame must have a curve.
void draw_active_curve(CanvasFrame& frame);

/// A mark where the pointer is on the curve: a diamond with the tool that inserts knots, else a disc.
void draw_hovered_place(CanvasFrame& frame);

}  // namespace batten::editor
