/// The document itself inside an SVG that draws it.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "exchange/svg/drawing.h"

namespace batten::exchange {

/// Puts `document` into `svg`, complete with all that it draws. It is to be the last step: the copy is valid only as
/// long as the file draws the same curves on the same page.
void embed_document(pugi::xml_node svg, const core::Document& document);

/// What a file has of ours.
struct NativeCopy {
    std::optional<core::Document> document{};  ///< none where there is none that still holds
    std::vector<std::string> told{};           ///< what another program has changed
    std::vector<std::string> looks{};          ///< what is lost of the look that another program has given it
};

/// The document in `svg`, which draws `drawing`. Names, colors, layers, locks and what is hidden are those of the
/// drawing where these alone have changed; where a curve or the page has there is none.
NativeCopy native_copy(const pugi::xml_node& svg, const SvgDrawing& drawing);

}  // namespace batten::exchange
