#include "core/measure/deviation.h"

#include <gtest/gtest.h>

#include "core/refine/knot_insertion.h"
#include "tests/core/random_curves.h"

namespace batten::core {
namespace {

Curve line(Point a, Point b, Interval domain = {0.0, 1.0}) {
    return Curve::make(
               {.degree = 1, .knots = {domain.lower, domain.lower, domain.upper, domain.upper}, .points = {a, b}})
        .value();
}

TEST(Deviation, curve_does_not_deviate_from_itself) {
    RandomCurves random(51);
    for (int i = 0; i < 30; ++i) {
        const Curve curve = random.curve();
        EXPECT_EQ(largest_deviation(curve, curve), 0.0);
    }
}

TEST(Deviation, moved_curve_deviates_by_the_offset) {
    EXPECT_DOUBLE_EQ(largest_deviation(line({0, 0}, {4, 0}), line({3, 4}, {7, 4})), 5.0);
}

TEST(Deviation, moved_end_is_seen) {
    EXPECT_DOUBLE_EQ(largest_deviation(line({0, 0}, {1, 0}), line({0, 0}, {1, 2})), 2.0);
    EXPECT_DOUBLE_EQ(largest_deviation(line({0, 0}, {1, 0}), line({0, -3}, {1, 0})), 3.0);
}

TEST(Deviation, domains_are_matched_affinely) {
    EXPECT_NEAR(largest_deviation(line({0, 0}, {1, 0}), line({0, 0}, {1, 0}, {-7.0, 19.0})), 0.0, 1e-15);
}

TEST(Deviation, parabola_is_a_quarter_of_its_middle_point_away_from_the_chord) {
    const Curve chord =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {1, 0}, {2, 0}}}).value();
    const Curve parabola =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {1, 3}, {2, 0}}}).value();
    EXPECT_DOUBLE_EQ(largest_deviation(chord, parabola), 1.5);
}

TEST(Deviation, is_the_same_from_both_sides) {
    RandomCurves random(52);
    for (int i = 0; i < 30; ++i) {
        const Curve a = random.curve();
        const Curve b = random.curve();
        EXPECT_EQ(largest_deviation(a, b), largest_deviation(b, a));
    }
}

TEST(Deviation, narrow_bump_of_either_curve_is_seen) {
    const Curve flat = line({0, 0}, {1, 0});
    const Curve bump = Curve::make({.degree = 1,
                                    .knots = {0, 0, 0.5, 0.5001, 0.5002, 1, 1},
                                    .points = {{0, 0}, {0.5, 0}, {0.5001, 9}, {0.5002, 0}, {1, 0}}})
                           .value();
    EXPECT_NEAR(largest_deviation(flat, bump), 9.0, 1e-12);
    EXPECT_NEAR(largest_deviation(bump, flat), 9.0, 1e-12);
}

TEST(Deviation, inserted_knot_shows_rounding_only) {
    RandomCurves random(53);
    for (int i = 0; i < 30; ++i) {
        const Curve curve = random.curve();
        const auto refined = insert_midpoint_knots(curve);
        ASSERT_TRUE(refined.has_value());
        EXPECT_LT(largest_deviation(curve, *refined), 8.0 * 1e-13);
    }
}

}  // namespace
}  // namespace batten::core
