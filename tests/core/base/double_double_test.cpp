#include "core/base/double_double.h"

#include <gtest/gtest.h>

#include <cmath>

namespace batten::core {
namespace {

const double tiny = std::ldexp(1.0, -70);

void expect_parts(DoubleDouble found, double high, double low) {
    EXPECT_EQ(found.high, high);
    EXPECT_EQ(found.low, low);
}

TEST(DoubleDouble, keeps_what_sums_and_products_lose) {
    expect_parts(exact_sum(1.0, tiny), 1.0, tiny);
    expect_parts(exact_sum(-tiny, 1.0), 1.0, -tiny);
    // (1 + 2^-30)^2 = 1 + 2^-29 + 2^-60
    const double factor = 1.0 + std::ldexp(1.0, -30);
    expect_parts(exact_product(factor, factor), 1.0 + std::ldexp(1.0, -29), std::ldexp(1.0, -60));
}

TEST(DoubleDouble, computes_with_twice_the_digits) {
    const DoubleDouble above = exact_sum(1.0, tiny);
    expect_parts(above - DoubleDouble(1.0), tiny, 0.0);
    expect_parts(-above + DoubleDouble(1.0), -tiny, 0.0);
    // (1 + e) (1 - e) = 1 - e^2, where e^2 is 2^-140 and beyond the digits.
    expect_parts(above * exact_sum(1.0, -tiny), 1.0, 0.0);
    const DoubleDouble third = DoubleDouble(1.0) / DoubleDouble(3.0);
    EXPECT_EQ(third.rounded(), 1.0 / 3.0);
    // 1/3 rounds down by (1/3) 2^-54.
    EXPECT_DOUBLE_EQ(third.low, std::ldexp(1.0, -54) / 3.0);
}

}  // namespace
}  // namespace batten::core
