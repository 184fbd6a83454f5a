/// A cell of the recurrence in the plot: the two functions that it blends, and the ramps that they are multiplied by.
#pragma once

#include "app/editor/scene/plot_frame.h"

namespace batten::editor {

/// Whether a cell is pointed at while the recurrence is shown.
bool shows_recurrence(const PlotFrame& frame);

/// Nothing unless a cell of the triangle is pointed at. The other graphs fade.
void draw_recurrence_lines(PlotFrame& frame);

}  // namespace batten::editor
