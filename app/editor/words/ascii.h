/// Letters, digits and blanks in what people type, whatever the system's language.
#pragma once

#include <string_view>

namespace batten::editor {

inline constexpr std::string_view ascii_blanks = " \t\r\n";

constexpr bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

constexpr bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// `text` without the characters of `around` at both ends.
constexpr std::string_view trimmed(std::string_view text, std::string_view around = ascii_blanks) {
    const std::size_t first = text.find_first_not_of(around);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(around) - first + 1);
}

}  // namespace batten::editor
