/// Fractions of whole numbers, and which of them a double stands for.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace batten::core {

/// In lowest terms; the denominator is > 0.
struct Fraction {
    std::int64_t numerator = 0;
    std::int64_t denominator = 1;

    double value() const { return static_cast<double>(numerator) / static_cast<double>(denominator); }
    bool operator==(const Fraction&) const = default;
};

/// The fraction of small numbers that people mean by `value`: it differs from it by rounding alone (four units in the
/// last place of `value`, or of 1 where that is more), and its denominator is at most 30, or at most 1000 with no prime
/// factor above 7, so that 1/6, 8/15, 307/750 and 1/720 are found and 203/76 is not. None where there is none, and
/// where |value| >= 1e6. Whole numbers have the denominator 1. Cost O(log) by continued fractions (Khinchin 1964).
std::optional<Fraction> small_fraction(double value);

/// "-1/6", "2".
std::string fraction_text(Fraction fraction);

}  // namespace batten::core
