/// Integrals along the pieces of a curve, sharp however far apart its weights are.
#pragma once

#include "core/base/detail/quadrature.h"
#include "core/evaluate/detail/piece_motion.h"

namespace batten::core {

/// A place on one half of a piece. Where a weight is far larger than its neighbors, all the way is made beside the ends
/// of the piece, nearer to them than shares between 0 and 1 can tell: the second half has its zero at its end.
struct HalfPlace {
    std::size_t half = 0;  ///< 2i and 2i + 1 are the halves of piece i
    double offset = 0.0;   ///< the share, from 0 to 1/2; or the share less 1, from -1/2 to 0

    bool is_second() const { return half % 2 == 1; }
    std::size_t piece() const { return half / 2; }
};

Motion motion_at(std::span<const PieceMotion> pieces, HalfPlace place);
Vector velocity_at(std::span<const PieceMotion> pieces, HalfPlace place);

/// The parameter there, as sharp as it can be as one number.
double parameter_at(std::span<const PieceMotion> pieces, HalfPlace place);

/// The place of a parameter of piece `piece`; where the halves meet, on the second one.
HalfPlace place_at(std::span<const PieceMotion> pieces, std::size_t piece, double u);

/// What lies between two parameters, as ranges of halves. Toward the ends of a piece they shrink in steps, as far as
/// its weights are apart, so that no rule overlooks where the curve makes its way.
std::vector<PieceRange> ranges_between(std::span<const PieceMotion> pieces, Interval wanted);

/// Adds those of one piece.
void add_ranges(std::vector<PieceRange>& ranges, std::span<const PieceMotion> pieces, std::size_t piece,
                Interval wanted);

}  // namespace batten::core
