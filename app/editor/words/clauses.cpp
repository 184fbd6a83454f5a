#include "app/editor/words/clauses.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <string_view>

namespace batten::editor {

namespace {

/// How many bytes of the text are kept where a clause ends at `i`; 0 where none does.
std::size_t kept_at(std::string_view text, std::size_t i) {
    const std::string_view rest = text.substr(i);
    if (rest == " ·" || rest.starts_with(" · ")) return i;
    // "to fair (changes the shape)"; a pair of coordinates is not beside the point.
    const bool is_aside =
        rest.size() > 2 && rest.starts_with(" (") && std::isalpha(static_cast<unsigned char>(rest[2])) != 0;
    if (is_aside) return i;
    const bool is_at_word_end = rest.size() == 1 || rest[1] == ' ';
    if (!is_at_word_end) return 0;
    if (rest[0] == '.') return i + 1;
    return rest[0] == ',' || rest[0] == ';' || rest[0] == ':' ? i : 0;
}

}  // namespace

std::vector<std::string> shorter_beginnings(const std::string& text) {
    std::vector<std::string> beginnings;
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '(' || text[i] == '{') ++depth;
        if (text[i] == ')' || text[i] == '}') --depth;
        const std::size_t kept = depth == 0 ? kept_at(text, i) : 0;
        if (kept > 0 && kept < text.size()) beginnings.push_back(fmt::format("{} …", text.substr(0, kept)));
    }
    std::ranges::reverse(beginnings);
    return beginnings;
}

}  // namespace batten::editor
