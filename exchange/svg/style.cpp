#include "exchange/svg/style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/base/ascii.h"
#include "exchange/svg/color_names.h"
#include "exchange/svg/scanner.h"

namespace batten::exchange {

namespace {

using core::DocumentColor;

// "rgb(76, 127, 224)", also with % and an opacity, which is not read.
std::optional<DocumentColor> color_of_function(std::string_view text) {
    const std::size_t open = text.find('(');
    if (open == std::string_view::npos || !text.starts_with("rgb")) return std::nullopt;
    Scanner scanner(text.substr(open + 1));
    std::array<std::uint8_t, 3> channels{};
    scanner.skip_blanks();
    for (std::uint8_t& channel : channels) {
        const auto number = scanner.number();
        if (!number) return std::nullopt;
        const double value = scanner.skip_if('%') ? *number * 255.0 / 100.0 : *number;
        channel = static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
        scanner.skip_separator();
    }
    return DocumentColor{channels[0], channels[1], channels[2]};
}

std::optional<DocumentColor> color_of_name(const std::string& name) {
    const auto* const found =
        std::lower_bound(color_names.begin(), color_names.end(), name,
                         [](const NamedColor& color, const std::string& wanted) { return color.name < wanted; });
    if (found == color_names.end() || found->name != name) return std::nullopt;
    return core::color_of_text(found->color);
}

// Changes `color` where `text` speaks of it.
void take_color(std::string_view text, std::optional<DocumentColor>& color) {
    if (!text.empty() && text != "inherit") color = read_color(text);
}

}  // namespace

std::optional<DocumentColor> read_color(std::string_view text) {
    constexpr std::size_t short_length = 4;
    const std::string color = core::in_small_letters(core::trimmed(text, svg_blanks));
    if (color.size() == short_length && color[0] == '#') {
        const std::string doubled{'#', color[1], color[1], color[2], color[2], color[3], color[3]};
        return core::color_of_text(doubled);
    }
    if (color.starts_with('#')) return core::color_of_text(color);
    if (const auto found = color_of_function(color)) return found;
    return color_of_name(color);
}

SvgProperties::SvgProperties(const pugi::xml_node& element, const StyleSheet& sheet) {
    constexpr std::uint16_t of_style_attribute = 1000;  // which beats every selector
    const auto take_value = [&](SvgProperty property, const CssValue& value) {
        take(value, of_style_[static_cast<std::size_t>(property)]);
    };
    sheet.read(element, take_value);
    read_declarations(element.attribute("style").value(), [&](SvgProperty property, CssValue value) {
        value.specificity = of_style_attribute;
        take_value(property, value);
    });
    for (const pugi::xml_attribute& attribute : element.attributes())
        if (const auto property = svg_property(attribute.name()))
            of_attributes_[static_cast<std::size_t>(*property)] = core::trimmed(attribute.value(), svg_blanks);
}

bool SvgProperties::has_styled_size() const {
    for (std::size_t i = static_cast<std::size_t>(SvgProperty::x); i <= static_cast<std::size_t>(SvgProperty::d); ++i) {
        const std::string_view styled = of_style_[i].text;
        if (!styled.empty() && styled != "auto" && styled != of_attributes_[i]) return true;
    }
    return false;
}

SvgStyle SvgStyle::within(const SvgProperties& properties) const {
    SvgStyle style = *this;
    take_color(properties[SvgProperty::stroke], style.stroke);
    take_color(properties[SvgProperty::fill], style.fill);
    const std::string_view visibility = properties[SvgProperty::visibility];
    if (visibility == "hidden" || visibility == "collapse") style.visible = false;
    if (visibility == "visible") style.visible = true;
    return style;
}

}  // namespace batten::exchange
