#include "app/editor/words/reading_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "app/editor/words/formula.h"
#include "core/base/ascii.h"

namespace batten::editor {

namespace {

constexpr int digits_to_read = 6;
constexpr int digits_to_read_afar = 3;
constexpr std::string_view bound_words = "at most ";
constexpr std::string_view degree_sign = "°";

/// A character that a number is not divided from: a letter, another script's included, or a part of a name.
bool belongs_to_word(char c) {
    return core::is_digit(c) || core::is_letter(c) || c == '_' || c == '.' || c == '-' ||
           (static_cast<unsigned char>(c) & 0x80U) != 0;
}

/// Significant digits as they are written: neither zeros before the first other digit nor the exponent.
std::size_t digit_count(std::string_view number) {
    const std::string_view mantissa = number.substr(0, number.find('e'));
    const std::size_t first = mantissa.find_first_of("123456789");
    if (first == std::string_view::npos) return 1;
    return static_cast<std::size_t>(std::count_if(mantissa.begin() + static_cast<std::ptrdiff_t>(first), mantissa.end(),
                                                  [](char c) { return core::is_digit(c); }));
}

/// The least number of so many digits that is not below `value` but for its last bits.
double rounded_up(double value, int digits) {
    constexpr double last_bits = 1e-14;
    if (value == 0.0) return value;
    const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - digits + 1);
    return std::ceil(value * (1.0 - last_bits) / unit) * unit;
}

/// "-2e-05" as "−2e−5".
std::string with_true_minus(std::string_view number) {
    std::string result;
    for (std::size_t i = 0; i < number.size(); ++i) {
        const bool is_in_exponent = i > 0 && number.find('e') < i;
        const bool is_filler =
            is_in_exponent && (number[i] == '+' || (number[i] == '0' && !core::is_digit(number[i - 1])));
        if (is_filler) continue;
        if (number[i] == '-')
            result += true_minus;
        else
            result += number[i];
    }
    return result;
}

std::string shortened(std::string_view number, int most_digits, bool is_bound) {
    const bool is_whole = number.find_first_of(".e") == std::string_view::npos;
    if (is_whole || digit_count(number) <= static_cast<std::size_t>(most_digits)) return with_true_minus(number);
    double value = 0.0;
    std::from_chars(number.data(), number.data() + number.size(), value);
    return number_text(is_bound ? rounded_up(value, most_digits) : value, most_digits);
}

/// The number that begins at `i`, or nothing where there is none by itself.
std::string_view number_at(std::string_view text, std::size_t i) {
    if (i > 0 && belongs_to_word(text[i - 1])) return {};
    const std::size_t first = text[i] == '-' ? i + 1 : i;
    if (first >= text.size() || !core::is_digit(text[first])) return {};
    double ignored = 0.0;
    const auto* const end = std::from_chars(text.data() + i, text.data() + text.size(), ignored).ptr;
    const auto length = static_cast<std::size_t>(end - text.data()) - i;
    const std::string_view behind = text.substr(i + length);
    const bool goes_on =
        !behind.empty() && belongs_to_word(behind.front()) && behind.front() != '.' && !behind.starts_with(degree_sign);
    return goes_on ? std::string_view() : text.substr(i, length);
}

std::string read_with(const std::string& text, int most_digits) {
    const std::string_view all = text;
    std::string result;
    for (std::size_t i = 0; i < all.size();) {
        if (const std::size_t end = end_of_quote(all, i); end > i) {
            result.append(all.substr(i, end - i));
            i = end;
        } else if (const std::string_view number = number_at(all, i); !number.empty()) {
            result += shortened(number, most_digits, all.substr(0, i).ends_with(bound_words));
            i += number.size();
        } else {
            result += all[i++];
        }
    }
    return result;
}

}  // namespace

std::size_t end_of_quote(std::string_view text, std::size_t i) {
    const bool may_open = text[i] == '\'' && (i == 0 || text[i - 1] == ' ' || text[i - 1] == '(');
    const std::size_t closing = may_open ? text.find('\'', i + 1) : std::string_view::npos;
    return closing == std::string_view::npos ? i : closing + 1;
}

std::string reading_text(const std::string& text) {
    return read_with(text, digits_to_read);
}

std::string brief_reading_text(const std::string& text) {
    const std::size_t bound = text.find(bound_words);
    const std::size_t clause = bound == std::string::npos ? bound : text.rfind("; ", bound);
    return read_with(text.substr(0, clause), digits_to_read_afar);
}

std::string full_reading_text(const std::string& text) {
    return read_with(text, std::numeric_limits<double>::max_digits10);
}

}  // namespace batten::editor
