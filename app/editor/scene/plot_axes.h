/// What stands behind and above the graphs: shaded spans, lines at 0, 0.5 and 1, the title and the parameter.
#pragma once

#include <string>

#include "app/editor/scene/plot_frame.h"

namespace batten::editor {

/// Shades what is outside of the domain, what is lit, and the active span; draws the horizontal lines with their
/// numbers.
void draw_plot_axes(PlotFrame& frame);

/// "Basis functions N_{i,3}(u)" on the left, then `note` where there is room, "▶ 0.5× u = 0.400" on the right.
void draw_plot_title(PlotFrame& frame, const std::string& note);

/// The vertical line at u through plot and strip.
void draw_parameter_line(PlotFrame& frame);

}  // namespace batten::editor
