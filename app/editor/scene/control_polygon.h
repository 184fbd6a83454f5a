/// The control polygon and the hull of the active span.
#pragma once

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

/// Dashes, pale ones where other points are edited instead.
Stroke control_polygon_stroke(const CanvasFrame& frame);

/// The polygon as far as it is seen.
SeenLine polygon_line(const CanvasFrame& frame);

/// The dashed legs, a hovered one solid.
void draw_control_polygon(CanvasFrame& frame, const SeenLine& line);

/// The convex hull of the points that act on the active span, or of what is lit, which shows its hull even where the
/// overlay is off.
void draw_hull(CanvasFrame& frame);

}  // namespace batten::editor
