#include "app/editor/words/field_number.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/editor/words/formula.h"
#include "app/editor/words/number_column.h"
#include "app/editor/words/reading_text.h"

namespace batten::editor {
namespace {

using Fits = std::function<bool(const std::string&)>;

constexpr double rounding_share = 1e-6;  // of the last decimal, which is no digit that someone meant

int shown_decimals(const FieldDigits& digits) {
    return std::min(digits.decimals, digits.most_decimals);
}

double decimal_step(int decimals) {
    return std::pow(10.0, -decimals);
}

/// Whether the decimals that are shown would leave at most one digit of a small value that has more; at most three
/// where the column has no room for those that it needs.
bool hides_digits(double value, const FieldDigits& digits) {
    const double magnitude = std::abs(value);
    const double most_steps = digits.most_decimals < digits.decimals ? 1000.0 : 10.0;
    const double steps = magnitude / decimal_step(shown_decimals(digits));
    const bool is_noise = magnitude < rounding_share * decimal_step(digits.decimals);
    return !is_noise && steps < most_steps && std::abs(steps - std::round(steps)) > rounding_share * steps;
}

/// Three or four digits, as the column has of other numbers.
std::string significant_text(double value, const FieldDigits& digits) {
    const double decade = std::floor(std::log10(std::abs(value)));
    return number_text(value, static_cast<int>(std::clamp(decade + digits.decimals + 1.0, 3.0, 4.0)));
}

std::string factor_text(double value, const FieldDigits& digits) {
    const double magnitude = std::abs(value);
    const bool is_blurred = magnitude != 0.0 && magnitude < 10.0 * decimal_step(digits.decimals);
    const std::string text = fixed_text(value, shown_decimals(digits));
    const bool is_shortened =
        without_trailing_zeros(fixed_text(value, digits.decimals)) != without_trailing_zeros(text);
    return is_blurred || is_shortened || magnitude >= great_weight ? number_text(value, 6) : text;
}

std::string roomy_text(double value, const FieldDigits& digits) {
    if (digits.is_factor) return factor_text(value, digits);
    return hides_digits(value, digits) ? significant_text(value, digits) : fixed_text(value, shown_decimals(digits));
}

/// Whether a tenth of the extent makes a difference in a text of so many significant digits, and in the decimals.
bool tells_apart(double value, const FieldDigits& digits, int significant) {
    const double last = std::pow(10.0, std::floor(std::log10(std::abs(value))) + 1.0 - significant);
    return last <= 0.1 * digits.extent;
}

bool decimals_tell_apart(const FieldDigits& digits) {
    return decimal_step(shown_decimals(digits)) <= 0.1 * digits.extent;
}

/// The last digits before the point, and as many behind it as fit; none where those before it do not.
std::optional<std::string> last_digits(double value, const FieldDigits& digits, const Fits& fits) {
    const double carried = std::floor(std::log10(digits.extent)) + 2.0;
    const auto before_point = static_cast<std::size_t>(std::max(carried, 1.0));
    for (int decimals = digits.decimals; decimals >= 0; --decimals) {
        const std::string all = fixed_text(std::abs(value), decimals);
        const std::size_t whole = std::min(all.find('.'), all.size());
        if (whole <= before_point) return std::nullopt;
        const std::string text = fmt::format("{}…{}", value < 0.0 ? true_minus : "", all.substr(whole - before_point));
        if (fits(text)) return text;
    }
    return std::nullopt;
}

/// Shortened as little as fits, among the texts that are `good` with so many digits.
template <class Good>
std::optional<std::string> shortened(double value, const Fits& fits, const Good& good) {
    for (int significant = 7; significant >= 2 && good(significant); --significant)
        if (const std::string text = number_text(value, significant); fits(text)) return text;
    return std::nullopt;
}

}  // namespace

std::string field_number(double value, const FieldDigits& digits, const Fits& fits) {
    std::string text = roomy_text(value, digits);
    const bool may_read_alike = digits.extent > 0.0 && std::abs(value) > digits.extent && std::isfinite(value);
    if (fits(text) && (!may_read_alike || decimals_tell_apart(digits))) return text;
    if (may_read_alike) {
        const auto is_good = [&](int significant) { return tells_apart(value, digits, significant); };
        if (const auto good = shortened(value, fits, is_good)) return *good;
        if (const auto last = last_digits(value, digits, fits)) return *last;
        if (fits(text)) return text;
    }
    if (const auto shorter = shortened(value, fits, [](int) { return true; })) return *shorter;
    std::string plain = fixed_text(value, shown_decimals(digits));
    if (plain.find_first_of("123456789") != std::string::npos && fits(plain)) return plain;
    return full_reading_text(fmt::format("{:.0e}", value));
}

}  // namespace batten::editor
