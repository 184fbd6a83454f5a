/// The Bézier points of the pieces, by number and blossom, and which of them are control points already.
#pragma once

#include <string>

#include "app/editor/derived/derived.h"
#include "core/evaluate/bezier_pieces.h"

namespace batten::editor {

/// The Bézier points of one piece and what they are called.
struct NamedPiece {
    core::BezierPiece piece;
    std::vector<std::size_t> numbers;  ///< of its points; the first piece begins with b_0, and pieces share their ends
    bool is_complete = false;          ///< both ends have multiplicity p, so that its points are control points
};

/// The piece over span `span` of a curve whose knots say `facts`; those of a torn curve share no ends. Cost O(p^3).
NamedPiece named_piece(const core::Curve& curve, const KnotFacts& facts, std::size_t span);

/// "b_{4}".
std::string bezier_name(std::size_t number);

}  // namespace batten::editor
