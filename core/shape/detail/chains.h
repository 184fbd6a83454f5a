/// Edges put together to closed curves.
#pragma once

#include "core/shape/detail/cut_curves.h"

namespace batten::core {

/// A line of the graph, run through forward or backward, with what is kept on its left.
struct ChainEdge {
    std::size_t line = 0;
    bool is_forward = true;

    bool operator==(const ChainEdge&) const = default;
};

/// Edges that follow one another.
struct Chain {
    std::vector<ChainEdge> edges{};
    bool is_closed = true;
};

/// The chains of all `edges`, each line once. Where several meet, those are neighbors that have the same part of the
/// inside between them, so that shapes that touch in a point come apart. What ends nowhere is a chain that is not
/// closed. Cost O(n log n).
std::vector<Chain> chains_of(const CutCurves& graph, std::span<const ChainEdge> edges);

/// The curve along `chain`, cut out of `originals`, which are those of the graph: a whole curve where the chain is one,
/// else a clamped curve of their parts. It begins with the first edge. Errors: those of sub_curve, reverse,
/// elevate_degree and shift_domain.
[[nodiscard]] Result<Curve> curve_along(const CutCurves& graph, std::span<const Curve> originals, const Chain& chain);

}  // namespace batten::core
