/// The Bézier pieces of a curve, one for each non-empty span.
#pragma once

#include <vector>

#include "core/curve/curve.h"

namespace batten::core {

/// One rational polynomial piece in Bernstein form.
struct BezierPiece {
    Interval interval;                     ///< where in the curve's domain
    std::size_t span = 0;                  ///< the span index in the curve's knots
    std::vector<HomogeneousPoint> points;  ///< p+1 control points
};

/// The piece over span `span` (non-empty, in the domain). Cost O(p^3). Source: blossoms, b(a, ..., a, b, ..., b).
BezierPiece bezier_piece(const Curve& curve, std::size_t span);

/// All pieces in order. Cost O(p^2) for each, which has p+1 points. Source: Boehm and Prautzsch 1985.
std::vector<BezierPiece> bezier_pieces(const Curve& curve);

}  // namespace batten::core
