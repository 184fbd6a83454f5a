/// What an SVG tree draws, as curves.
#pragma once

#include <pugixml.hpp>
#include <string>
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
    Notes left_out{};                 ///< what is (losses.h)
    Notes changed{};                  ///< what is read, but perhaps not as it is drawn
    Notes looks{};                    ///< of what curves do not have beyond a color, and of the page

    /// The sentences of what is left out, and behind them those of what is changed.
    std::vector<std::string> told() const;
};

/// Walks through `svg`, the outermost element, as read_svg() says. What is left out is added to `left_out`.
SvgDrawing drawing_of(const pugi::xml_node& svg, Notes left_out);

/// The name without the prefix of its namespace.
std::string_view local_name(const pugi::xml_node& element);

}  // namespace batten::exchange
