#include "app/editor/words/field_number.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace batten::editor {
namespace {

std::size_t letters(const std::string& text) {
    std::size_t count = 0;
    for (const char c : text) count += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1 : 0;
    return count;
}

/// In a field for seven letters, as the table of control points has.
std::string in_seven(double value, const FieldDigits& digits) {
    return field_number(value, digits, [](const std::string& text) { return letters(text) <= 7; });
}

TEST(FieldNumber, has_the_decimals_of_its_column) {
    const FieldDigits digits{.decimals = 3, .most_decimals = 4, .extent = 5.0};
    EXPECT_EQ(in_seven(0.0, digits), "0.000");
    EXPECT_EQ(in_seven(1.25, digits), "1.250");
    EXPECT_EQ(in_seven(-2.0 / 3.0, digits), "−0.667");
    EXPECT_EQ(in_seven(12345.678, digits), "12345.7");
}

TEST(FieldNumber, tiny_coordinates_are_not_shown_as_zeros) {
    // A curve of 4e-6, of which nine decimals are four digits, in a column that has room for four decimals.
    const FieldDigits digits{.decimals = 9, .most_decimals = 4, .extent = 4e-6};
    EXPECT_EQ(in_seven(1.2612e-7, digits), "1.26e−7");
    EXPECT_EQ(in_seven(-4e-6, digits), "−4e−6");
    EXPECT_EQ(in_seven(1e-12, digits), "1e−12");
    EXPECT_EQ(in_seven(1.5e-11, digits), "1.5e−11");
    EXPECT_EQ(in_seven(0.0, digits), "0.0000");
    EXPECT_EQ(in_seven(1e-17, digits), "0.0000") << "rounding";
}

TEST(FieldNumber, digits_go_by_magnitude_where_the_column_has_no_room_for_decimals) {
    const FieldDigits digits{.decimals = 6, .most_decimals = 4, .extent = 0.004};
    EXPECT_EQ(in_seven(0.00126, digits), "0.00126");
    EXPECT_EQ(in_seven(0.00127, digits), "0.00127");
    EXPECT_EQ(in_seven(0.0020, digits), "0.0020");
}

TEST(FieldNumber, a_narrow_field_has_a_decimal_rather_than_a_power_of_ten) {
    const auto in_four = [](const std::string& text) { return letters(text) <= 4; };
    const FieldDigits digits{.decimals = 3, .most_decimals = 1, .extent = 2.0};
    EXPECT_EQ(field_number(-0.5385, digits, in_four), "−0.5");
    EXPECT_EQ(field_number(0.5385, digits, in_four), "0.54");
    EXPECT_EQ(field_number(2.0, digits, in_four), "2.0");
}

TEST(FieldNumber, a_small_number_beside_large_ones_keeps_three_digits) {
    const FieldDigits digits{.decimals = 2, .extent = 10.0};
    EXPECT_EQ(in_seven(0.00126, digits), "0.00126");
    EXPECT_EQ(in_seven(0.09, digits), "0.09");
    EXPECT_EQ(in_seven(0.3 - 0.1 - 0.2, digits), "0.00");
}

TEST(FieldNumber, far_from_zero_it_shows_the_digits_by_which_neighbors_differ) {
    const FieldDigits digits{.decimals = 3, .most_decimals = 0, .extent = 4.0};
    EXPECT_EQ(in_seven(100000000.125, digits), "…00.125");
    EXPECT_EQ(in_seven(100000003.0, digits), "…03.000");
    EXPECT_EQ(in_seven(99999999.5, digits), "…99.500");
    EXPECT_EQ(in_seven(-100000002.345, digits), "−…02.34");
    const FieldDigits hundreds{.decimals = 1, .most_decimals = 0, .extent = 400.0};
    EXPECT_EQ(in_seven(5500123.46, hundreds), "5500123");
    EXPECT_EQ(in_seven(55500123.46, hundreds), "…0123.5");
}

TEST(FieldNumber, what_is_large_all_over_has_few_digits_and_a_power_of_ten) {
    const FieldDigits digits{.decimals = 0, .most_decimals = 0, .extent = 1e9};
    EXPECT_EQ(in_seven(123456789.0, digits), "1.235e8");
    EXPECT_EQ(in_seven(-1234567890.0, digits), "−1.23e9");
    const FieldDigits far{.decimals = 0, .most_decimals = 0, .extent = 5e6};
    EXPECT_EQ(in_seven(1e14, far), "1e14") << "no room for the digits that differ";
    EXPECT_EQ(in_seven(std::numeric_limits<double>::max(), digits), "1.8e308");
}

TEST(FieldNumber, factors_have_as_many_digits_when_small) {
    const FieldDigits digits{.decimals = 2, .most_decimals = 4, .is_factor = true};
    EXPECT_EQ(in_seven(1.0, digits), "1.00");
    EXPECT_EQ(in_seven(0.0125, digits), "0.0125");
    EXPECT_EQ(in_seven(1e6, digits), "1e6");
}

}  // namespace
}  // namespace batten::editor
