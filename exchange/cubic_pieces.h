/// A curve as lines, parabolas and cubics, which is all that drawing programs have.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/curve/curve.h"

namespace batten::exchange {

/// One polynomial Bézier curve of degree 1 to 3.
struct CubicPiece {
    int degree = 3;
    std::array<core::Point, 4> points{};  ///< degree + 1 of them
    bool is_first = false;                ///< of a run: it does not begin where the piece before ends

    std::span<const core::Point> control_points() const {
        return {points.data(), static_cast<std::size_t>(degree) + 1};
    }
};

/// A curve as such pieces, in order.
struct CubicPieces {
    std::vector<CubicPiece> pieces;
    double error = 0.0;      ///< no point of the curve is farther from the pieces, nor the other way round; 0: exact
    bool is_closed = false;  ///< one run that ends exactly where it begins
};

/// The curve as pieces within `tolerance` (> 0, in coordinates): exact where its piece over a span is a line or a
/// polynomial of degree 3 at most, else cubics with the tangents of the curve at their ends, over spans that are halved
/// until the error is within the tolerance. The error is bounded by control points of the difference of the curve and
/// the cubic, whose parameter is matched to that of the curve. A span is halved at most 20 times and never beyond
/// doubles, so the error may be larger for huge numbers, and infinite beyond doubles; it is told.
/// Cost O(p^2) for each exact piece and each halving of the others.
CubicPieces cubic_pieces(const core::Curve& curve, double tolerance);

/// The same for one rational Bézier piece; no weights stand for equal ones.
CubicPieces cubic_pieces(std::span<const core::Point> points, std::span<const double> weights, double tolerance);

/// The curve whose points these are; the pieces must have been made by cubic_pieces().
core::Curve curve_of(const CubicPiece& piece);

}  // namespace batten::exchange
