#include "render/clip.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace batten::render {
namespace {

const PixelBox box{{0.0, 0.0}, {10.0, 20.0}};

TEST(ClipSegment, keeps_what_lies_inside) {
    const auto part = clip_segment(box, {1, 1}, {9, 19});
    ASSERT_TRUE(part);
    EXPECT_EQ(part->first, 0.0);
    EXPECT_EQ(part->last, 1.0);
}

TEST(ClipSegment, cuts_both_ends) {
    const auto part = clip_segment(box, {-10, 5}, {30, 5});
    ASSERT_TRUE(part);
    EXPECT_DOUBLE_EQ(part->first, 0.25);
    EXPECT_DOUBLE_EQ(part->last, 0.5);
    const auto down = clip_segment(box, {5, 40}, {5, -10});
    ASSERT_TRUE(down);
    EXPECT_DOUBLE_EQ(down->first, 0.4);
    EXPECT_DOUBLE_EQ(down->last, 0.8);
}

TEST(ClipSegment, finds_nothing_outside) {
    EXPECT_FALSE(clip_segment(box, {11, 0}, {11, 20}));
    EXPECT_FALSE(clip_segment(box, {-1, 5}, {-9, 5}));
    EXPECT_FALSE(clip_segment(box, {-5, 19}, {2, 30}));
}

TEST(ClipPolygon, keeps_what_lies_inside) {
    const std::vector<glm::dvec2> triangle{{1, 1}, {9, 1}, {5, 9}};
    EXPECT_EQ(clip_polygon(box, triangle), triangle);
}

TEST(ClipPolygon, covers_the_rectangle_from_far_outside) {
    const auto polygon = clip_polygon(box, {{-1e7, -1e7}, {1e7, -1e7}, {1e7, 1e7}, {-1e7, 1e7}});
    ASSERT_EQ(polygon.size(), 4U);
    for (const glm::dvec2 corner : {glm::dvec2(0, 0), glm::dvec2(10, 0), glm::dvec2(10, 20), glm::dvec2(0, 20)}) {
        EXPECT_EQ(std::count(polygon.begin(), polygon.end(), corner), 1);
    }
}

TEST(ClipPolygon, finds_nothing_outside) {
    EXPECT_TRUE(clip_polygon(box, {{11, 0}, {20, 0}, {15, 30}}).empty());
}

}  // namespace
}  // namespace batten::render
