#include "exchange/utf8_text.h"

#include <algorithm>

#include "core/base/utf8.h"

namespace batten::exchange {

namespace {

constexpr std::size_t longest_name = 255;

// The length of the whole characters at the front, up to the longest name; none where a byte begins no character.
std::size_t whole_characters(std::string_view text) {
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t length = core::utf8_length(text.substr(at));
        if (length == 0) return std::string_view::npos;
        if (at + length > longest_name) break;
        at += length;
    }
    return at;
}

}  // namespace

void append_utf8(std::string& text, unsigned long character) {
    const bool is_half_of_pair = character >= 0xd800UL && character <= 0xdfffUL;
    const unsigned long c = is_half_of_pair || character > 0x10ffffUL ? 0xfffdUL : character;
    const auto add = [&](unsigned long byte) { text.push_back(static_cast<char>(byte)); };
    const auto add_rest = [&](unsigned shift) { add(0x80UL | ((c >> shift) & 0x3fUL)); };
    if (c < 0x80UL) return add(c);
    if (c < 0x800UL) {
        add(0xc0UL | (c >> 6U));
    } else if (c < 0x10000UL) {
        add(0xe0UL | (c >> 12U));
        add_rest(6);
    } else {
        add(0xf0UL | (c >> 18U));
        add_rest(12);
        add_rest(6);
    }
    add_rest(0);
}

std::string utf8_text(std::string_view bytes) {
    bytes = bytes.substr(0, 2 * longest_name);
    const std::size_t kept = whole_characters(bytes);
    std::string text;
    if (kept != std::string_view::npos)
        text = bytes.substr(0, kept);
    else
        for (const char c : bytes.substr(0, longest_name / 2)) append_utf8(text, static_cast<unsigned char>(c));
    std::ranges::replace_if(
        text, [](char c) { return (c >= '\0' && c < ' ') || c == '\x7f'; }, ' ');
    return text;
}

}  // namespace batten::exchange
