/// The knots on their axis below the plot.
#pragma once

#include "app/editor/scene/plot_frame.h"

namespace batten::editor {

/// The diamonds of equal knots.
struct KnotStack {
    double value = 0.0;
    int multiplicity = 1;
    bool is_interior = false;  ///< strictly inside the domain, or the seam of a periodic curve
    bool is_lit = false;
    bool is_chosen = false;
    std::vector<glm::dvec2> places;  ///< from the axis upwards
};

/// The stacks in the shown range.
struct ShownStacks {
    std::vector<KnotStack> stacks;
    std::size_t count = 0;  ///< how many knots there are; more than diamonds where the strip cannot hold all
};

/// All stacks, or where they are too many one for each few pixels, those that are lit or chosen, and the ends of the
/// domain. Cost: that of the stacks.
ShownStacks knot_stacks(const PlotFrame& frame);

/// The axis and the stacks of diamonds: hollow inside the domain, gray at its ends and outside, hovered and selected
/// ones in the accent color. Diamonds shrink where knots are many.
void draw_knot_strip(PlotFrame& frame, const std::vector<KnotStack>& stacks);

/// Below each stack its value and "×4 clamped", "×2 C^{1}" or "C^{2}"; where there is no room the less important ones
/// are left out, and the second line where a ratio_bar needs its place. Returns the values that are left out.
std::vector<std::string> draw_knot_labels(PlotFrame& frame, std::vector<KnotStack> stacks);

/// A dashed line through the plot at knots that are hovered, selected or dragged.
void draw_knot_guides(PlotFrame& frame, const std::vector<KnotStack>& stacks);

}  // namespace batten::editor
