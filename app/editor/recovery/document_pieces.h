/// A document as pieces of bytes, by which it is compared with another and written down.
#pragma once

#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "app/editor/fields/field.h"
#include "core/document/document.h"

namespace batten::editor {

/// Bytes, and what keeps them in memory.
struct Piece {
    std::shared_ptr<const void> owner{};
    std::string_view bytes{};

    bool operator==(const Piece& other) const {
        return bytes.size() == other.bytes.size() && (bytes.data() == other.bytes.data() || bytes == other.bytes);
    }
};

/// A curve: all but its arrays, knots, control points, weights. Pieces that curves share are the same bytes in memory.
using CurvePieces = std::array<Piece, 4>;

/// First all but the curves, as the first piece of four; then each curve. Not the fit points that its file lost.
using DocumentPieces = std::vector<CurvePieces>;

DocumentPieces pieces_of(const core::Document& document);

/// The document that gave these pieces, equal in every bit. The refusal of others says that they are damaged.
[[nodiscard]] Outcome<core::Document> document_of(const DocumentPieces& pieces);

/// A piece of its own for `bytes`.
Piece piece_of(std::string bytes);

}  // namespace batten::editor
