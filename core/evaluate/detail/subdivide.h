/// Cuts Bézier pieces and measures them; the common ground of tessellating and searching.
#pragma once

#include <utility>

#include "core/evaluate/bezier_pieces.h"

namespace batten::core {

/// The two parts of `piece` on both sides of `u`, strictly inside its interval. Cost O(p^2). Source: de Casteljau.
std::pair<BezierPiece, BezierPiece> cut_piece(const BezierPiece& piece, double u);

/// The middle of an interval; equal to one of its ends when no double lies between them.
double middle(Interval interval);

/// The box of the projected control points, which contains the piece.
Box control_box(const BezierPiece& piece);

}  // namespace batten::core
