/// The polynomials of one basis function in the plot, each in a color of its own and going on beyond its span.
#pragma once

#include "app/editor/scene/plot_frame.h"

namespace batten::editor {

/// The pieces that the card of polynomials tells of.
void draw_piece_graphs(PlotFrame& frame);

}  // namespace batten::editor
