#include "app/cli/say.h"

#include <ostream>
#include <string_view>

#include "core/base/utf8.h"

namespace batten::cli {

namespace {

/// Of C0 and C1, and the end of a line that other programs see in U+2028.
bool is_control(char32_t character) {
    return character < U' ' || (character >= 0x7f && character < 0xa0) || character == 0x2028 || character == 0x2029;
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
    output.errors << printable(sentence) << '\n';
}

}  // namespace batten::cli
