/// What lies on both sides of the edges of a graph of curves.
#pragma once

#include <array>

#include "core/shape/detail/cut_curves.h"

namespace batten::core {

/// Winding numbers of two sets of curves.
using WindingPair = std::array<int, 2>;

/// What lies beside a line, seen along its first edge.
struct LineSides {
    WindingPair left{};
    WindingPair right{};
};

/// The sides of each line of `graph`, by the number of its first edge (of other edges nothing). `sets` is 0 or 1 for
/// each curve. All curves must be closed. Error: shapes_not_decided where a line has no place that is clear of all
/// others. Cost O(log n) for each line, and that of what is near it.
[[nodiscard]] Result<std::vector<LineSides>> sides_of_lines(const CutCurves& graph, std::span<const std::size_t> sets,
                                                            const Progress& progress = {});

}  // namespace batten::core
