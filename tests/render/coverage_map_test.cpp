#include "render/coverage_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace batten::render {
namespace {

constexpr glm::ivec2 size{200, 120};

double ink_of(const CoverageMap& map) {
    double sum = 0.0;
    for (const std::uint8_t value : map.values()) sum += value / 255.0;
    return sum;
}

TEST(CoverageMap, holds_as_much_ink_as_a_stroke_with_round_ends) {
    for (const double width : {1.5, 3.0, 11.0})
        for (int k = 0; k < 24; ++k) {
            const double angle = 0.1 + 2.0 * std::numbers::pi * k / 24.0;
            const glm::dvec2 middle(100.3, 60.7);
            const glm::dvec2 half = 40.0 * glm::dvec2(std::cos(angle), std::sin(angle));
            CoverageMap map(size);
            map.stroke(middle - half, middle + half, {.width_px = width});
            const double area = 80.0 * width + 0.25 * std::numbers::pi * width * width;
            EXPECT_NEAR(ink_of(map), area, 0.02 * area) << width << " " << angle;
        }
}

TEST(CoverageMap, covers_pixels_by_the_distance_of_their_centers) {
    CoverageMap map(size);
    map.stroke({20.0, 50.25}, {120.0, 50.25}, {.width_px = 3.0});
    // Rows whose centers are 0.25, 0.75, 1.25, 1.75 px from the line.
    EXPECT_EQ(map.coverage({60, 50}), 255);
    EXPECT_EQ(map.coverage({60, 49}), 255);
    EXPECT_EQ(map.coverage({60, 51}), 191);
    EXPECT_EQ(map.coverage({60, 48}), 64);
    EXPECT_EQ(map.coverage({60, 52}), 0);
    EXPECT_EQ(map.coverage({60, 47}), 0);
}

TEST(CoverageMap, keeps_the_largest_coverage_of_a_pixel) {
    CoverageMap once(size);
    once.stroke({10.0, 10.0}, {150.0, 90.0}, {.width_px = 3.0});
    CoverageMap often(size);
    for (int k = 0; k < 5; ++k) often.stroke({10.0, 10.0}, {150.0, 90.0}, {.width_px = 3.0});
    EXPECT_TRUE(std::equal(once.values().begin(), once.values().end(), often.values().begin()));
}

TEST(CoverageMap, breaks_lines_into_dashes_counted_from_their_beginning) {
    CoverageMap map(size);
    // Dashes from x = -13 to -7, from -2 to 4...
    map.stroke({-13.0, 50.5}, {220.0, 50.5}, {.width_px = 1.0, .dash_px = 6.0, .gap_px = 5.0});
    for (int x = 0; x < 200; ++x) {
        const double place = std::fmod(x + 0.5 + 13.0, 11.0);
        const bool is_in_gap = place > 7.0 && place < 10.0;
        if (is_in_gap || (place > 1.0 && place < 5.0)) {
            EXPECT_EQ(map.coverage({x, 50}), is_in_gap ? 0 : 255) << x;
        }
    }
}

TEST(CoverageMap, knows_what_is_covered) {
    CoverageMap map(size);
    EXPECT_FALSE(map.is_full({{50.0, 50.0}, {51.0, 51.0}}));
    map.stroke({0.0, 60.0}, {200.0, 60.0}, {.width_px = 41.0});
    EXPECT_TRUE(map.is_full({{0.0, 48.0}, {200.0, 71.0}}));
    EXPECT_TRUE(map.is_full({{-50.0, 50.0}, {300.0, 70.0}})) << "nothing is seen outside of the picture";
    EXPECT_FALSE(map.is_full({{50.0, 38.0}, {60.0, 60.0}}));
    EXPECT_TRUE(map.is_full({{-30.0, 10.0}, {-20.0, 20.0}}));
    EXPECT_TRUE(map.is_full_about({10.0, 60.0}, {190.0, 60.0}, 8.0));
    EXPECT_FALSE(map.is_full_about({10.0, 60.0}, {190.0, 60.0}, 22.0));
    EXPECT_FALSE(map.is_full_about({10.0, 60.0}, {100.0, 20.0}, 1.0));
    EXPECT_EQ(map.touched().lower.x, 0);
    EXPECT_LE(map.touched().lower.y, 39);
    EXPECT_GE(map.touched().upper.y, 81);
}

TEST(CoverageMap, hides_what_will_be_covered_and_paints_nothing_for_it) {
    CoverageMap above(size);
    above.stroke({0.0, 60.0}, {200.0, 60.0}, {.width_px = 41.0});
    CoverageMap below(size);
    below.hide_under(above);
    EXPECT_TRUE(below.is_full({{0.0, 48.0}, {200.0, 71.0}}));
    EXPECT_EQ(ink_of(below), 0.0);
    EXPECT_TRUE(below.touched().is_empty());
    below.stroke({100.0, 0.0}, {100.0, 120.0}, {.width_px = 3.0});
    EXPECT_EQ(below.coverage({100, 10}), 255);
    EXPECT_EQ(below.coverage({100, 60}), 0) << "left out";
}

TEST(CoverageMap, clears_a_box_in_whole_blocks) {
    CoverageMap map(size);
    map.stroke({0.0, 60.0}, {200.0, 60.0}, {.width_px = 200.0});
    const PixelRange cleared = map.clear({{50.0, 50.0}, {60.0, 60.0}});
    EXPECT_EQ(cleared.lower, glm::ivec2(48, 48));
    EXPECT_EQ(cleared.upper, glm::ivec2(64, 64));
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            EXPECT_EQ(map.coverage({x, y}), x >= 48 && x < 64 && y >= 48 && y < 64 ? 0 : 255);
    EXPECT_FALSE(map.is_full({{55.0, 55.0}, {56.0, 56.0}}));
    EXPECT_TRUE(map.is_full({{64.5, 20.0}, {100.0, 100.0}}));
    map.stroke({0.0, 60.0}, {200.0, 60.0}, {.width_px = 200.0});
    EXPECT_TRUE(map.is_full({{0.0, 0.0}, {200.0, 120.0}}));
    EXPECT_TRUE(map.clear({{-50.0, -50.0}, {-10.0, -10.0}}).is_empty());
}

TEST(CoverageMap, moves_by_whole_pixels) {
    const auto painted = [](glm::dvec2 by) {
        CoverageMap map(size);
        map.stroke(glm::dvec2(30.0, 40.3) + by, glm::dvec2(90.0, 70.0) + by, {.width_px = 25.0});
        return map;
    };
    const CoverageMap map = painted({0.0, 0.0});
    for (const glm::ivec2 by : {glm::ivec2(0, 0), {20, -13}, {-61, 5}, {3, 40}}) {
        const CoverageMap moved = map.shifted(by);
        const CoverageMap anew = painted(by);
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const glm::ivec2 before = glm::ivec2(x, y) - by;
                const bool was_seen = before.x >= 0 && before.y >= 0 && before.x < size.x && before.y < size.y;
                EXPECT_EQ(moved.coverage({x, y}), was_seen ? map.coverage(before) : 0);
                EXPECT_TRUE(!was_seen || !moved.is_full({{x, y}, {x, y}}) || anew.is_full({{x, y}, {x, y}}));
            }
    }
    EXPECT_TRUE(map.shifted({20, -13}).is_full({{78.0, 41.0}, {82.0, 43.0}}));
    EXPECT_TRUE(map.shifted({300, 0}).touched().is_empty());
}

TEST(CoverageMap, survives_places_of_any_size) {
    constexpr double huge = 1e30;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    CoverageMap map(size);
    map.stroke({-1e6, 50.5}, {1e6, 50.5}, {.width_px = 1.0, .dash_px = 6.0, .gap_px = 5.0});
    EXPECT_NEAR(ink_of(map), 200.0 * (6.0 + 0.785) / 11.0, 5.0) << "half discs at both ends of the dashes";
    map.stroke({-huge, 50.5}, {huge, 50.5}, {.width_px = 3.0, .dash_px = 6.0, .gap_px = 5.0});
    map.stroke({nan, 0.0}, {1.0, 1.0}, {.width_px = 3.0});
    map.stroke({-infinity, infinity}, {infinity, infinity}, {.width_px = 3.0});
    EXPECT_FALSE(map.is_full({{-infinity, -infinity}, {infinity, infinity}}));
    EXPECT_TRUE(map.is_full({{huge, huge}, {huge, huge}}));
    map.clear({{-infinity, -infinity}, {infinity, infinity}});
    EXPECT_EQ(ink_of(map), 0.0);
    CoverageMap nothing({0, 0});
    nothing.stroke({0.0, 0.0}, {1.0, 1.0}, {.width_px = 3.0});
    EXPECT_TRUE(nothing.is_full({{0.0, 0.0}, {1.0, 1.0}}));
}

TEST(CoverageMap, looks_at_a_segment_only_where_it_is_in_the_picture) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    CoverageMap map(size);
    map.stroke({-50.0, 60.0}, {250.0, 60.0}, {.width_px = 41.0});
    for (const double far : {1e3, 1e11, 1e18, 1e300}) {
        EXPECT_EQ(map.is_full_about({-far, 60.0}, {far, 60.0}, 2.5), far < 1e12) << far;
        EXPECT_FALSE(map.is_full_about({-far, 100.0}, {far, 100.0}, 2.5)) << far;
        EXPECT_TRUE(map.is_full_about({-far, 150.0}, {far, 150.0}, 2.5)) << far;
        EXPECT_FALSE(map.is_full_about({100.0, -far}, {100.0, far}, 2.5)) << far;
    }
    EXPECT_FALSE(map.is_full_about({-infinity, 100.0}, {infinity, 100.0}, 2.5));
    EXPECT_TRUE(map.is_full_about({100.0, 60.0}, {100.0, 60.0}, 2.5));
    EXPECT_FALSE(map.is_full_about({100.0, 95.0}, {100.0, 95.0}, 2.5));
}

TEST(CoverageMap, dashes_a_line_that_comes_from_far_away) {
    const InkStyle dashed{.width_px = 1.0, .dash_px = 6.0, .gap_px = 5.0};
    for (const double far : {1e3, 1e9, 1e12}) {
        CoverageMap map(size);
        map.stroke({-far, 50.5}, {210.0, 50.5}, dashed);
        EXPECT_NEAR(ink_of(map), 200.0 * (6.0 + 0.785) / 11.0, 5.0) << far;
    }
}

}  // namespace
}  // namespace batten::render
