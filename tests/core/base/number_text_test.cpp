#include "core/base/number_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace batten::core {
namespace {

TEST(NumberText, shortest_text_reads_back) {
    EXPECT_EQ(shortest_text(0.1), "0.1");
    EXPECT_EQ(shortest_text(100000.0), "1e+05");
    EXPECT_EQ(shortest_text(-0.0), "-0");
    std::string text = "u = ";
    append_shortest_text(text, 0.1 + 0.2);
    EXPECT_EQ(text, "u = 0.30000000000000004");
    EXPECT_EQ(leading_number(shortest_text(std::numeric_limits<double>::denorm_min()))->value, 0x1p-1074);
}

TEST(NumberText, json_text_has_exponents_only_far_from_one) {
    const auto text_of = [](double value) {
        std::string text;
        append_json_text(text, value);
        return text;
    };
    EXPECT_EQ(text_of(100000.0), "100000");
    EXPECT_EQ(text_of(-999999999999999.0), "-999999999999999");
    EXPECT_EQ(text_of(1e15), "1e+15");
    EXPECT_EQ(text_of(999999999999999.9), "999999999999999.9");
    EXPECT_EQ(text_of(0.0001), "0.0001");
    EXPECT_EQ(text_of(0.000099), "9.9e-05");
    EXPECT_EQ(text_of(0.0), "0");
    EXPECT_EQ(text_of(-0.0), "-0.0");
    EXPECT_EQ(text_of(-std::numeric_limits<double>::max()), "-1.7976931348623157e+308");
}

void expect_number(std::string_view text, double value, std::size_t length) {
    const auto found = leading_number(text);
    ASSERT_TRUE(found) << text;
    EXPECT_EQ(found->value, value) << text;
    EXPECT_EQ(found->length, length) << text;
}

TEST(NumberText, numbers_are_read_at_the_front) {
    expect_number("2", 2.0, 1);
    expect_number("+.5,7", 0.5, 3);
    expect_number("-1e-3 ", -0.001, 5);
    expect_number("1.2.3", 1.2, 3);
    expect_number("0,5", 0.0, 1);
    // Halfway between 1 and the next double, and a digit beyond: to the even one, and up.
    expect_number("1.00000000000000011102230246251565404236316680908203125", 1.0, 55);
    expect_number("1.000000000000000111022302462515654042363166809082031251", 0x1.0000000000001p0, 56);
}

// Whatever their digits are: by their exponent, by their zeros, by both.
TEST(NumberText, numbers_below_the_doubles_are_zeros_and_those_beyond_are_none) {
    const std::string zeros(400, '0');
    expect_number("1e-400 ", 0.0, 6);
    expect_number("+9.9E-324,", 0x1p-1073, 9);
    expect_number("2e-324", 0.0, 6);
    expect_number("1e-99999999999999999999999", 0.0, 26);
    expect_number("0." + zeros + "1", 0.0, 403);
    expect_number("0." + zeros + "1e50", 0.0, 406);
    expect_number("1" + zeros + "e-800", 0.0, 406);
    expect_number("1" + zeros + "e-400", 1.0, 406);
    expect_number("0." + zeros + "1e401", 1.0, 407);
    expect_number("-1e-400", 0.0, 7);
    EXPECT_TRUE(std::signbit(leading_number("-1e-400")->value));
    EXPECT_FALSE(std::signbit(leading_number("+1e-400")->value));
    for (const std::string& text : {"1" + zeros, "-1" + zeros + "e-50", "0." + zeros + "1e800",
                                    std::string("1e99999999999999999999999"), std::string("1e+309")})
        EXPECT_FALSE(leading_number(text)) << text;
}

TEST(NumberText, what_is_no_finite_number_is_none) {
    for (const char* text : {"", " 1", "x", "+-1", "--1", "nan", "inf", "-infinity", "1e999", "-1e999", ".", "-"})
        EXPECT_FALSE(leading_number(text)) << text;
}

}  // namespace
}  // namespace batten::core
