#include "app/editor/words/number_column.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/editor/words/formula.h"

namespace batten::editor {

namespace {

constexpr int most_digits = 6;
constexpr int few_digits = 3;
constexpr int least_decade = -4;
constexpr int most_weight_decimals = 5;

double largest_of(std::span<const double> values) {
    double largest = 0.0;
    for (const double value : values)
        if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    return largest;
}

int decade_of(double value) {
    return static_cast<int>(std::floor(std::log10(value)));
}

/// The fewest decimals, at most `most`, that write `value` as `most` decimals do.
int decimals_needed(double value, int most) {
    double whole = std::round(std::abs(value) * std::pow(10.0, most));
    int decimals = most;
    while (decimals > 0 && std::fmod(whole, 10.0) == 0.0) {
        whole /= 10.0;
        --decimals;
    }
    return decimals;
}

}  // namespace

NumberColumn column_for(std::span<const double> values) {
    const double largest = largest_of(values);
    if (largest == 0.0) return {};
    const int decade = decade_of(largest);
    if (decade >= most_digits || decade < least_decade) return {0, false};
    const int most = most_digits - 1 - decade;
    NumberColumn column;
    for (std::size_t i = 0; i < values.size() && column.decimals < most; ++i)
        column.decimals = std::max(column.decimals, decimals_needed(values[i], most));
    return column;
}

std::string column_text(double value, NumberColumn column) {
    if (!std::isfinite(value) || !column.is_plain) return number_text(value, most_digits);
    const bool is_blurred = value != 0.0 && std::abs(value) < 0.5 * std::pow(10.0, -column.decimals);
    return is_blurred ? number_text(value, few_digits) : fixed_text(value, column.decimals);
}

std::string lone_text(double value, NumberColumn column) {
    const std::string text = column_text(value, column);
    return column.is_plain && text.find('e') == std::string::npos ? without_trailing_zeros(text) : text;
}

int decimals_for(double size) {
    if (!(size > 0.0) || !std::isfinite(size)) return 2;
    return static_cast<int>(std::clamp(std::ceil(3.0 - std::log10(size)), 0.0, 15.0));
}

std::string parameter_text(const core::Curve& curve, double u) {
    return fixed_text(u, decimals_for(curve.domain().length()));
}

std::string place_text(double size, core::Point place) {
    const int decimals = decimals_for(size);
    return fmt::format("({}, {})", fixed_text(place.x, decimals), fixed_text(place.y, decimals));
}

NumberColumn weight_column(const core::Curve& curve) {
    const std::span<const double> weights = curve.weights();
    // Equal weights need not be looked at one by one.
    const std::size_t count = curve.is_rational() ? weights.size() : 1;
    NumberColumn column;
    for (std::size_t i = 0; i < count && column.decimals < most_weight_decimals; ++i) {
        if (weights[i] >= great_weight) continue;
        const int most = std::min(most_weight_decimals, most_digits - 1 - decade_of(weights[i]));
        column.decimals = std::max(column.decimals, decimals_needed(weights[i], most));
    }
    return column;
}

std::string weight_text(double weight, NumberColumn column) {
    return weight >= great_weight ? number_text(weight, most_digits) : lone_text(weight, column);
}

}  // namespace batten::editor
