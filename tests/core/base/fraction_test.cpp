#include "core/base/fraction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace batten::core {
namespace {

TEST(FractionTest, FindsEverySmallFractionInLowestTerms) {
    for (std::int64_t denominator = 1; denominator <= 30; ++denominator)
        for (std::int64_t numerator = -3 * denominator; numerator <= 3 * denominator; ++numerator) {
            const std::int64_t common = std::gcd(numerator, denominator);
            const Fraction expected{numerator / common, denominator / common};
            EXPECT_EQ(small_fraction(static_cast<double>(numerator) / static_cast<double>(denominator)), expected);
        }
}

TEST(FractionTest, FindsFractionsOfFactorials) {
    EXPECT_EQ(small_fraction(1.0 / 720.0), (Fraction{1, 720}));
    EXPECT_EQ(small_fraction(-719.0 / 720.0), (Fraction{-719, 720}));
    EXPECT_EQ(small_fraction(57.0 / 120.0), (Fraction{19, 40}));
    EXPECT_EQ(small_fraction(17.0 / 49.0), (Fraction{17, 49}));
    EXPECT_EQ(small_fraction(307.0 / 750.0), (Fraction{307, 750}));
    EXPECT_EQ(small_fraction(1.0 / 1000.0), (Fraction{1, 1000}));
    EXPECT_EQ(small_fraction(1.0 / 1008.0), std::nullopt);
}

TEST(FractionTest, ForgivesRoundingAlone) {
    EXPECT_EQ(small_fraction((0.4 - 0.0) / (0.75 - 0.0)), (Fraction{8, 15}));
    EXPECT_EQ(small_fraction(1.0 - 1.0 / 3.0), (Fraction{2, 3}));
    EXPECT_EQ(small_fraction(1e-16), (Fraction{0, 1}));
    EXPECT_EQ(small_fraction(1.0 / 3.0 + 1e-12), std::nullopt);
    EXPECT_EQ(small_fraction(0.3333), std::nullopt);
}

TEST(FractionTest, FindsNoneWhereTheNumbersAreNotSmall) {
    EXPECT_EQ(small_fraction(203.0 / 76.0), std::nullopt);
    EXPECT_EQ(small_fraction(1.0 / 721.0), std::nullopt);
    EXPECT_EQ(small_fraction(M_PI), std::nullopt);
    EXPECT_EQ(small_fraction(std::sqrt(2.0)), std::nullopt);
    EXPECT_EQ(small_fraction(1e6), std::nullopt);
    EXPECT_EQ(small_fraction(-std::numeric_limits<double>::infinity()), std::nullopt);
    EXPECT_EQ(small_fraction(std::numeric_limits<double>::quiet_NaN()), std::nullopt);
    EXPECT_EQ(small_fraction(1e-9), std::nullopt);
}

TEST(FractionTest, IsWrittenAsPeopleDo) {
    EXPECT_EQ(fraction_text({-1, 6}), "-1/6");
    EXPECT_EQ(fraction_text({4, 1}), "4");
    EXPECT_EQ(fraction_text({0, 1}), "0");
}

}  // namespace
}  // namespace batten::core
