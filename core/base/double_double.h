/// Numbers of twice the precision, for differences that must be right though their terms are rounded.
#pragma once

#include <cmath>

namespace batten::core {

/// The unevaluated sum high + low, |low| at most half a unit in the last place of high: some 106 bits. Needs arithmetic
/// without contraction or reordering. Source: Dekker 1971; Hida, Li and Bailey 2001.
struct DoubleDouble {
    double high = 0.0;
    double low = 0.0;

    DoubleDouble() = default;
    DoubleDouble(double value) : high(value) {}
    DoubleDouble(double larger, double smaller) : high(larger + smaller), low(smaller - (high - larger)) {}

    double rounded() const { return high; }
};

/// a + b without error.
inline DoubleDouble exact_sum(double a, double b) {
    DoubleDouble sum;
    sum.high = a + b;
    const double part_of_b = sum.high - a;
    sum.low = (a - (sum.high - part_of_b)) + (b - part_of_b);
    return sum;
}

/// a b without error.
inline DoubleDouble exact_product(double a, double b) {
    DoubleDouble product;
    product.high = a * b;
    product.low = std::fma(a, b, -product.high);
    return product;
}

inline DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble high = exact_sum(a.high, b.high);
    const DoubleDouble low = exact_sum(a.low, b.low);
    const DoubleDouble sum(high.high, high.low + low.high);
    return {sum.high, sum.low + low.low};
}

inline DoubleDouble operator-(DoubleDouble a) {
    DoubleDouble negative;
    negative.high = -a.high;
    negative.low = -a.low;
    return negative;
}

inline DoubleDouble operator-(DoubleDouble a, DoubleDouble b) {
    return a + -b;
}

inline DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble product = exact_product(a.high, b.high);
    return {product.high, product.low + (a.high * b.low + a.low * b.high)};
}

inline DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
    const double first = a.high / b.high;
    const DoubleDouble rest = a - b * first;
    const double second = rest.high / b.high;
    const double third = (rest - b * second).high / b.high;
    return DoubleDouble(first, second) + third;
}

}  // namespace batten::core
