#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "exchange/svg/decimal.h"

namespace batten::exchange {

namespace {

void expect_rest(const std::string& text, double rest) {
    const double nearest = std::stod(text);
    const core::DoubleDouble found = precise_decimal(text, nearest);
    EXPECT_EQ(found.high, nearest) << text;
    EXPECT_NEAR(found.low, rest, 1e-13 * std::abs(rest)) << text;
}

}  // namespace

// By arithmetic of 60 digits.
TEST(PreciseDecimal, IsWhatTheDoubleLacks) {
    expect_rest("0.1", -5.551115123125782702e-18);
    expect_rest("-.1e0", 5.551115123125782702e-18);
    expect_rest("+00100.0e-3", -5.551115123125782702e-18);
    expect_rest("." + std::string(400, '0') + "1e400", -5.551115123125782702e-18);
    expect_rest("1e23", 8388608.0);
    expect_rest("1E-100", -1.999189980260288361964776e-117);
    expect_rest("3.14159265358979323846264338327", 1.224646799147258148384e-16);
    expect_rest("9007199254740993", 1.0);
}

TEST(PreciseDecimal, IsTheDoubleWhereThatIsExactOrFarFromOne) {
    for (const char* const text : {"0", "-0.0", "12.50e+2", "4503599627370496", "1e-300", "1.7e308"})
        expect_rest(text, 0.0);
}

}  // namespace batten::exchange
