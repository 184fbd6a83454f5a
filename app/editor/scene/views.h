/// The teaching views on the canvas and in the plot; each draws only while its overlay is shown.
#pragma once

#include "app/editor/scene/canvas_frame.h"
#include "app/editor/scene/plot_frame.h"

namespace batten::editor {

/// What lies below curve and points, and what lies above them. The frame must have a curve.
void draw_views_below(CanvasFrame& frame);
void draw_views_above(CanvasFrame& frame);

/// The pictures in boxes over the canvas. The frame must have a curve.
void draw_insets(CanvasFrame& frame);

/// What lies below the graphs of the plot, and what lies above them.
void draw_plot_views_below(PlotFrame& frame);
void draw_plot_views_above(PlotFrame& frame);

}  // namespace batten::editor
