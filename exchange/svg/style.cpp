#include "exchange/svg/style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "exchange/svg/color_names.h"
#include "exchange/svg/scanner.h"

namespace batten::exchange {

namespace {

using core::DocumentColor;

std::string_view stripped(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n\f";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string in_lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return lower;
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

// Changes `color` where the element speaks of it.
void take_color(const pugi::xml_node& element, std::string_view property, std::optional<DocumentColor>& color) {
    const std::string_view text = property_of(element, property);
    if (!text.empty() && text != "inherit") color = read_color(text);
}

}  // namespace

std::optional<DocumentColor> read_color(std::string_view text) {
    constexpr std::size_t short_length = 4;
    const std::string color = in_lower_case(stripped(text));
    if (color.size() == short_length && color[0] == '#') {
        const std::string doubled{'#', color[1], color[1], color[2], color[2], color[3], color[3]};
        return core::color_of_text(doubled);
    }
    if (color.starts_with('#')) return core::color_of_text(color);
    if (const auto found = color_of_function(color)) return found;
    return color_of_name(color);
}

std::string_view property_of(const pugi::xml_node& element, std::string_view name) {
    std::string_view rest = element.attribute("style").value();
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(';'), rest.size());
        const std::string_view declaration = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        const std::size_t colon = declaration.find(':');
        if (colon != std::string_view::npos && stripped(declaration.substr(0, colon)) == name)
            return stripped(declaration.substr(colon + 1));
    }
    return stripped(element.attribute(std::string(name).c_str()).value());
}

SvgStyle SvgStyle::within(const pugi::xml_node& element) const {
    SvgStyle style = *this;
    take_color(element, "stroke", style.stroke);
    take_color(element, "fill", style.fill);
    const std::string_view visibility = property_of(element, "visibility");
    if (visibility == "hidden" || visibility == "collapse") style.visible = false;
    if (visibility == "visible") style.visible = true;
    return style;
}

bool is_not_displayed(const pugi::xml_node& element) {
    return property_of(element, "display") == "none";
}

}  // namespace batten::exchange
