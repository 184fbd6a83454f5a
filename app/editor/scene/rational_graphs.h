/// The rational basis functions R_{i,p} over the others, in the plot.
#pragma once

#include "app/editor/scene/plot_frame.h"

namespace batten::editor {

/// Dashed, in the colors of their control points, over the domain; nothing where all weights are equal, for then they
/// are the basis functions, or where there are too many for the plot.
void draw_rational_graphs(PlotFrame& frame);

}  // namespace batten::editor
