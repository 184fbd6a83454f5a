/// Curves cut into edges where they meet: the graph on which shapes are combined.
#pragma once

#include <array>
#include <map>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/curve/curve.h"

namespace batten::core {

/// A part of a curve between two neighboring vertices.
struct CutEdge {
    std::size_t curve = 0;
    Interval range{};
    std::size_t from = 0;  ///< vertices
    std::size_t to = 0;
    Curve arc;               ///< clamped, seen from the origin of the graph, with its ends in the vertices
    std::size_t line = 0;    ///< edges that coincide are one line, named by the first of them
    bool is_turned = false;  ///< runs against that one
};

struct CutCurves {
    Point origin{};
    double size = 0.0;       ///< of all curves together
    double tolerance = 0.0;  ///< places that are nearer are one vertex
    std::vector<Point> vertices{};
    std::vector<CutEdge> edges{};            ///< curve by curve, in order of the parameter
    std::vector<std::size_t> first_edges{};  ///< of each curve, and one past the last edge
};

/// The graph of `curves`. The beginning of every curve is a vertex. Parts that coincide become edges with the same two
/// vertices and of one line. Errors: shapes_not_decided where curves run along each other too closely; those of
/// to_clamped and sub_curve. Cost: that of intersect_curves for pairs whose boxes meet, and O(n) for the edges.
[[nodiscard]] Result<CutCurves> cut_where_they_meet(std::span<const Curve> curves, const Progress& progress = {});

}  // namespace batten::core
