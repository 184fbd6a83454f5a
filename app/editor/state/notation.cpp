#include "app/editor/state/notation.h"

#include <array>
#include <charconv>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "app/editor/words/formula.h"
#include "app/editor/words/reading_text.h"
#include "core/base/ascii.h"
#include "core/base/fraction.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

bool is_part_of_word(char c) {
    return core::is_letter(c) || core::is_digit(c) || c == '\'';
}

/// Whether the letter at `place` stands by itself; a factor may stand before it, as in "3u", or the d of "du", and an
/// index may follow.
bool stands_alone(std::string_view text, std::size_t place) {
    std::size_t factor = place;
    if (text[place] == 'u' && factor > 0 && text[factor - 1] == 'd') --factor;
    while (factor > 0 && core::is_digit(text[factor - 1])) --factor;
    const bool begins = factor == 0 || !is_part_of_word(text[factor - 1]);
    const bool ends = place + 1 == text.size() || !core::is_letter(text[place + 1]);
    return begins && ends;
}

char notated_letter(char letter, const Notation& notation) {
    const bool has_t = notation.parameter == ParameterLetter::t;
    if (letter == 'P') return core::name_of(notation.points)[0];
    if (letter == 'u' && has_t) return 't';
    if (letter == 'U' && has_t) return 'T';
    return letter;
}

/// The whole number that stands at `place`, its length in the text.
struct WrittenNumber {
    int value = 0;
    std::size_t length = 0;
};

std::optional<WrittenNumber> whole_number_at(std::string_view text, std::size_t place) {
    if (place > text.size()) return std::nullopt;
    const char* const begin = text.data() + place;
    const char* const end = text.data() + text.size();
    WrittenNumber number;
    const std::from_chars_result read = std::from_chars(begin, end, number.value);
    if (read.ec != std::errc() || *begin == '-') return std::nullopt;
    number.length = static_cast<std::size_t>(read.ptr - begin);
    const bool goes_on = read.ptr + 1 < end && *read.ptr == '.' && is_part_of_word(read.ptr[1]);
    return goes_on ? std::nullopt : std::optional(number);
}

/// How the order is told behind a degree, which `text` has behind `opening`; nothing where there is none, or where it
/// is told already.
std::optional<std::pair<std::size_t, std::string>> order_behind(std::string_view text, std::string_view opening,
                                                                const char* pattern) {
    const std::optional<WrittenNumber> degree = whole_number_at(text, opening.size());
    if (!degree) return std::nullopt;
    const std::size_t length = opening.size() + degree->length;
    const std::string order = core::sentence(pattern, {{"order", degree->value + 1}});
    if (text.substr(length).starts_with(order)) return std::nullopt;
    return std::pair(length, order);
}

/// The same for whatever opens a degree at the begin of `text`.
std::optional<std::pair<std::size_t, std::string>> order_at_begin(std::string_view text) {
    constexpr std::array<std::string_view, 6> openings{"egree ",    "egree p = ", "egree to ",
                                                       "egree is ", "egree of ",  "egree has "};
    for (const std::string_view opening : openings)
        if (text.starts_with(opening)) {
            if (auto found = order_behind(text, opening, " (k = {order})")) return found;
        }
    constexpr std::string_view raised = "egree from ";
    if (!text.starts_with(raised)) return std::nullopt;
    const std::optional<WrittenNumber> from = whole_number_at(text, raised.size());
    if (!from) return std::nullopt;
    const std::size_t middle = raised.size() + from->length;
    if (!text.substr(middle).starts_with(" to ")) return std::nullopt;
    return order_behind(text, text.substr(0, middle + 4), " (k = {order})");
}

/// `text` with the order beside each degree.
std::string with_orders(const std::string& text) {
    const std::string_view all = text;
    std::string result;
    for (std::size_t i = 0; i < all.size();) {
        const std::size_t behind_quote = end_of_quote(all, i);
        auto found = order_at_begin(all.substr(i));
        const bool is_p = all[i] == 'p' && stands_alone(all, i) && !all.substr(0, i).ends_with("egree ");
        if (is_p && all.substr(i).starts_with("p = ")) found = order_behind(all.substr(i), "p = ", ", k = {order}");
        const std::size_t length = behind_quote > i ? behind_quote - i : found ? found->first : 1;
        result.append(all.substr(i, length));
        if (behind_quote == i && found) result.append(found->second);
        i += length;
    }
    return result;
}

/// A decimal that ends: nothing but 2 and 5 in the denominator.
bool is_decimal(std::int64_t denominator) {
    for (const std::int64_t prime : {2, 5})
        while (denominator % prime == 0) denominator /= prime;
    return denominator == 1;
}

/// Whether a decimal is better read as a fraction.
bool is_simple(core::Fraction fraction) {
    constexpr std::int64_t most_halves = 20;
    const std::int64_t n = std::abs(fraction.numerator);
    const std::int64_t d = fraction.denominator;
    if ((d == 2 || d == 4 || d == 8) && n <= most_halves) return true;
    return n < d && (d == 5 || d == 8 || d == 10 || d == 16 || d == 32 || d == 64);
}

/// Whether so many digits are all that it has.
bool is_written_by(double value, int digits) {
    return number_text(value, digits) == number_text(value, std::numeric_limits<double>::digits10);
}

constexpr std::int64_t most_numerator_of_decimal = 99;
constexpr std::int64_t most_fraction_numerator = 999;

std::optional<core::Fraction> fraction_to_read(double value) {
    const std::optional<core::Fraction> fraction = core::small_fraction(value);
    return fraction && std::abs(fraction->numerator) <= most_fraction_numerator ? fraction : std::nullopt;
}

bool is_read_as_fraction(double value, core::Fraction fraction, int digits) {
    if (fraction.denominator == 1) return false;
    if (!is_decimal(fraction.denominator)) return true;
    return is_simple(fraction) ||
           (std::abs(fraction.numerator) <= most_numerator_of_decimal && !is_written_by(value, digits));
}

std::string text_of_fraction(core::Fraction fraction) {
    std::string text = core::fraction_text(fraction);
    if (text.front() == '-') text.replace(0, 1, true_minus);
    return text;
}

template <core::HasNames Enum>
void read_choice(const std::map<std::string, std::string>& names, const char* name, Enum& value) {
    const auto found = names.find(name);
    if (found != names.end()) value = core::value_named<Enum>(found->second).value_or(value);
}

}  // namespace

std::string notated(const std::string& text, const Notation& notation) {
    std::string result = notation.degree == DegreeOrOrder::order ? with_orders(text) : text;
    for (std::size_t i = 0; i < result.size(); ++i) {
        const std::size_t behind_quote = end_of_quote(result, i);
        if (behind_quote > i)
            i = behind_quote - 1;
        else if (stands_alone(result, i))
            result[i] = notated_letter(result[i], notation);
    }
    return result;
}

std::string exact_text(const Notation& notation, double value, int digits) {
    if (notation.numbers == NumberStyle::decimals) return number_text(value, digits);
    const std::optional<core::Fraction> fraction = fraction_to_read(value);
    return fraction && is_read_as_fraction(value, *fraction, digits) ? text_of_fraction(*fraction)
                                                                     : number_text(value, digits);
}

std::string unrounded_text(const Notation& notation, double value, std::string rounded) {
    if (notation.numbers == NumberStyle::decimals) return rounded;
    const std::optional<core::Fraction> fraction = fraction_to_read(value);
    return fraction && !is_decimal(fraction->denominator) ? text_of_fraction(*fraction) : rounded;
}

std::vector<std::string> exact_texts(const Notation& notation, std::span<const double> values, int digits) {
    std::vector<core::Fraction> fractions;
    bool has_fraction = false;
    for (const double value : values)
        if (const auto fraction = fraction_to_read(value)) {
            fractions.push_back(*fraction);
            has_fraction = has_fraction || is_read_as_fraction(value, *fraction, digits);
        }
    const bool are_fractions =
        has_fraction && fractions.size() == values.size() && notation.numbers == NumberStyle::fractions;
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < values.size(); ++i)
        texts.push_back(are_fractions && fractions[i].denominator != 1 ? text_of_fraction(fractions[i])
                                                                       : number_text(values[i], digits));
    return texts;
}

std::map<std::string, std::string> names_of(const Notation& notation) {
    return {{"points", std::string(core::name_of(notation.points))},
            {"parameter", std::string(core::name_of(notation.parameter))},
            {"degree", std::string(core::name_of(notation.degree))},
            {"triangles", std::string(core::name_of(notation.triangles))},
            {"numbers", std::string(core::name_of(notation.numbers))}};
}

Notation notation_named(const std::map<std::string, std::string>& names) {
    Notation notation;
    read_choice(names, "points", notation.points);
    read_choice(names, "parameter", notation.parameter);
    read_choice(names, "degree", notation.degree);
    read_choice(names, "triangles", notation.triangles);
    read_choice(names, "numbers", notation.numbers);
    return notation;
}

}  // namespace batten::editor
