/// The knots on their axis below the plot.
#pragma once

#include "app/editor/scene/plot_frame.h"

namespace batten::editor {

/// The axis and the stacks of diamonds: hollow inside the domain, gray at its ends and outside, hovered and selected
/// ones in the accent color. Diamonds shrink where knots are many.
void draw_knot_strip(PlotFrame& frame);

/// Below each stack its value and "×4 clamped", "×2 C^{1}" or "C^{2}"; where there is no room the less important ones
/// are left out.
void draw_knot_labels(PlotFrame& frame);

/// A dashed line through the plot at knots that are hovered, selected or dragged.
void draw_knot_guides(PlotFrame& frame);

}  // namespace batten::editor
