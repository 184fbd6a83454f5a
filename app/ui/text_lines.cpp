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

/// A dot between two hints begins no line: it takes the last word of the line before along, if that has more.
std::string with_word_before(std::string& line, const std::string& dot) {
    const std::size_t space = line.rfind(' ');
    if (space == std::string::npos) return dot;
    std::string begun = fmt::format("{} {}", line.substr(space + 1), dot);
    line.resize(space);
    return begun;
}

/// As many words as find room.
TextLines filled_with_words(const std::string& text, ImFont* font, float width_px, std::size_t most) {
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
            broken.lines.push_back(word == "·" ? with_word_before(broken.lines.back(), word) : word);
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
