#include "core/base/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace batten::core {

namespace {

// What std::to_chars makes of the arguments.
template <class... Arguments>
void append_chars(std::string& text, Arguments... arguments) {
    std::array<char, 32> buffer{};
    char* const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), arguments...).ptr;
    text.append(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
}

// Whether a number outside the range of doubles is too small for them: by the decimal exponent of its first digit.
bool is_too_small(std::string_view number) {
    const std::size_t behind_digits = std::min(number.find_first_of("eE"), number.size());
    const std::string_view digits = number.substr(0, behind_digits);
    const auto first = static_cast<double>(digits.find_first_of("123456789"));
    const auto point = static_cast<double>(std::min(digits.find('.'), digits.size()));
    std::string_view exponent = number.substr(std::min(behind_digits + 1, number.size()));
    exponent.remove_prefix(exponent.starts_with('+') ? 1 : 0);
    std::int64_t power = 0;
    const auto read = std::from_chars(exponent.data(), exponent.data() + exponent.size(), power);
    if (read.ec == std::errc::result_out_of_range) return exponent.starts_with('-');
    return point - first + static_cast<double>(power) < 0.0;
}

}  // namespace

std::string shortest_text(double value) {
    std::string text;
    append_shortest_text(text, value);
    return text;
}

void append_shortest_text(std::string& text, double value) {
    append_chars(text, value);
}

void append_json_text(std::string& text, double value) {
    constexpr double least_fixed = 1e-4;
    constexpr double least_with_exponent = 1e15;
    const double size = std::abs(value);
    if (value == 0.0)
        text.append(std::signbit(value) ? "-0.0" : "0");
    else if (size < least_with_exponent && std::trunc(value) == value)
        append_chars(text, static_cast<std::int64_t>(value));
    else
        append_chars(text, value,
                     least_fixed <= size && size < least_with_exponent ? std::chars_format::fixed
                                                                       : std::chars_format::scientific);
}

std::optional<LeadingNumber> leading_number(std::string_view text) {
    const std::size_t sign = text.starts_with('+') && !text.starts_with("+-") ? 1 : 0;
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data() + sign, text.data() + text.size(), value);
    const auto length = static_cast<std::size_t>(end - text.data());
    if (error == std::errc::result_out_of_range && is_too_small(text.substr(0, length)))
        return LeadingNumber{text.starts_with('-') ? -0.0 : 0.0, length};
    if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
    return LeadingNumber{value, length};
}

}  // namespace batten::core
