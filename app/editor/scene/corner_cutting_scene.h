/// How a knot cuts the corners of the control polygon, on the canvas and in the plot.
#pragma once

#include "app/editor/scene/canvas_frame.h"
#include "app/editor/scene/plot_frame.h"

namespace batten::editor {

/// The corners that are cut off, as areas below the curve.
void draw_cut_corners(CanvasFrame& frame);

/// The polygon that is not the curve's own, before the insertion as a ghost or after it, and the new points on their
/// legs with their alphas.
void draw_corner_cutting(CanvasFrame& frame);

/// The basis functions that the insertion changes, dashed as they are on its other side: after it, or before.
void draw_cut_functions(PlotFrame& frame);

}  // namespace batten::editor
