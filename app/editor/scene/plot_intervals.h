/// Where the plot samples what is one polynomial over each span.
#pragma once

#include <vector>

#include "core/curve/knot_vector.h"

namespace batten::editor {

/// Neighboring samples, both in the closed span.
struct PlotInterval {
    core::Interval u;
    std::size_t span = 0;
};

/// The part of `range` that lies in the domain, cut at every knot and into pieces of at most `spacing_px`, where the
/// whole range is `width_px` wide. None where there are more spans than such pieces: then no graph could be told from
/// another.
std::vector<PlotInterval> plot_intervals(const core::KnotVector& knots, core::Interval range, double width_px,
                                         double spacing_px);

}  // namespace batten::editor
