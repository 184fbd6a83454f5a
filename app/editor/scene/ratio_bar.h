/// The knots that make the ratio of a hovered point of the construction, below the knot strip.
#pragma once

#include "app/editor/scene/plot_frame.h"

namespace batten::editor {

/// Whether a cell of level >= 1 is hovered, so that there is a ratio to show.
bool has_ratio_bar(const PlotFrame& frame);

/// The interval [u_i, u_{i+p-r+1}] as a bar below the values of the knots, cut at u: the part before u is the share of
/// the later point, the part after it that of the earlier one; each says so where there is room. Of a closed curve the
/// interval comes in again at the other end where it leaves the period, once. Nothing without a ratio.
void draw_ratio_bar(PlotFrame& frame);

}  // namespace batten::editor
