#include "render/prose.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include "render/formula_label.h"

namespace batten::render {

namespace {

bool is_blank_at(std::string_view text, std::size_t place) {
    return place >= text.size() || text[place] == ' ';
}

bool is_digit_at(std::string_view text, std::size_t place) {
    return place < text.size() && '0' <= text[place] && text[place] <= '9';
}

bool can_be_formula(std::string_view text) {
    int open = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\\') {
            ++i;  // and what it stands before
            if (i == text.size()) return false;
            continue;
        }
        open += text[i] == '{' ? 1 : text[i] == '}' ? -1 : 0;
        if (open < 0) return false;
    }
    return open == 0 && !text.empty() && text.find_first_of("%#&~") == std::string_view::npos &&
           formula_label(text).is_whole;
}

bool is_escaped(std::string_view text, std::size_t dollar) {
    return dollar > 0 && text[dollar - 1] == '\\';
}

/// Where the formula that begins behind the dollar sign at `start` ends: at the place of the other one.
std::optional<std::size_t> end_of_formula(std::string_view text, std::size_t start) {
    if (is_escaped(text, start) || is_blank_at(text, start + 1)) return std::nullopt;
    const std::size_t end = text.find('$', start + 1);
    if (end == std::string_view::npos || is_blank_at(text, end - 1) || is_digit_at(text, end + 1)) return std::nullopt;
    return can_be_formula(text.substr(start + 1, end - start - 1)) ? std::optional(end) : std::nullopt;
}

}  // namespace

std::vector<ProsePart> prose_parts(std::string_view prose) {
    std::vector<ProsePart> parts;
    std::size_t words = 0;  // where those begin that are in no part yet
    std::size_t dollar = prose.find('$');
    while (dollar != std::string_view::npos) {
        const auto end = end_of_formula(prose, dollar);
        const std::size_t end_of_words = is_escaped(prose, dollar) ? dollar - 1 : dollar;
        if ((end || end_of_words < dollar) && end_of_words > words)
            parts.push_back({prose.substr(words, end_of_words - words)});
        if (end_of_words < dollar) words = dollar;
        if (end) {
            parts.push_back({prose.substr(dollar + 1, *end - dollar - 1), true});
            words = *end + 1;
        }
        dollar = prose.find('$', end ? words : dollar + 1);
    }
    if (words < prose.size()) parts.push_back({prose.substr(words)});
    return parts;
}

std::string prose_label(std::string_view prose) {
    std::string label;
    for (const ProsePart& part : prose_parts(prose))
        label += part.is_formula ? formula_label(part.text).text : std::string(part.text);
    return label;
}

std::vector<std::string> unset_commands(std::string_view prose) {
    std::vector<std::string> commands;
    for (const ProsePart& part : prose_parts(prose))
        if (part.is_formula) std::ranges::move(formula_label(part.text).unknown, std::back_inserter(commands));
    return commands;
}

DrawList set_list(const FigurePart& part) {
    DrawList list = part.list;
    if (part.is_prose)
        for (DrawCommand& command : list.commands)
            if (auto* label = std::get_if<Label>(&command)) label->text = prose_label(label->text);
    return list;
}

}  // namespace batten::render
