#include "exchange/svg/decimal.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "core/base/ascii.h"

namespace batten::exchange {

namespace {

using core::DoubleDouble;

// The digits without point and exponent, and by which power of ten they are multiplied.
struct DecimalDigits {
    DoubleDouble digits{};
    std::int64_t power = 0;
};

DecimalDigits digits_of(std::string_view text) {
    constexpr int most = 30;  // that are exact in 106 bits
    DecimalDigits found;
    int count = 0;
    bool is_behind_point = false;
    std::size_t at = 0;
    for (; at < text.size() && (core::is_digit(text[at]) || text[at] == '.'); ++at) {
        if (text[at] == '.') {
            is_behind_point = true;
            continue;
        }
        const bool is_kept = count < most;
        if (is_kept) found.digits = found.digits * 10.0 + DoubleDouble(text[at] - '0');
        if (found.digits.high > 0.0) ++count;
        if (is_kept == is_behind_point) found.power += is_kept ? -1 : 1;
    }
    if (at == text.size()) return found;
    const std::string_view exponent = text.substr(at + (text.substr(at + 1).starts_with('+') ? 2 : 1));
    std::int64_t value = 0;
    std::from_chars(exponent.data(), exponent.data() + exponent.size(), value);
    found.power += value;
    return found;
}

DoubleDouble power_of_ten(std::int64_t exponent) {
    DoubleDouble power = 1.0;
    DoubleDouble square = 10.0;
    for (std::int64_t rest = exponent; rest > 0; rest /= 2) {
        if (rest % 2 == 1) power = power * square;
        square = square * square;
    }
    return power;
}

}  // namespace

DoubleDouble precise_decimal(std::string_view text, double nearest) {
    constexpr double least = 1e-200;
    constexpr double most = 1e200;
    constexpr std::int64_t most_power = 250;
    constexpr double half_unit = 0x1p-53;
    if (!(std::abs(nearest) >= least && std::abs(nearest) <= most)) return nearest;
    const bool is_negative = text.starts_with('-');
    if (is_negative || text.starts_with('+')) text.remove_prefix(1);
    const auto [digits, power] = digits_of(text);
    if (std::abs(power) > most_power) return nearest;
    const DoubleDouble size = power < 0 ? digits / power_of_ten(-power) : digits * power_of_ten(power);
    DoubleDouble number = nearest;
    const double rest = ((is_negative ? -size : size) - number).rounded();
    if (std::abs(rest) <= half_unit * std::abs(nearest)) number.low = rest;
    return number;
}

}  // namespace batten::exchange
