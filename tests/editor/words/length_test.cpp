#include "app/editor/words/length.h"

#include <gtest/gtest.h>

#include <limits>

#include "app/editor/fields/expression.h"

namespace batten::editor {
namespace {

using core::LengthUnit;

const Units none;
const Units millimeters = core::DocumentUnits{.unit = LengthUnit::mm};
const Units inches_of_96 = core::DocumentUnits{.unit = LengthUnit::inch, .scale = 96.0};

TEST(Length, is_worded_in_the_unit) {
    EXPECT_EQ(length_words(none, 12.5), "12.5");
    EXPECT_EQ(length_words(millimeters, 12.5), "12.5 mm");
    EXPECT_EQ(length_words(inches_of_96, 48.0), "0.5 in");
    EXPECT_EQ(with_unit(core::DocumentUnits{.unit = LengthUnit::px}, "-3"), "-3 px");
    EXPECT_EQ(unit_ending(none), "");
    EXPECT_EQ(unit_ending(millimeters), " mm");
    EXPECT_EQ(in_units(inches_of_96, core::Point(96, -24)), core::Point(1, -0.25));
}

TEST(Length, in_a_message_has_15_digits) {
    EXPECT_EQ(length_words(none, 0.1 * 3.0), "0.3");
    EXPECT_EQ(length_words(millimeters, 0.10000000000000012), "0.1 mm");
    EXPECT_EQ(length_words(millimeters, -12345678.901234567), "-12345678.9012346 mm");
    EXPECT_EQ(length_words(millimeters, 1.0 / 3.0), "0.333333333333333 mm");
    EXPECT_EQ(area_words(millimeters, 0.1 * 3.0), "0.3 mm²");
    EXPECT_EQ(length_words(none, 1e300 / 3.0), "3.33333333333333e+299");
    EXPECT_EQ(length_words(none, 5e-324), "5e-324");
    // With 15 digits this would be more than there is.
    EXPECT_EQ(length_words(none, std::numeric_limits<double>::max()), "1.7976931348623157e+308");
    EXPECT_EQ(length_words(none, std::numeric_limits<double>::infinity()), "inf");
}

TEST(Length, of_any_power_is_in_units) {
    EXPECT_EQ(in_units(inches_of_96, 48.0, 1), 0.5);
    EXPECT_EQ(in_units(inches_of_96, 9216.0, 2), 1.0);
    EXPECT_EQ(in_units(inches_of_96, 0.25, -1), 24.0);
    EXPECT_EQ(in_units(inches_of_96, 0.25, 0), 0.25);
    EXPECT_EQ(in_units(none, 0.25, -1), 0.25);
    EXPECT_EQ(quantity_words(inches_of_96, 0.25, -1), "24");
}

TEST(Length, is_typed_in_any_unit) {
    EXPECT_EQ(parse_length("12.5mm", millimeters), 12.5);
    EXPECT_EQ(parse_length("12.5", millimeters), 12.5);
    EXPECT_EQ(parse_length("1in", millimeters), 25.4);
    EXPECT_EQ(parse_length("1 inch", millimeters), 25.4);
    EXPECT_EQ(parse_length("2 IN", millimeters), 50.8);
    EXPECT_EQ(parse_length("96px", millimeters), 25.4);
    EXPECT_EQ(parse_length("1/2 in", millimeters), 12.7);
    EXPECT_EQ(parse_length("sqrt(4)*1in + 5", millimeters), 55.8);
    EXPECT_EQ(parse_length("-(1in)", millimeters), -25.4);
    EXPECT_EQ(parse_length("(1in)/(1mm)", millimeters), 25.4);
    EXPECT_EQ(parse_length("1", inches_of_96), 96.0);
    EXPECT_EQ(parse_length("25.4mm", inches_of_96), 96.0);
    EXPECT_EQ(parse_length("3px", inches_of_96), 3.0);
}

TEST(Length, without_a_unit_is_a_plain_number) {
    EXPECT_EQ(parse_length("12.5", none), 12.5);
    EXPECT_EQ(parse_length("12.5mm", none).error(),
              "“mm” cannot be read here; only lengths of a document with a unit have one");
    EXPECT_FALSE(parse_expression("3px"));
    EXPECT_FALSE(parse_length("1in mm", millimeters));
    EXPECT_EQ(parse_length("1in*2mm", millimeters).error(),
              "a product has two units; parentheses are needed, as in (90 deg)/(30 deg)");
    EXPECT_FALSE(parse_length("1cm", millimeters));
    EXPECT_FALSE(parse_length("1e308", inches_of_96));
}

}  // namespace
}  // namespace batten::editor
