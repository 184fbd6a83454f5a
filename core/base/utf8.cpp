#include "core/base/utf8.h"

namespace batten::core {

namespace {

unsigned byte_at(std::string_view text, std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
}

bool is_continuation(unsigned byte) {
    return continues_utf8(static_cast<char>(byte));
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
    if (text.empty()) return 0;
    const unsigned first = byte_at(text, 0);
    const unsigned second = byte_at(text, 1);
    if (first < 0x80U) return 1;
    if (first < 0xc2U || first > 0xf4U || !is_continuation(second)) return 0;
    if (first < 0xe0U) return 2;
    if (!is_continuation(byte_at(text, 2))) return 0;
    if (first < 0xf0U) return (first == 0xe0U && second < 0xa0U) || (first == 0xedU && second > 0x9fU) ? 0 : 3;
    if (!is_continuation(byte_at(text, 3))) return 0;
    return (first == 0xf0U && second < 0x90U) || (first == 0xf4U && second > 0x8fU) ? 0 : 4;
}

std::optional<char32_t> utf8_code(std::string_view text) {
    const std::size_t length = utf8_length(text);
    if (length == 0) return std::nullopt;
    const unsigned first = byte_at(text, 0);
    if (length == 1) return first;
    constexpr unsigned bits_of_first = 0x7fU;
    char32_t code = first & (bits_of_first >> length);
    for (std::size_t i = 1; i < length; ++i) code = (code << 6U) | (byte_at(text, i) & 0x3fU);
    return code;
}

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        if (length == 0) return false;
        text.remove_prefix(length);
    }
    return true;
}

std::string_view utf8_front(std::string_view text, std::size_t most_bytes) {
    if (text.size() <= most_bytes) return text;
    while (most_bytes > 0 && continues_utf8(text[most_bytes])) --most_bytes;
    return text.substr(0, most_bytes);
}

}  // namespace batten::core
