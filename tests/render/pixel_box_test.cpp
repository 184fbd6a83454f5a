#include "render/pixel_box.h"

#include <gtest/gtest.h>

#include <utility>

namespace batten::render {
namespace {

const PixelBox box{{10.0, 20.0}, {30.0, 50.0}};

TEST(PixelBox, lies_between_any_two_opposite_corners) {
    for (const auto& [a, b] :
         {std::pair(glm::dvec2(10, 20), glm::dvec2(30, 50)), {{30, 50}, {10, 20}}, {{10, 50}, {30, 20}}}) {
        EXPECT_EQ(PixelBox::between(a, b).lower_px, box.lower_px);
        EXPECT_EQ(PixelBox::between(a, b).upper_px, box.upper_px);
    }
}

TEST(PixelBox, contains_its_edges) {
    EXPECT_TRUE(box.contains({20.0, 30.0}));
    EXPECT_TRUE(box.contains(box.lower_px));
    EXPECT_TRUE(box.contains({30.0, 20.0}));
    EXPECT_FALSE(box.contains({9.5, 30.0}));
    EXPECT_FALSE(box.contains({20.0, 50.5}));
}

TEST(PixelBox, overlaps_what_shares_more_than_an_edge) {
    EXPECT_TRUE(box.overlaps(box));
    EXPECT_TRUE(box.overlaps({{29.0, 49.0}, {60.0, 60.0}}));
    EXPECT_TRUE(box.overlaps({{15.0, 0.0}, {16.0, 100.0}}));
    EXPECT_FALSE(box.overlaps({{30.0, 20.0}, {60.0, 50.0}})) << "side by side";
    EXPECT_FALSE(box.overlaps({{10.0, 51.0}, {30.0, 60.0}})) << "one below the other";
    EXPECT_FALSE(box.overlaps({{0.0, 0.0}, {9.0, 100.0}}));
}

}  // namespace
}  // namespace batten::render
