#include "app/editor/scene/text_size.h"

#include <array>

#include "core/base/utf8.h"

namespace batten::editor {

namespace {

constexpr double script_share = 0.7;
constexpr double line_height = 1.25;

/// The width of the first character of `text` in a proportional font, as a share of the size.
double advance(std::string_view text) {
    const char c = text.front();
    if (text.starts_with("·")) return 0.29;
    constexpr std::array digits{0.63, 0.40, 0.59, 0.62, 0.65, 0.60, 0.62, 0.56, 0.62, 0.62};
    if (c >= '0' && c <= '9') return digits[static_cast<std::size_t>(c - '0')];
    constexpr std::string_view narrow = "iljtfrI.,:;|!'()[] ";
    constexpr std::string_view wide = "mwMW=+";
    if (narrow.find(c) != std::string_view::npos) return 0.29;
    if (wide.find(c) != std::string_view::npos) return 0.83;
    if (c >= 'A' && c <= 'Z') return 0.67;
    if (c >= 'a' && c <= 'z') return 0.57;
    return 0.61;
}

}  // namespace

glm::dvec2 text_size(std::string_view text, double size, render::LabelFont font) {
    double width = 0.0;
    double share = 1.0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const bool opens = (c == '_' || c == '^') && i + 1 < text.size() && text[i + 1] == '{';
        if (opens) {
            share = script_share;
            ++i;
        } else if (c == '}') {
            share = 1.0;
        } else if (!core::continues_utf8(c)) {
            width += share * (font == render::LabelFont::number ? 0.61 : advance(text.substr(i)));
        }
    }
    if (font == render::LabelFont::bold) width *= 1.06;
    return {width * size, line_height * size};
}

}  // namespace batten::editor
