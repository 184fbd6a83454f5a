#include "render/region_cover.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace batten::render {
namespace {

using Loop = std::vector<glm::vec2>;

Loop rectangle(glm::vec2 lower, glm::vec2 upper) {
    return {lower, {upper.x, lower.y}, upper, {lower.x, upper.y}};
}

double covered_area(const CoverageMap& map) {
    return std::accumulate(map.values().begin(), map.values().end(), 0.0) / 255.0;
}

TEST(RegionCover, of_a_rectangle_between_pixels) {
    const CoverageMap map = region_coverage({{rectangle({1.5F, 1.0F}, {4.25F, 3.5F})}}, {8, 6});
    EXPECT_EQ(map.coverage({1, 1}), 128);
    EXPECT_EQ(map.coverage({2, 1}), 255);
    EXPECT_EQ(map.coverage({4, 2}), 64);
    EXPECT_EQ(map.coverage({2, 3}), 128);
    EXPECT_EQ(map.coverage({5, 2}), 0);
    EXPECT_EQ(map.coverage({2, 4}), 0);
    EXPECT_EQ(map.touched().lower, glm::ivec2(1, 1));
    EXPECT_EQ(map.touched().upper, glm::ivec2(5, 4));
    EXPECT_NEAR(covered_area(map), 2.75 * 2.5, 0.02);
}

TEST(RegionCover, of_a_concave_loop_and_one_that_leaves_the_picture) {
    const Loop arrow{{0, 0}, {40, 20}, {0, 40}, {20, 20}};
    EXPECT_NEAR(covered_area(region_coverage({{arrow}}, {50, 50})), 400.0, 0.5);
    EXPECT_EQ(region_coverage({{arrow}}, {50, 50}).coverage({10, 20}), 0);
    const Loop large = rectangle({-1e6F, -1e6F}, {1e6F, 20.0F});
    EXPECT_NEAR(covered_area(region_coverage({{large}}, {50, 50})), 1000.0, 1e-9);
}

// A pentagram: the inner pentagon is run round twice.
TEST(RegionCover, follows_its_rule) {
    Loop star;
    for (int k = 0; k < 5; ++k) {
        const double angle = 0.8 * std::numbers::pi * k + 0.1;
        star.emplace_back(100 + 90 * std::cos(angle), 100 + 90 * std::sin(angle));
    }
    const double inner = std::cos(0.4 * std::numbers::pi) / std::cos(0.2 * std::numbers::pi);
    const double whole = 8100 * 5 * inner * std::sin(0.2 * std::numbers::pi);
    const double pentagon = 8100 * 2.5 * inner * inner * std::sin(0.4 * std::numbers::pi);
    EXPECT_NEAR(covered_area(region_coverage({{star}, FillRule::non_zero}, {200, 200})), whole, 2.0);
    EXPECT_NEAR(covered_area(region_coverage({{star}, FillRule::even_odd}, {200, 200})), whole - pentagon, 2.0);
    // A hole runs the other way.
    Loop hole = rectangle({50, 50}, {100, 100});
    const Loop outer = rectangle({0, 0}, {150, 150});
    EXPECT_NEAR(covered_area(region_coverage({{outer, hole}}, {200, 200})), 22500.0, 1e-9);
    std::reverse(hole.begin(), hole.end());
    EXPECT_NEAR(covered_area(region_coverage({{outer, hole}}, {200, 200})), 20000.0, 1e-9);
}

TEST(RegionCover, of_nothing) {
    EXPECT_TRUE(region_coverage({}, {10, 10}).touched().is_empty());
    EXPECT_TRUE(region_coverage({{Loop{}, Loop{{1, 1}}, Loop{{1, 1}, {5, 5}}}}, {10, 10}).touched().is_empty());
    EXPECT_EQ(region_coverage({{rectangle({0, 0}, {5, 5})}}, {0, 0}).size_px(), glm::ivec2(0, 0));
}

}  // namespace
}  // namespace batten::render
