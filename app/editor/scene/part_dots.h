/// Dots that divide the curve into parts of equal parameter or equal length.
#pragma once

#include "app/editor/scene/canvas_frame.h"
#include "app/editor/scene/plot_frame.h"

namespace batten::editor {

/// Full dots at equal steps of u; rings at equal lengths, which fit around the dots.
void draw_equal_steps(CanvasFrame& frame);
void draw_equal_lengths(CanvasFrame& frame);

/// The same at their parameters, on the axis of the plot.
void draw_steps_on_axis(PlotFrame& frame);
void draw_lengths_on_axis(PlotFrame& frame);

}  // namespace batten::editor
