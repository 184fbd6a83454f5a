/// The curve itself: ghost, the active curve and its parts.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// The color of a curve, its own, where it is seen on the canvas, or that of the theme.
render::Color color_of(const core::DocumentCurve& item, const Theme& theme);

/// The color of a curve that is not the active one: dimmer, and more so where it is locked.
render::Color color_of_other(const core::DocumentCurve& item, const Theme& theme);

/// A part of the active curve, which should begin and end at knots; the frame must have a curve.
void draw_part(CanvasFrame& frame, core::Interval range, const Stroke& stroke);

/// The active curve before a shape-changing edit.
void draw_ghost(CanvasFrame& frame);

/// A glow under the parts that belong to what is hovered; the frame must have a curve.
void draw_lit_parts(CanvasFrame& frame);

/// The active curve, its direction, and the span of the parameter in the accent color; the frame must have a curve.
void draw_active_curve(CanvasFrame& frame);

/// A mark where the pointer is on the curve: a diamond with the tool that inserts knots, else a disc.
void draw_hovered_place(CanvasFrame& frame);

/// How a place of the curve that the pointer is on is marked, on the canvas and in insets.
Symbol hovered_place_symbol(const Theme& theme);

}  // namespace batten::editor
