/// Many points of one piece at once, by the widest vector instructions that the processor has.
#pragma once

#include <span>

#include "core/evaluate/detail/taylor_pieces.h"

namespace batten::core {

/// Where points of a piece are wanted: at the first parameters, as many as lie in the half-open interval.
struct Samples {
    Interval interval;
    std::span<const double> parameters;
    std::span<Point> points;  ///< as many
};

/// Gives the points on a sharp piece, and says how many they are. May write some of the points behind them, too. The
/// same point for the same parameter, wherever it stands.
std::size_t sample_piece(const TaylorPiece& piece, const Samples& samples);

}  // namespace batten::core
