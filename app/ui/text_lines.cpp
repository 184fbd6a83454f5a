#include "app/ui/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "app/editor/words/clauses.h"
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

void measure(TextLines& broken, ImFont* font) {
    for (const std::string& line : broken.lines) broken.width_px = std::max(broken.width_px, width_of(line, font));
}

/// As many words as find room.
TextLines filled_with_words(const std::string& text, ImFont* font, float width_px, std::size_t most) {
    TextLines broken;
    std::istringstream words(text);
    std::string word;
    while (broken.is_whole && words >> word) {
        const bool is_first = broken.lines.empty() || broken.lines.back().empty();
        const std::string longer = is_first ? word : fmt::format("{} {}", broken.lines.back(), word);
        if (broken.lines.empty())
            broken.lines.push_back(word);
        else if (is_first || width_of(longer, font) <= width_px)
            broken.lines.back() = longer;
        else if (broken.lines.size() < most)
            // The break itself tells apart what would stand on both sides of the dot.
            broken.lines.push_back(word == "·" ? "" : word);
        else
            broken.is_whole = false;
    }
    return broken;
}

}  // namespace

TextLines broken_into_lines(const std::string& text, ImFont* font, float width_px, std::size_t most) {
    TextLines broken = filled_with_words(text, font, width_px, most);
    if (!broken.is_whole) {
        for (const std::string& beginning :
             editor::shorter_beginnings(fmt::format("{}", fmt::join(broken.lines, " ")))) {
            TextLines shorter = filled_with_words(beginning, font, width_px, most);
            if (!shorter.is_whole) continue;
            measure(shorter, font);
            shorter.is_whole = false;
            return shorter;
        }
        broken.lines.back() = ended_early(broken.lines.back(), font, width_px);
    }
    measure(broken, font);
    return broken;
}

}  // namespace batten::ui
