/// The graphs of the basis functions in the colors of their control points.
#pragma once

#include "app/editor/scene/plot_frame.h"

namespace batten::editor {

/// One function as far as it is shown.
struct BasisGraph {
    std::vector<std::vector<glm::dvec2>>
        runs;                    ///< in pixels, from left to right; a run ends where the function jumps or is zero
    glm::dvec2 peak{0.0, 1e30};  ///< the highest place
};

/// Graph i belongs to control point i; it is empty where the function vanishes over the whole range. Runs are true to a
/// quarter of a pixel, with few points. The functions of a periodic curve go on from its end at its start.
std::vector<BasisGraph> basis_graphs(const PlotFrame& frame);

/// The graphs, those that do not act at the parameter dimmed, those that are lit thick; their numbers above their
/// maxima as far as there is room; discs where the active ones meet the line at the parameter.
void draw_basis_graphs(PlotFrame& frame, const std::vector<BasisGraph>& graphs);
void draw_basis_numbers(PlotFrame& frame, const std::vector<BasisGraph>& graphs);
void draw_basis_values(PlotFrame& frame);

}  // namespace batten::editor
