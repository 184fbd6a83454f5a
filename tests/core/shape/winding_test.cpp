#include "core/shape/winding.h"

#include <gtest/gtest.h>

#include "core/refine/reverse.h"
#include "tests/core/shape/shapes_to_combine.h"

namespace batten::core {
namespace {

TEST(Winding, of_a_circle_and_its_reverse) {
    const std::vector curves{disc({2, 1}, 3)};
    EXPECT_EQ(winding_number(curves, {2, 1}), 1);
    EXPECT_EQ(winding_number(curves, {4.99999999, 1}), 1);
    EXPECT_EQ(winding_number(curves, {5.00000001, 1}), 0);
    EXPECT_EQ(winding_number(curves, {-100, 1}), 0);
    EXPECT_EQ(winding_number(curves, {5, 1}), std::nullopt);
    EXPECT_EQ(winding_number(std::vector{reverse(curves[0]).value()}, {2, 1}), -1);
    EXPECT_EQ(winding_number(std::vector{curves[0], disc({2, 2}, 5)}, {2, 1}), 2);
}

// On the level of corners and sides a ray must not count them twice or never.
TEST(Winding, on_the_level_of_corners_and_sides) {
    const std::vector square{rectangle({0, 0}, {2, 2})};
    const std::vector diamond{closed_polygon({{1, 0}, {2, 1}, {1, 2}, {0, 1}})};
    EXPECT_EQ(winding_number(square, {-1, 0}), 0);
    EXPECT_EQ(winding_number(square, {-1, 2}), 0);
    EXPECT_EQ(winding_number(square, {0.5, 0.5}), 1);
    EXPECT_EQ(winding_number(diamond, {1, 1}), 1);
    EXPECT_EQ(winding_number(diamond, {-1, 1}), 0);
    EXPECT_EQ(winding_number(diamond, {0.25, 1}), 1);
    EXPECT_EQ(winding_number(square, {1, 0}), std::nullopt);
}

TEST(Winding, agrees_with_sums_of_angles) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int trial = 0; trial < 20; ++trial) {
        std::vector<double> radii(9);
        for (double& r : radii) r = 0.1 + unit(random);
        const std::vector curves{rounded({1e3, 5}, radii, 2), reverse(rounded({1e3 + 0.3, 5}, radii)).value()};
        for (int k = 0; k < 50; ++k) {
            const Point place{1e3 - 1 + 2 * unit(random), 4 + 2 * unit(random)};
            EXPECT_EQ(winding_number(curves, place), winding_of_samples(curves, place));
        }
    }
}

TEST(Winding, rules) {
    EXPECT_TRUE(is_inside(-1, InsideRule::even_odd));
    EXPECT_FALSE(is_inside(2, InsideRule::even_odd));
    EXPECT_TRUE(is_inside(2, InsideRule::non_zero));
    EXPECT_FALSE(is_inside(0, InsideRule::non_zero));
}

}  // namespace
}  // namespace batten::core
