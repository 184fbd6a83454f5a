#include "app/editor/expression.h"

#include <gtest/gtest.h>

#include <clocale>
#include <limits>

#include "core/base/number_text.h"

namespace batten::editor {
namespace {

double value_of(const std::string& text) {
    const auto value = parse_expression(text);
    EXPECT_TRUE(value.has_value()) << text << ": " << (value ? "" : value.error());
    return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

std::string error_of(const std::string& text) {
    const auto value = parse_expression(text);
    EXPECT_FALSE(value.has_value()) << text;
    return value ? "" : value.error();
}

TEST(Expression, reads_plain_numbers) {
    EXPECT_EQ(value_of("3"), 3.0);
    EXPECT_EQ(value_of("-0.5"), -0.5);
    EXPECT_EQ(value_of(".25"), 0.25);
    EXPECT_EQ(value_of("1e-3"), 0.001);
    EXPECT_EQ(value_of("  2.5\t"), 2.5);
    EXPECT_EQ(value_of("+7"), 7.0);
    EXPECT_EQ(value_of("\u22122.20"), -2.2);
}

TEST(Expression, computes_with_the_usual_precedence) {
    EXPECT_EQ(value_of("1/3"), 1.0 / 3.0);
    EXPECT_EQ(value_of("2*(3+1)"), 8.0);
    EXPECT_EQ(value_of("2+3*4"), 14.0);
    EXPECT_EQ(value_of("8/4/2"), 1.0);
    EXPECT_EQ(value_of("8-4-2"), 2.0);
    EXPECT_EQ(value_of("-2*-3"), 6.0);
    EXPECT_EQ(value_of("-(1 - 4) / 2"), 1.5);
    EXPECT_EQ(value_of("1e2/1e1"), 10.0);
}

TEST(Expression, refuses_with_a_sentence) {
    EXPECT_EQ(error_of(""), "type a number, such as 0.5, 1/3 or 2*(3+1)");
    EXPECT_EQ(error_of("   "), error_of(""));
    EXPECT_EQ(error_of("abc"), "\u201ca\u201d cannot be read; numbers, + - * / and parentheses are allowed");
    EXPECT_EQ(error_of("2\u00e9"), "\u201c\u00e9\u201d cannot be read; numbers, + - * / and parentheses are allowed");
    EXPECT_EQ(error_of("0,5"), "a comma cannot be read here; write decimals with a point, as in 0.5");
    EXPECT_EQ(error_of("2*"), "a number is missing at the end");
    EXPECT_EQ(error_of("2*()"), "a number is missing before the closing parenthesis");
    EXPECT_EQ(error_of("(1+2"), "a closing parenthesis is missing");
    EXPECT_EQ(error_of("1+2)"), "a closing parenthesis has no opening one");
    EXPECT_EQ(error_of("1/(2-2)"), "a division by zero has no value");
    EXPECT_EQ(error_of("1 2"), "\u201c2\u201d cannot be read; numbers, + - * / and parentheses are allowed");
}

TEST(Expression, never_gives_what_is_not_finite) {
    EXPECT_EQ(error_of("1e999"), "\u201c1e999\u201d is outside the range of numbers");
    EXPECT_EQ(error_of("1e308*10"), "the result is too large for a number");
    EXPECT_FALSE(parse_expression("1e308*10-1e308*10").has_value());
    EXPECT_FALSE(parse_expression("inf").has_value());
    EXPECT_FALSE(parse_expression("nan").has_value());
    EXPECT_FALSE(parse_expression("0x10").has_value());
    EXPECT_FALSE(parse_expression(".").has_value());
}

TEST(Expression, survives_deep_nesting) {
    EXPECT_EQ(value_of(std::string(50, '(') + "1" + std::string(50, ')')), 1.0);
    EXPECT_EQ(error_of(std::string(1000000, '(')), "too many parentheses or signs inside one another");
    EXPECT_EQ(error_of(std::string(1000000, '-')), "too many parentheses or signs inside one another");
}

TEST(Expression, does_not_depend_on_the_locale) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8", "C"}) {
        std::setlocale(LC_ALL, locale);
        EXPECT_EQ(value_of("0.5"), 0.5);
        EXPECT_EQ(core::shortest_text(0.5), "0.5");
    }
    std::setlocale(LC_ALL, before.c_str());
}

TEST(Expressions, read_lists) {
    using List = std::vector<double>;
    EXPECT_EQ(parse_expressions("0 0  1/4 1 1").value(), (List{0, 0, 0.25, 1, 1}));
    EXPECT_EQ(parse_expressions("0, 0, 1 / 4, 1").value(), (List{0, 0, 0.25, 1}));
    EXPECT_EQ(parse_expressions("[0;0;1]").value(), (List{0, 0, 1}));
    EXPECT_EQ(parse_expressions("{ -1, 2 }").value(), (List{-1, 2}));
    EXPECT_EQ(parse_expressions("  ").value(), List{});
}

TEST(Expressions, name_the_entry_that_cannot_be_read) {
    EXPECT_EQ(parse_expressions("0, x, 1").error(),
              "entry 1: \u201cx\u201d cannot be read; numbers, + - * / and parentheses are allowed");
    EXPECT_EQ(parse_expressions("0,,1").error(), "entry 1: type a number, such as 0.5, 1/3 or 2*(3+1)");
}

TEST(ShortestText, reads_back_to_the_same_double) {
    EXPECT_EQ(core::shortest_text(0.1), "0.1");
    EXPECT_EQ(core::shortest_text(-6.0), "-6");
    EXPECT_EQ(core::shortest_text(1.0 / 3.0), "0.3333333333333333");
    for (const double value : {0.1 + 0.2, 1e-300, 5e-324, 1.7976931348623157e308, -2.0 / 7.0})
        EXPECT_EQ(value_of(core::shortest_text(value)), value);
}

}  // namespace
}  // namespace batten::editor
