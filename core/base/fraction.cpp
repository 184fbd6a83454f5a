#include "core/base/fraction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace batten::core {

namespace {

constexpr double most_value = 1e6;
constexpr std::int64_t any_denominator = 30;
constexpr std::int64_t smooth_denominator = 1000;
constexpr double units_of_rounding = 4.0;

bool is_small(std::int64_t denominator) {
    if (denominator <= any_denominator) return true;
    if (denominator > smooth_denominator) return false;
    for (const std::int64_t prime : {2, 3, 5, 7})
        while (denominator % prime == 0) denominator /= prime;
    return denominator == 1;
}

}  // namespace

std::optional<Fraction> small_fraction(double value) {
    if (!(std::abs(value) < most_value)) return std::nullopt;
    const double tolerance =
        units_of_rounding * std::numeric_limits<double>::epsilon() * std::max(1.0, std::abs(value));
    // The convergents h/k of the continued fraction, from the last but one and the last.
    Fraction before{0, 1};
    Fraction last{1, 0};
    double rest = value;
    while (true) {
        const auto whole = static_cast<std::int64_t>(std::floor(rest));
        const Fraction next{whole * last.numerator + before.numerator, whole * last.denominator + before.denominator};
        if (next.denominator > smooth_denominator) return std::nullopt;
        if (std::abs(next.value() - value) <= tolerance)
            return is_small(next.denominator) ? std::optional(next) : std::nullopt;
        before = last;
        last = next;
        const double part = rest - static_cast<double>(whole);
        if (part * static_cast<double>(smooth_denominator) < 1.0 / static_cast<double>(smooth_denominator))
            return std::nullopt;
        rest = 1.0 / part;
    }
}

std::string fraction_text(Fraction fraction) {
    if (fraction.denominator == 1) return fmt::format("{}", fraction.numerator);
    return fmt::format("{}/{}", fraction.numerator, fraction.denominator);
}

}  // namespace batten::core
