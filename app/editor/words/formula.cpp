#include "app/editor/words/formula.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "core/base/sentence.h"
#include "core/base/utf8.h"

namespace batten::editor {
namespace {

const std::string minus = true_minus;
constexpr double least_plain = 1e-4;
constexpr double largest_plain = 1e6;

/// to_chars rather than printf: the decimal point must not depend on the locale.
std::string digits_of(double value, std::chars_format format, int precision) {
    std::array<char, 400> buffer{};
    auto* const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, precision).ptr;
    return {buffer.data(), end};
}

bool is_zero(const std::string& digits) {
    return digits.find_first_of("123456789") == std::string::npos;
}

/// "1.5000e+06" as "1.5e6".
std::string scientific(double magnitude, int digits) {
    const std::string text = digits_of(magnitude, std::chars_format::scientific, digits - 1);
    const std::size_t e = text.find('e');
    const int exponent = std::atoi(text.c_str() + e + 1);
    return fmt::format("{}e{}{}", without_trailing_zeros(text.substr(0, e)), exponent < 0 ? minus : "",
                       std::abs(exponent));
}

std::string signed_text(double value, const std::string& magnitude) {
    return value < 0.0 ? minus + magnitude : magnitude;
}

std::string plain(double magnitude, int digits) {
    const int exponent = static_cast<int>(std::floor(std::log10(magnitude)));
    return without_trailing_zeros(digits_of(magnitude, std::chars_format::fixed, std::max(0, digits - 1 - exponent)));
}

bool is_written_plainly(double magnitude, int digits) {
    return magnitude >= least_plain && magnitude < std::max(largest_plain, std::pow(10.0, digits));
}

/// What the last digit of number_text counts; a whole part is never rounded.
double last_digit(double magnitude, int digits) {
    const double unit = std::pow(10.0, std::floor(std::log10(magnitude)) + 1.0 - digits);
    return is_written_plainly(magnitude, digits) ? std::min(unit, 1.0) : unit;
}

/// What a text of number_text without a sign says.
double value_of_text(const std::string& text) {
    const std::size_t sign = text.find(true_minus);
    const std::string ascii =
        sign == std::string::npos
            ? text
            : fmt::format("{}-{}", text.substr(0, sign), text.substr(sign + std::string_view(true_minus).size()));
    double value = 0.0;
    std::from_chars(ascii.data(), ascii.data() + ascii.size(), value);
    return value;
}

std::string index_text(const char* symbol, std::size_t index) {
    return fmt::format("{}_{{{}}}", symbol, index);
}

std::optional<std::string> raised_or_lowered(const std::string& character, bool raised) {
    constexpr std::array superscripts{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    constexpr std::array subscripts{"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
    if (character.size() == 1 && character[0] >= '0' && character[0] <= '9') {
        const auto digit = static_cast<std::size_t>(character[0] - '0');
        return raised ? superscripts[digit] : subscripts[digit];
    }
    if (character == "-" || character == minus) return raised ? "⁻" : "₋";
    if (character == "+") return raised ? "⁺" : "₊";
    if (character == ",") return character;
    return std::nullopt;
}

/// The bytes of the UTF-8 character that starts at `position`.
std::string character_at(const std::string& text, std::size_t position) {
    std::size_t end = position + 1;
    while (end < text.size() && core::continues_utf8(text[end])) ++end;
    return text.substr(position, end - position);
}

std::string plain_group(const std::string& group, bool raised) {
    std::string result;
    for (std::size_t i = 0; i < group.size();) {
        const std::string character = character_at(group, i);
        const std::optional<std::string> glyph = raised_or_lowered(character, raised);
        if (!glyph) return fmt::format("({})", group);
        result += *glyph;
        i += character.size();
    }
    return result;
}

}  // namespace

std::string without_trailing_zeros(std::string text) {
    if (text.find('.') == std::string::npos) return text;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

std::string number_text(double value, int digits) {
    const double magnitude = std::abs(value);
    if (magnitude == 0.0) return "0";
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return signed_text(value, "∞");
    return signed_text(
        value, is_written_plainly(magnitude, digits) ? plain(magnitude, digits) : scientific(magnitude, digits));
}

int digits_that_tell_apart(double a, double b, double c) {
    const auto same = [](double x, double y, int digits) {
        return x != y && number_text(x, digits) == number_text(y, digits);
    };
    int digits = 4;
    while (digits < 17 && (same(a, b, digits) || same(b, c, digits) || same(a, c, digits))) ++digits;
    return digits;
}

std::string parenthesized_if_negative(const std::string& number) {
    return number.rfind(minus, 0) == 0 ? fmt::format("({})", number) : number;
}

std::string bound_text(double value, int digits) {
    constexpr double last_bits = 1e-12;
    std::string nearest = number_text(value, digits);
    if (!(value > 0.0) || std::isinf(value) || value_of_text(nearest) >= value * (1.0 - last_bits)) return nearest;
    // The nearest text is below by less than half a digit: so the next one is nearest here.
    return number_text(value + 0.75 * last_digit(value, digits), digits);
}

std::string fixed_text(double value, int decimals) {
    const std::string digits = digits_of(std::abs(value), std::chars_format::fixed, decimals);
    return is_zero(digits) ? digits : signed_text(value, digits);
}

std::string point_text(std::size_t index) {
    return plain_text(index_text("P", index));
}

std::string points_text(const std::vector<std::size_t>& indices) {
    if (indices.size() == 1) return point_text(indices.front());
    return core::sentence({.one = "one point", .many = "{count} points", .none = "no points"}, indices.size());
}

std::string continuity_text(int continuity) {
    return continuity < 0 ? "jump" : fmt::format("C^{{{}}}", continuity);
}

std::string plain_text(const std::string& label) {
    std::string result;
    for (std::size_t i = 0; i < label.size();) {
        const bool opens = (label[i] == '_' || label[i] == '^') && i + 1 < label.size() && label[i + 1] == '{';
        const std::size_t end = opens ? label.find('}', i) : std::string::npos;
        if (end == std::string::npos) {
            result += label[i++];
            continue;
        }
        result += plain_group(label.substr(i + 2, end - i - 2), label[i] == '^');
        i = end + 1;
    }
    return result;
}

}  // namespace batten::editor
