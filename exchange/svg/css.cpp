#include "exchange/svg/css.h"

#include <algorithm>
#include <tuple>

#include "core/base/ascii.h"
#include "exchange/svg/scanner.h"

namespace batten::exchange {

namespace {

// In the order of SvgProperty.
constexpr std::array<std::string_view, svg_property_count> property_names{"stroke",
                                                                          "fill",
                                                                          "visibility",
                                                                          "display",
                                                                          "clip-path",
                                                                          "mask",
                                                                          "transform",
                                                                          "transform-origin",
                                                                          "transform-box",
                                                                          "translate",
                                                                          "rotate",
                                                                          "scale",
                                                                          "x",
                                                                          "y",
                                                                          "width",
                                                                          "height",
                                                                          "cx",
                                                                          "cy",
                                                                          "r",
                                                                          "rx",
                                                                          "ry",
                                                                          "d",
                                                                          "stroke-width",
                                                                          "stroke-dasharray",
                                                                          "marker",
                                                                          "marker-start",
                                                                          "marker-mid",
                                                                          "marker-end",
                                                                          "opacity",
                                                                          "fill-opacity",
                                                                          "stroke-opacity",
                                                                          "filter",
                                                                          "overflow",
                                                                          "font-size",
                                                                          "font"};

// The value of a declaration and whether it says that it is important.
CssValue value_in(std::string_view text) {
    constexpr std::string_view important = "important";
    CssValue value{.text = core::trimmed(text, svg_blanks)};
    if (!value.text.ends_with(important)) return value;
    const std::string_view before =
        core::trimmed(value.text.substr(0, value.text.size() - important.size()), svg_blanks);
    if (!before.ends_with('!')) return value;
    value.is_important = true;
    value.text = core::trimmed(before.substr(0, before.size() - 1), svg_blanks);
    return value;
}

// Whether CSS drops it: sizes of fonts need a unit, but for 0.
bool is_invalid(SvgProperty property, std::string_view value) {
    if (property != SvgProperty::font_size) return false;
    Scanner scanner(value);
    const auto number = scanner.number();
    return number && *number != 0.0 && scanner.is_at_end();
}

}  // namespace

std::optional<SvgProperty> svg_property(std::string_view name) {
    const auto* const found = std::find(property_names.begin(), property_names.end(), name);
    if (found == property_names.end()) return std::nullopt;
    return static_cast<SvgProperty>(found - property_names.begin());
}

bool CssValue::beats(const CssValue& other) const {
    const auto rank = [](const CssValue& value) {
        return std::tuple(value.is_important, value.specificity, value.order);
    };
    return other.text.empty() || rank(*this) >= rank(other);
}

void take(const CssValue& value, CssValue& place) {
    if (!value.text.empty() && value.beats(place)) place = value;
}

void read_declarations(std::string_view text, const CssDeclaration& declaration) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(';'), text.size());
        const std::string_view next = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::size_t colon = next.find(':');
        if (colon == std::string_view::npos) continue;
        const auto property = svg_property(core::trimmed(next.substr(0, colon), svg_blanks));
        if (!property) continue;
        const CssValue value = value_in(next.substr(colon + 1));
        if (!is_invalid(*property, value.text)) declaration(*property, value);
    }
}

}  // namespace batten::exchange
