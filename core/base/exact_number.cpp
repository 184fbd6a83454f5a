#include "core/base/exact_number.h"

#include <limits>
#include <numeric>

namespace batten::core {

namespace {

using Whole = std::optional<std::int64_t>;

// The least number has no opposite.
Whole with_opposite(std::int64_t value) {
    return value == std::numeric_limits<std::int64_t>::min() ? std::nullopt : Whole(value);
}

Whole checked_sum(Whole a, Whole b) {
    std::int64_t result = 0;
    if (!a || !b || __builtin_add_overflow(*a, *b, &result)) return std::nullopt;
    return with_opposite(result);
}

Whole checked_product(std::int64_t a, std::int64_t b) {
    std::int64_t result = 0;
    return __builtin_mul_overflow(a, b, &result) ? std::nullopt : with_opposite(result);
}

ExactNumber in_lowest_terms(Whole numerator, Whole denominator) {
    if (!numerator || !denominator) return std::nullopt;
    const std::int64_t common = std::gcd(*numerator, *denominator);
    return Fraction{*numerator / common, *denominator / common};
}

}  // namespace

ExactNumber operator+(const ExactNumber& a, const ExactNumber& b) {
    if (!a || !b) return std::nullopt;
    const std::int64_t common = std::gcd(a->denominator, b->denominator);
    return in_lowest_terms(checked_sum(checked_product(a->numerator, b->denominator / common),
                                       checked_product(b->numerator, a->denominator / common)),
                           checked_product(a->denominator / common, b->denominator));
}

ExactNumber operator-(const ExactNumber& a, const ExactNumber& b) {
    return a + ExactNumber(Fraction{-1, 1}) * b;
}

ExactNumber operator*(const ExactNumber& a, const ExactNumber& b) {
    if (!a || !b) return std::nullopt;
    // What can be canceled across is canceled first, so that only results that are too large leave 64 bits.
    const std::int64_t left = std::gcd(a->numerator, b->denominator);
    const std::int64_t right = std::gcd(b->numerator, a->denominator);
    return in_lowest_terms(checked_product(a->numerator / left, b->numerator / right),
                           checked_product(a->denominator / right, b->denominator / left));
}

ExactNumber operator/(const ExactNumber& a, const ExactNumber& b) {
    if (!b || b->numerator == 0) return std::nullopt;
    const bool is_negative = b->numerator < 0;
    return a *
           ExactNumber(is_negative ? Fraction{-b->denominator, -b->numerator} : Fraction{b->denominator, b->numerator});
}

}  // namespace batten::core
