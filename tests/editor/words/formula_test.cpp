#include "app/editor/words/formula.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace batten::editor {
namespace {

TEST(NumberText, has_the_digits_asked_for_and_no_trailing_zeros) {
    EXPECT_EQ(number_text(0.4), "0.4");
    EXPECT_EQ(number_text(1.0), "1");
    EXPECT_EQ(number_text(0.53333333, 3), "0.533");
    EXPECT_EQ(number_text(1.0 / 3.0), "0.3333");
    EXPECT_EQ(number_text(0.99999), "1");
    EXPECT_EQ(number_text(2.5e-4), "0.00025");
    EXPECT_EQ(number_text(1234.5678, 6), "1234.57");
}

TEST(NumberText, keeps_a_whole_part_and_turns_scientific_at_the_extremes) {
    EXPECT_EQ(number_text(123456.0), "123456");
    EXPECT_EQ(number_text(1e6), "1e6");
    EXPECT_EQ(number_text(1.5e12), "1.5e12");
    EXPECT_EQ(number_text(1e-12), "1e−12");
    EXPECT_EQ(number_text(9.999e-5, 2), "1e−4");
    EXPECT_EQ(number_text(12345678.0, 10), "12345678");
}

TEST(NumberText, writes_a_true_minus_and_no_negative_zero) {
    EXPECT_EQ(number_text(-2.5), "−2.5");
    EXPECT_EQ(number_text(-0.0), "0");
    EXPECT_EQ(number_text(-1e-12), "−1e−12");
}

TEST(NumberText, survives_what_is_not_finite) {
    EXPECT_EQ(number_text(std::numeric_limits<double>::infinity()), "∞");
    EXPECT_EQ(number_text(-std::numeric_limits<double>::infinity()), "−∞");
    EXPECT_EQ(number_text(std::nan("")), "nan");
}

TEST(BoundText, is_no_less_than_the_number) {
    EXPECT_EQ(bound_text(0.5), "0.5");
    EXPECT_EQ(bound_text(0.0), "0");
    EXPECT_EQ(bound_text(1.0 / 3.0), "0.3334");
    EXPECT_EQ(bound_text(2.0 / 3.0), "0.6667");
    EXPECT_EQ(bound_text(std::sqrt(2.0), 3), "1.42");
    EXPECT_EQ(bound_text(0.99991), "1");
    EXPECT_EQ(bound_text(9999.4), "10000");
    EXPECT_EQ(bound_text(33759.3), "33760");
    EXPECT_EQ(bound_text(999999.2), "1000000");
    EXPECT_EQ(bound_text(1.00001e12), "1.001e12");
    EXPECT_EQ(bound_text(1.2341e-17), "1.235e−17");
    EXPECT_EQ(bound_text(std::numeric_limits<double>::infinity()), "∞");
}

TEST(BoundText, takes_the_last_bits_for_rounding) {
    EXPECT_EQ(bound_text(5.0 * (1.0 + 1e-15)), "5");
    EXPECT_EQ(bound_text(5.0 * (1.0 + 1e-9)), "5.001");
}

TEST(FixedText, has_exactly_the_decimals_asked_for) {
    EXPECT_EQ(fixed_text(0.8, 3), "0.800");
    EXPECT_EQ(fixed_text(-3.2, 2), "−3.20");
    EXPECT_EQ(fixed_text(-0.001, 2), "0.00");
    EXPECT_EQ(fixed_text(1e300, 0).size(), 301U);
}

TEST(Formula, of_continuity) {
    EXPECT_EQ(continuity_text(2), "C^{2}");
    EXPECT_EQ(continuity_text(0), "C^{0}");
    EXPECT_EQ(continuity_text(-1), "jump");
}

TEST(PlainText, has_glyphs_for_digits_signs_and_commas) {
    EXPECT_EQ(plain_text("P_{12}^{3}"), "P₁₂³");
    EXPECT_EQ(plain_text("N_{2,3}(u)"), "N₂,₃(u)");
    EXPECT_EQ(plain_text("x^{−1}"), "x⁻¹");
}

TEST(PlainText, keeps_other_groups_in_parentheses_and_odd_text_as_it_is) {
    EXPECT_EQ(plain_text("C^{p−m}"), "C(p−m)");
    EXPECT_EQ(plain_text("a_b {c} ^"), "a_b {c} ^");
    EXPECT_EQ(plain_text("P_{3"), "P_{3");
    EXPECT_EQ(plain_text(""), "");
}

}  // namespace
}  // namespace batten::editor
