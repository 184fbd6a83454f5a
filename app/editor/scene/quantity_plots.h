/// Curvature and speed over the parameter, below the knot strip and on its axis.
#pragma once

#include "app/editor/scene/plot_frame.h"

namespace batten::editor {

/// κ(u) and |C′(u)| with zero, round numbers beside, the knots, and their values at the parameter. They break at knots
/// where they jump; what goes to a pole is cut off.
void draw_curvature_plot(PlotFrame& frame);
void draw_speed_plot(PlotFrame& frame);

}  // namespace batten::editor
