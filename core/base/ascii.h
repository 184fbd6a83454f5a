/// Letters and blanks of ASCII, whatever the locale: names of files, keywords and headings are compared by them.
#pragma once

#include <string>
#include <string_view>

namespace batten::core {

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

/// `text` without the blanks, tabs and line ends around it.
constexpr std::string_view without_blanks(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    const std::size_t first = text.find_first_not_of(blanks);
    return first == text.npos ? std::string_view() : text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

}  // namespace batten::core
