#include "app/ui/text_lines.h"

#include <fmt/core.h>

#include <algorithm>
#include <sstream>

#include "app/ui/imgui_compat.h"
#include "app/ui/rich_text.h"

namespace batten::ui {

namespace {

float width_of(const std::string& line, ImFont* font) {
    return rich_text_size(line, font, font_height(font)).width_px;
}

/// With "…" at its end, and without the last words where it would be wider than `width_px`.
std::string ended_early(std::string line, ImFont* font, float width_px) {
    for (;;) {
        std::string shown = fmt::format("{} …", line);
        const std::size_t space = line.rfind(' ');
        if (space == std::string::npos || width_of(shown, font) <= width_px) return shown;
        line.resize(space);
    }
}

}  // namespace

TextLines broken_into_lines(const std::string& text, ImFont* font, float width_px, std::size_t most) {
    TextLines broken;
    std::istringstream words(text);
    std::string word;
    while (broken.is_whole && words >> word) {
        const std::string longer = broken.lines.empty() ? word : fmt::format("{} {}", broken.lines.back(), word);
        if (broken.lines.empty())
            broken.lines.push_back(word);
        else if (width_of(longer, font) <= width_px)
            broken.lines.back() = longer;
        else if (broken.lines.size() < most)
            broken.lines.push_back(word);
        else
            broken.is_whole = false;
    }
    if (!broken.is_whole) broken.lines.back() = ended_early(broken.lines.back(), font, width_px);
    for (const std::string& line : broken.lines) broken.width_px = std::max(broken.width_px, width_of(line, font));
    return broken;
}

}  // namespace batten::ui
