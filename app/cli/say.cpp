#include "app/cli/say.h"

#include <algorithm>
#include <ostream>
#include <string_view>

#include "core/base/utf8.h"

namespace batten::cli {

namespace {

/// Of C0 and C1, and the end of a line that other programs see in U+2028.
bool is_control(char32_t character) {
    return character < U' ' || (character >= 0x7f && character < 0xa0) || character == 0x2028 || character == 0x2029;
}

constexpr std::size_t longest_word = 500;  // in bytes; names of files in deep folders are shorter
constexpr std::size_t most_kept = 40;      // of each end of a longer one

/// `text` without the middle of words that would fill the screen.
std::string without_long_words(std::string_view text) {
    std::string shown;
    while (!text.empty()) {
        const std::string_view word = text.substr(0, std::min(text.find(' '), text.size() - 1) + 1);
        text.remove_prefix(word.size());
        if (word.size() <= longest_word)
            shown += word;
        else
            shown.append(word.substr(0, most_kept)).append("...").append(word.substr(word.size() - most_kept));
    }
    return shown;
}

}  // namespace

std::string printable(const std::string& text) {
    std::string shown;
    for (std::string_view left = text; !left.empty();) {
        const auto code = core::utf8_code(left);
        const std::size_t length = code ? core::utf8_length(left) : 1;
        shown += code && !is_control(*code) ? left.substr(0, length) : "?";
        left.remove_prefix(length);
    }
    return shown;
}

void say(Output output, const std::string& sentence) {
    output.errors << printable(without_long_words(sentence)) << '\n';
}

ExitStatus say_wrong_usage(Output output, const std::string& sentence) {
    say(output, sentence);
    return ExitStatus::wrong_usage;
}

}  // namespace batten::cli
