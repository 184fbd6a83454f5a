/// The teaching views on the canvas and in the plot; each draws only while its overlay is shown.
#pragma once

#include <optional>

#include "app/editor/scene/canvas_frame.h"
#include "app/editor/scene/plot_frame.h"

namespace batten::editor {

/// What lies below curve and points, and what lies above them. The frame must have a curve.
void draw_views_below(CanvasFrame& frame);
void draw_views_above(CanvasFrame& frame);

/// Where on the canvas those marks of views are that a fitted picture shows whole, like arrows and teeth, as far as
/// the picture and its margin hold them; none where no such view is on.
std::optional<render::PixelBox> reach_of_views(const EditorState& state, SceneCache& cache);

/// The pictures in boxes over the canvas. The frame must have a curve.
void draw_insets(CanvasFrame& frame);

/// What lies below the graphs of the plot, and what lies above them.
void draw_plot_views_below(PlotFrame& frame);
void draw_plot_views_above(PlotFrame& frame);

}  // namespace batten::editor
