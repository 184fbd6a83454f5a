/// The basis functions stacked on one another: areas that fill the plot from 0 to 1 over the domain.
#pragma once

#include "app/editor/scene/plot_frame.h"

namespace batten::editor {

/// Whether areas stand in place of the graphs: not where the functions are too many for the plot.
bool shows_basis_areas(const EditorState& state, const PlotLayout& layout);

/// The areas, unless a cell of the recurrence is pointed at; on the line at u stand the values and their sum.
void draw_basis_areas(PlotFrame& frame);

}  // namespace batten::editor
