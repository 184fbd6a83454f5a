/// The difference of two curves as a rational Bézier curve, whose control points bound it.
#pragma once

#include <vector>

#include "core/measure/detail/common_spans.h"

namespace batten::core {

/// a - b over a part that is inside one span of both: |a(u) - b(u)| is at most bound().
struct DifferencePiece {
    std::vector<HomogeneousPoint> points;  ///< (D x, D y, D) with D > 0, in units of `unit`
    double unit = 1.0;                     ///< a power of two, so that squares neither overflow nor vanish
    double reach = 0.0;                    ///< how far the control points of both curves are apart at most, in units
    double rounding = 0.0;                 ///< how far each point (x, y) may be from the truth, in units

    /// At least the largest distance, but for the last bits of the number itself; infinite where it is too large for a
    /// double.
    double bound() const;

    /// A distance that is reached at one of the ends; 0 where weights are too different for doubles to tell.
    double distance_at_ends() const;

    /// The two halves.
    std::pair<DifferencePiece, DifferencePiece> halves() const;
};

enum class Precision {
    plain,   ///< in doubles, seen from a point of the piece
    twofold  ///< some 30 digits, for curves that are nearly one; some twenty times as slow
};

/// The difference over `common`. Its degree is at most the sum of both. For A / v and B / w it is
/// (w A - v B) / (v w), by products in Bernstein form; the control points of a difference of polynomials are the
/// differences of the control points. Cost O(p^2). Source: Farouki and Rajan 1988.
DifferencePiece difference_piece(const Curve& a, const Curve& b, const CommonSpan& common, Precision precision);

}  // namespace batten::core
