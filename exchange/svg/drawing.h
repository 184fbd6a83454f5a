/// What an SVG tree draws, as curves.
#pragma once

#include <pugixml.hpp>
#include <string_view>
#include <vector>

#include "core/document/document.h"
#include "exchange/notes.h"

namespace batten::exchange {

struct SvgDrawing {
    std::vector<core::DocumentCurve> curves;
    std::optional<core::DocumentUnits> units{};
    bool has_layers = false;  ///< of Inkscape, in one of which not all curves are; they are groups
    double largest_error = 0.0;
    std::size_t hidden_elements = 0;  ///< that are left out
    Notes notes{};                    ///< of what is left out (losses.h)
    Notes looks{};                    ///< of what curves do not have beyond a color, and of the page
};

/// Walks through `svg`, the outermost element, as read_svg() says. What is left out is added to `notes`.
SvgDrawing drawing_of(const pugi::xml_node& svg, Notes notes);

/// The name without the prefix of its namespace.
std::string_view local_name(const pugi::xml_node& element);

}  // namespace batten::exchange
