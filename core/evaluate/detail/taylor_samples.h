/// Many points of one piece at once, by the widest vector instructions that the processor has.
#pragma once

#include <span>

#include "core/evaluate/detail/taylor_pieces.h"

namespace batten::core {

/// The points at `parameters`, which lie in the piece, a sharp one. The same point for the same parameter, wherever it
/// stands.
void sample_piece(const TaylorPiece& piece, std::span<const double> parameters, Point* points);

}  // namespace batten::core
