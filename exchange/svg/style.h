/// Colors and visibility of SVG elements.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string_view>

#include "core/document/document.h"

namespace batten::exchange {

/// "#4c7", "#4c7fe0", "rgb(76, 127, 224)", "rgb(30%, 50%, 88%)" or a name; none for what is no color of its own: none,
/// currentColor, gradients.
std::optional<core::DocumentColor> read_color(std::string_view text);

/// The value of a property: of the style attribute, else of the attribute of that name; empty where there is neither.
std::string_view property_of(const pugi::xml_node& element, std::string_view name);

/// What an element hands on to those in it.
struct SvgStyle {
    std::optional<core::DocumentColor> stroke{};
    std::optional<core::DocumentColor> fill{};
    bool visible = true;

    /// With what `element` says itself.
    SvgStyle within(const pugi::xml_node& element) const;

    /// That of the stroke, else of the fill.
    std::optional<core::DocumentColor> color() const { return stroke ? stroke : fill; }
};

/// Whether the element and all in it are not drawn (display: none).
bool is_not_displayed(const pugi::xml_node& element);

}  // namespace batten::exchange
