#include "app/editor/fields/expression.h"

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

TEST(Expression, knows_pi_powers_and_functions) {
    EXPECT_EQ(value_of("pi"), 3.141592653589793);
    EXPECT_EQ(value_of("2*PI"), 6.283185307179586);
    EXPECT_EQ(value_of("π/2"), 1.5707963267948966);
    EXPECT_EQ(value_of("sqrt(2)/2"), 0.7071067811865476);
    EXPECT_EQ(value_of("Sqrt (9)"), 3.0);
    EXPECT_EQ(value_of("2^3^2"), 512.0);
    EXPECT_EQ(value_of("-2^2"), -4.0);
    EXPECT_EQ(value_of("2^-1"), 0.5);
    EXPECT_EQ(value_of("ln(exp(3))"), 3.0);
    EXPECT_EQ(value_of("abs(2 - 5)"), 3.0);
    EXPECT_EQ(value_of("sin(pi/2)"), 1.0);
}

TEST(Expression, takes_degrees_where_they_stand) {
    EXPECT_EQ(value_of("180 deg"), 3.141592653589793);
    EXPECT_EQ(value_of("sin(30 deg)"), 0.5);
    EXPECT_EQ(value_of("cos(60°)"), 0.5);
    EXPECT_EQ(value_of("cos(-240deg)"), -0.5);
    EXPECT_EQ(value_of("sin(180 deg)"), 0.0);
    EXPECT_EQ(value_of("sin(-390 DEG)"), -0.5);
    EXPECT_EQ(value_of("tan(45 deg)"), 1.0);
    EXPECT_EQ(value_of("cos(1/3 deg)"), 0.9999830768577442) << "a third of a degree, not one over three degrees";
    EXPECT_EQ(value_of("(90 deg)/(30 deg)"), 3.0);
    EXPECT_EQ(value_of("4*atan(1)"), 3.141592653589793);
}

TEST(Expression, is_an_angle_in_degrees_where_one_is_needed) {
    const auto degrees_of = [](const std::string& text) {
        return parse_expression(text, ExpressionUnit::degrees).value();
    };
    EXPECT_EQ(degrees_of("90"), 90.0);
    EXPECT_EQ(degrees_of("90 deg"), 90.0);
    EXPECT_EQ(degrees_of("-22.5°"), -22.5);
    EXPECT_EQ(degrees_of("45 + 1/2 deg"), 45.5);
    EXPECT_EQ(degrees_of("pi/2 rad"), 90.0);
    EXPECT_EQ(degrees_of("asin(1/2)"), 30.0);
    EXPECT_EQ(degrees_of("acos(1/2)"), 60.0);
}

TEST(Expression, changes_what_is_there) {
    const auto over = [](const std::string& typed, const std::string& present) {
        return parse_expression(typed_over(typed, present)).value();
    };
    EXPECT_EQ(over("+=2", "3"), 5.0);
    EXPECT_EQ(over(" -= 1/4", "-1"), -1.25);
    EXPECT_EQ(over("\u2212=4", "-1"), -5.0);
    EXPECT_EQ(over("*=1+1", "3-1"), 4.0);
    EXPECT_EQ(over("/=sqrt(16)", "2"), 0.5);
    EXPECT_EQ(over("^=2", "-3"), 9.0);
    EXPECT_EQ(over("+2", "3"), 2.0);
    EXPECT_EQ(typed_over("+=2", ""), "+=2");
    EXPECT_FALSE(parse_expression(typed_over("+=", "3")));
}

TEST(Expression, takes_a_decimal_comma) {
    EXPECT_EQ(value_of("0,5"), 0.5);
    EXPECT_EQ(value_of("-,25"), -0.25);
    EXPECT_EQ(value_of("1,5e3 + 2,5"), 1502.5);
    EXPECT_EQ(error_of("1,000.5"), "“1,000.5” has several points or commas; one is allowed, before the decimals");
    EXPECT_EQ(error_of("40,-10"), "“40,” has no decimals after its comma") << "two numbers, not 30";
    EXPECT_EQ(value_of("40,"), 40.0) << "as far as it is typed";
    EXPECT_EQ(error_of("1,2,3"), "“1,2,3” has several points or commas; one is allowed, before the decimals");
}

TEST(Expression, refuses_with_a_sentence) {
    const std::string allowed = "numbers, + - * / ^ and parentheses are allowed";
    EXPECT_EQ(error_of(""), "type a number, such as 0.5, 1/3 or sqrt(2)/2");
    EXPECT_EQ(error_of("   "), error_of(""));
    EXPECT_EQ(error_of("Abc+1"),
              "“Abc” is not known; pi, deg, rad, sqrt, sin, cos, tan, asin, acos, atan, exp, ln and abs are");
    EXPECT_EQ(error_of("2\u00e9"), "\u201c\u00e9\u201d cannot be read here; " + allowed);
    EXPECT_EQ(error_of("1 2"), "\u201c2\u201d cannot be read here; " + allowed);
    EXPECT_EQ(error_of("2pi"), "\u201cpi\u201d cannot be read here; a product is written with *, as in 2*pi");
    EXPECT_EQ(error_of("2*"), "a number is missing at the end");
    EXPECT_EQ(error_of("2*()"), "a number is missing before the closing parenthesis");
    EXPECT_EQ(error_of("(1+2"), "a closing parenthesis is missing");
    EXPECT_EQ(error_of("1+2)"), "a closing parenthesis has no opening one");
    EXPECT_EQ(error_of("1/(2-2)"), "a division by zero has no value");
    EXPECT_EQ(error_of("sqrt 2"), "sqrt needs parentheses, as in sqrt(0.5)");
    EXPECT_EQ(error_of("sqrt(-2)"), "sqrt(-2) has no value");
    EXPECT_EQ(error_of("tan(90 deg)"), "tan(1.5707963267948966) has no value");
    EXPECT_EQ(error_of("(0-2)^0.5"), "(-2)^0.5 has no value");
    EXPECT_EQ(error_of("90deg/30deg"), "a product has two units; parentheses are needed, as in (90 deg)/(30 deg)");
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
    EXPECT_FALSE(parse_expression("sqrt(" + std::string(200000, '(')).has_value());
    std::string powers = "1";
    for (int i = 0; i < 100000; ++i) powers += "^1";
    EXPECT_EQ(error_of(powers), "too many parentheses or signs inside one another");
    std::string ones = "1";
    for (int i = 0; i < 100000; ++i) ones += "+1";
    EXPECT_EQ(value_of(ones), 100001.0);
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
    EXPECT_EQ(parse_expressions("4,").value(), List{4});
    EXPECT_EQ(parse_expressions("0 (1 + 1) 2*sin(30 deg)").value(), (List{0, 2, 1}));
    EXPECT_EQ(parse_expressions("0,5").value(), (List{0, 5})) << "in a list a comma separates";
}

TEST(Expressions, name_the_entry_that_cannot_be_read) {
    EXPECT_EQ(parse_expressions("0, é, 1").error(),
              "entry 1: “é” cannot be read here; numbers, + - * / ^ and parentheses are allowed");
    EXPECT_EQ(parse_expressions("0,,1").error(), "entry 1: type a number, such as 0.5, 1/3 or sqrt(2)/2");
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
