/// Letters, digits and blanks of ASCII, whatever the locale: names of files, keywords and headings are compared by
/// them.
#pragma once

#include <string>
#include <string_view>

namespace batten::core {

constexpr bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

constexpr bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// 'a' for 'A'; every other byte as it is, also those of letters beyond ASCII.
constexpr char small_letter(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// `text` with small letters in place of capital ones.
inline std::string in_small_letters(std::string_view text) {
    std::string small(text);
    for (char& c : small) c = small_letter(c);
    return small;
}

inline constexpr std::string_view ascii_blanks = " \t\r\n";

/// `text` without the characters of `around` at both ends.
constexpr std::string_view trimmed(std::string_view text, std::string_view around = ascii_blanks) {
    const std::size_t first = text.find_first_not_of(around);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(around) - first + 1);
}

}  // namespace batten::core
