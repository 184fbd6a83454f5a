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

std::string_view stripped(std::string_view text) {
    return core::trimmed(text, svg_blanks);
}

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

// In the order of SvgProperty.
constexpr std::array<std::string_view, svg_property_count> property_names{
    "stroke",           "fill",          "visibility", "display", "clip-path", "mask", "transform",
    "transform-origin", "transform-box", "translate",  "rotate",  "scale"};

std::optional<std::size_t> index_of_property(std::string_view name) {
    const auto* const found = std::find(property_names.begin(), property_names.end(), name);
    if (found == property_names.end()) return std::nullopt;
    return static_cast<std::size_t>(found - property_names.begin());
}

// Changes `color` where `text` speaks of it.
void take_color(std::string_view text, std::optional<DocumentColor>& color) {
    if (!text.empty() && text != "inherit") color = read_color(text);
}

}  // namespace

std::optional<DocumentColor> read_color(std::string_view text) {
    constexpr std::size_t short_length = 4;
    const std::string color = core::in_small_letters(stripped(text));
    if (color.size() == short_length && color[0] == '#') {
        const std::string doubled{'#', color[1], color[1], color[2], color[2], color[3], color[3]};
        return core::color_of_text(doubled);
    }
    if (color.starts_with('#')) return core::color_of_text(color);
    if (const auto found = color_of_function(color)) return found;
    return color_of_name(color);
}

SvgProperties::SvgProperties(const pugi::xml_node& element) {
    read_style(element.attribute("style").value());
    for (const pugi::xml_attribute& attribute : element.attributes())
        if (const auto index = index_of_property(attribute.name()))
            of_attributes_[*index] = stripped(attribute.value());
}

void SvgProperties::read_style(std::string_view text) {
    constexpr std::string_view important = "!important";
    std::array<bool, svg_property_count> is_important{};
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(';'), text.size());
        const std::string_view declaration = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::size_t colon = declaration.find(':');
        if (colon == std::string_view::npos) continue;
        const auto index = index_of_property(stripped(declaration.substr(0, colon)));
        if (!index) continue;
        std::string_view value = stripped(declaration.substr(colon + 1));
        const bool beats_others = value.ends_with(important);
        if (beats_others) value = stripped(value.substr(0, value.size() - important.size()));
        if (is_important[*index] && !beats_others) continue;
        is_important[*index] = beats_others;
        of_style_[*index] = value;
    }
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
