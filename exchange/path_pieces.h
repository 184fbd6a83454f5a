/// A curve as what drawing programs know: lines, quadratic and cubic Bézier pieces, arcs of circles.
#pragma once

#include <array>
#include <vector>

#include "core/curve/curve.h"

namespace batten::exchange {

struct PathPiece {
    int degree = 1;                       ///< 1, 2 or 3; 0 for an arc of a circle
    std::array<core::Point, 4> points{};  ///< degree + 1; of an arc its two ends
    double radius = 0.0;                  ///< of an arc, which is at most half of its circle
    bool is_counterclockwise = false;     ///< likewise

    core::Point start() const { return points[0]; }
    core::Point end() const { return points[last()]; }
    void set_end(core::Point end) { points[last()] = end; }

    /// The index of the end.
    std::size_t last() const { return degree == 0 ? 1 : static_cast<std::size_t>(degree); }
};

struct PathPieces {
    std::vector<PathPiece> pieces;  ///< in order, each from where the one before ends, unless the curve is torn there
    double error = 0.0;  ///< no point of the curve is farther from the pieces; 0 where they are the curve itself
};

/// The pieces of the curve: the curve itself where it is polynomial of degree 3 or less, of degree 1, or made of arcs
/// of circles, but for rounding; else cubic_pieces() within `tolerance` (> 0), one for each span once there are
/// `most_path_pieces`. A closed curve ends in its first point, bit-equal. Cost O(p^2) for each piece that is tried.
PathPieces path_pieces(const core::Curve& curve, double tolerance);

inline constexpr std::size_t most_path_pieces = 4'000'000;

}  // namespace batten::exchange
