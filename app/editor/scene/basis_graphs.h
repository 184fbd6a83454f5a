/// The graphs of the basis functions in the colors of their control points.
#pragma once

#include "app/editor/scene/basis_cache.h"
#include "app/editor/scene/plot_frame.h"

namespace batten::editor {

/// The functions that do not vanish over the whole range.
struct ShownBasis {
    std::vector<const BasisGraph*> graphs;  ///< of the cache
    std::size_t count = 0;                  ///< how many there are; more than graphs where the plot cannot hold all
};

/// All functions over their whole supports, also outside the domain, in the order of their control points; where they
/// are too many, those that act at the parameter or are lit, wide ones, and of narrow ones one for each few pixels.
/// Runs are true to a quarter of a pixel, nearer where the picture will be enlarged, with few points. The functions of
/// a periodic curve go on from its end at its start. Cost: that of the graphs that the cache lacks; where they are too
/// many, one look at each knot when knots or axes are others.
ShownBasis basis_graphs(const PlotFrame& frame, BasisCache& cache);

/// The graphs, those that do not act at the parameter dimmed, those that are lit thick; their numbers above their
/// maxima as far as there is room; discs where the active ones meet the line at the parameter.
void draw_basis_graphs(PlotFrame& frame, const std::vector<const BasisGraph*>& graphs);
void draw_basis_numbers(PlotFrame& frame, const std::vector<const BasisGraph*>& graphs);
void draw_basis_values(PlotFrame& frame);

}  // namespace batten::editor
