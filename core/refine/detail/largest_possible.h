/// How far something can go before it is impossible, as a number for people.
#pragma once

#include <cmath>

namespace batten::core {

/// `value` >= 0 with so few digits that it can be read and typed, rounded toward 0.
inline double rounded_down(double value) {
    constexpr int digits = 4;
    if (!(value > 0.0) || !std::isfinite(value)) return value;
    // Powers of ten with exact values, so that the result is the nearest double of the number that is meant.
    const double exponent = std::floor(std::log10(value)) + 1 - digits;
    const double power = std::pow(10.0, std::abs(exponent));
    if (!std::isfinite(power)) return value;
    return exponent < 0.0 ? std::floor(value * power) / power : std::floor(value / power) * power;
}

/// The largest number below `impossible` that `is_possible` for, rounded down; 0 where none is found. What is possible
/// is taken to be so for all that is less. Some 100 trials at most.
template <class Predicate>
double largest_possible(double impossible, const Predicate& is_possible) {
    constexpr int halvings = 50;
    constexpr double closeness = 1e-6;
    double lower = 0.0;
    double upper = impossible;
    for (int k = 0; k < 2 * halvings && upper - lower > closeness * upper; ++k) {
        // Far below, the order of size is what is sought first.
        const double middle = lower > 0.0 ? lower + 0.5 * (upper - lower) : 0.125 * upper;
        (is_possible(middle) ? lower : upper) = middle;
    }
    return rounded_down(lower);
}

}  // namespace batten::core
