/// What a control point acts on: its part of the curve and its strip of parameters.
#pragma once

#include "app/editor/scene/canvas_frame.h"
#include "app/editor/scene/plot_frame.h"

namespace batten::editor {

/// The parts of the curve that the points with support move, as bands in their colors with the parameters of their
/// ends.
void draw_support(CanvasFrame& frame);

/// The same as strips of the plot, with their knots.
void draw_support_strip(PlotFrame& frame);

}  // namespace batten::editor
