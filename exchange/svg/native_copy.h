/// The document itself inside an SVG that draws it.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <span>

#include "core/document/document.h"

namespace batten::exchange {

/// Puts `document` into `svg`, complete with all that it draws. It is to be the last step: the copy is valid only as
/// long as the file draws the same curves, by the same names and in the same colors.
void embed_document(pugi::xml_node svg, const core::Document& document);

/// What a file has of ours.
struct NativeCopy {
    bool is_there = false;
    std::optional<core::Document>
        document{};  ///< none where the file draws something else than `drawn`, or it is broken
};

/// The document in `svg`, which draws the curves `drawn`.
NativeCopy native_copy(const pugi::xml_node& svg, std::span<const core::DocumentCurve> drawn);

}  // namespace batten::exchange
