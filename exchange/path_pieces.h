/// A curve as what drawing programs know: lines, quadratic and cubic Bézier pieces, arcs of circles.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/curve/curve.h"

namespace batten::exchange {

struct PathPiece {
    int degree = 1;                       ///< 1, 2 or 3; 0 for an arc of a circle
    std::array<core::Point, 4> points{};  ///< degree + 1; of an arc its two ends
    double radius = 0.0;                  ///< of an arc, which is at most half of its circle
    bool is_counterclockwise = false;     ///< likewise
    bool is_first = false;                ///< of a run: it does not begin where the piece before ends
    bool closes = false;                  ///< the last one of a run that ends exactly where it began

    std::span<const core::Point> control_points() const { return {points.data(), last() + 1}; }
    core::Point start() const { return points.front(); }
    core::Point end() const { return points[last()]; }
    void set_end(core::Point end) { points[last()] = end; }

    /// The index of the end.
    std::size_t last() const { return degree == 0 ? 1 : static_cast<std::size_t>(degree); }
};

struct PathPieces {
    std::vector<PathPiece> pieces;  ///< in order
    double error = 0.0;  ///< no point of the curve is farther from the pieces, nor the other way round, rounding and
                         ///< all; 0 where they are the curve itself but for rounding; infinite beyond doubles
};

/// Whether arcs of circles are told as such.
enum class Arcs { as_arcs, as_cubics };

/// The pieces of the curve: the curve itself where it is polynomial of degree 3 or less, of degree 1, or made of arcs
/// of circles that are wanted as such; else cubics within `tolerance` (> 0, in coordinates) with the tangents of the
/// curve at their ends, over spans that are halved until their bound (cubic_fit) is within it, but at most 30 times
/// each, `most_halvings` times in all, and not beyond the rounding of doubles; so the error, which is told, may be
/// larger. Pieces are joined bit-equal where the curve does not come apart, also those of periodic curves at their
/// seam. Cost O(p^2) for each piece that is tried.
PathPieces path_pieces(const core::Curve& curve, double tolerance, Arcs arcs = Arcs::as_cubics,
                       std::size_t most_halvings = 250'000);

}  // namespace batten::exchange
