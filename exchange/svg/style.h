/// Properties of SVG elements: colors, visibility, what attributes and styles say.
#pragma once

#include <array>
#include <optional>
#include <pugixml.hpp>
#include <string_view>

#include "core/document/document.h"
#include "exchange/svg/style_sheet.h"

namespace batten::exchange {

/// "#4c7", "#4c7fe0", "rgb(76, 127, 224)", "rgb(30%, 50%, 88%)" or a name; none for what is no color of its own: none,
/// currentColor, gradients.
std::optional<core::DocumentColor> read_color(std::string_view text);

/// What is said of an element itself. Cost O(length of its attributes), once.
class SvgProperties {
  public:
    SvgProperties(const pugi::xml_node& element, const StyleSheet& sheet);

    /// What the style attribute and the style sheets say: of several values the one that CSS prefers.
    std::string_view in_style(SvgProperty property) const { return of_style_[static_cast<std::size_t>(property)].text; }

    /// What the attribute of that name says.
    std::string_view in_attribute(SvgProperty property) const {
        return of_attributes_[static_cast<std::size_t>(property)];
    }

    /// What holds: the style, else the attribute; empty where there is neither.
    std::string_view operator[](SvgProperty property) const {
        return in_style(property).empty() ? in_attribute(property) : in_style(property);
    }

    /// Whether there is such a value other than none.
    bool has(SvgProperty property) const { return !(*this)[property].empty() && (*this)[property] != "none"; }

    /// Whether the style gives a shape or a viewport another size or place than its attributes.
    bool has_styled_size() const;

  private:
    SvgValues of_style_{};
    std::array<std::string_view, svg_property_count> of_attributes_{};
};

/// What an element hands on to those in it.
struct SvgStyle {
    std::optional<core::DocumentColor> stroke{};
    std::optional<core::DocumentColor> fill{};
    bool visible = true;

    /// With what an element says itself.
    SvgStyle within(const SvgProperties& properties) const;

    /// That of the stroke, else of the fill.
    std::optional<core::DocumentColor> color() const { return stroke ? stroke : fill; }
};

}  // namespace batten::exchange
