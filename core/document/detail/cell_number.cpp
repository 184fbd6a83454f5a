#include "core/document/detail/cell_number.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>

#include "core/base/ascii.h"
#include "core/base/number_text.h"

namespace batten::core {

namespace {

constexpr std::size_t group_length = 3;  // of the digits between thousands separators

std::string_view without_sign(std::string_view cell) {
    if (cell.starts_with('-') || cell.starts_with('+')) cell.remove_prefix(1);
    return cell;
}

// Whether the text has digits at both ends, and nothing but them and `marks` between.
bool is_of_digits(std::string_view text, std::string_view marks) {
    return !text.empty() && is_digit(text.front()) && is_digit(text.back()) &&
           std::ranges::all_of(text, [&](char c) { return is_digit(c) || marks.find(c) != std::string_view::npos; });
}

// How many groups of three digits stand behind one to three of them, each behind `mark`; 0 where anything else does.
std::size_t count_groups(std::string_view text, char mark) {
    std::size_t count = 0;
    for (; text.size() > group_length; text.remove_suffix(group_length + 1)) {
        const std::string_view group = text.substr(text.size() - group_length);
        if (!is_of_digits(group, "") || text[text.size() - group_length - 1] != mark) return 0;
        ++count;
    }
    return is_of_digits(text, "") ? count : 0;
}

// Whether three digits end the text behind a `mark`. In India the groups in front of them have two.
bool ends_with_group(std::string_view text, char mark) {
    const std::size_t last = text.rfind(mark);
    return last + 1 + group_length == text.size() && is_of_digits(text, {&mark, 1}) &&
           is_of_digits(text.substr(last + 1), "");
}

}  // namespace

std::optional<double> number_in(std::string_view cell, bool has_decimal_commas) {
    std::string with_point;
    if (has_decimal_commas) {
        if (cell.find('.') != std::string_view::npos) return std::nullopt;
        with_point = cell;
        std::replace(with_point.begin(), with_point.end(), ',', '.');
        cell = with_point;
    }
    const auto number = leading_number(cell);
    if (!number || number->length != cell.size()) return std::nullopt;
    return number->value;
}

bool begins_error_sign(std::string_view line, std::size_t place) {
    constexpr std::array<std::string_view, 7> of_spreadsheets{"n/a",   "ref!", "div/0!", "value!",
                                                              "name?", "num!", "null!"};
    constexpr std::array<std::string_view, 4> of_printf{"inf", "ind", "qnan", "snan"};
    const bool is_behind_point = place > 0 && line[place - 1] == '.';
    const auto words = is_behind_point ? std::span<const std::string_view>(of_printf) : of_spreadsheets;
    line.remove_prefix(place + 1);
    return std::ranges::any_of(words, [&](std::string_view word) {
        return in_small_letters(line.substr(0, word.size())) == word &&
               (line.size() == word.size() || !is_letter(line[word.size()]));
    });
}

bool means_no_number(std::string_view cell) {
    if (const std::size_t place = cell.find('#'); place != std::string_view::npos)
        return begins_error_sign(cell, place);
    constexpr std::array<std::string_view, 6> words{"nan", "inf", "infinity", "n/a", "na", "null"};
    cell = without_sign(cell);
    return std::ranges::find(words, in_small_letters(cell.substr(0, cell.find('(')))) != words.end();
}

bool has_thousands(std::string_view cell) {
    constexpr std::string_view decimal_marks = ".,";
    cell = without_sign(cell);
    if (!is_of_digits(cell, "., '")) return false;
    const std::size_t first = cell.find_first_not_of("0123456789");
    if (first == std::string_view::npos) return false;
    const std::size_t last = cell.find_last_of(decimal_marks);
    const char mark = cell[first];
    if (last != std::string_view::npos && cell[last] != mark) return ends_with_group(cell.substr(0, last), mark);
    const bool may_be_decimal = decimal_marks.find(mark) != std::string_view::npos;
    return count_groups(cell, mark) >= (may_be_decimal ? 2U : 1U);
}

bool may_have_thousands(std::string_view cell) {
    cell = without_sign(cell);
    return !cell.starts_with('0') && count_groups(cell, ',') == 1;
}

bool has_several_numbers(std::string_view cell) {
    constexpr std::string_view separators = " \t,;";
    if (cell.find_first_of(separators) == std::string_view::npos || number_in(cell, true)) return false;
    while (true) {
        const std::size_t end = std::min(cell.find_first_of(separators), cell.size());
        if (!number_in(cell.substr(0, end), false)) return false;
        if (end == cell.size()) return true;
        cell = trimmed(cell.substr(end + 1));
    }
}

bool has_number(std::string_view cell) {
    return number_in(cell, false) || number_in(cell, true) || has_thousands(cell) || has_several_numbers(cell);
}

}  // namespace batten::core
