#include "app/editor/sketch.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace batten::editor {
namespace {

// Points (i, 0) for i from `first` to before `end`.
std::vector<core::Point> numbered(std::size_t first, std::size_t end) {
    std::vector<core::Point> points;
    for (std::size_t i = first; i < end; ++i) points.emplace_back(static_cast<double>(i), 0.0);
    return points;
}

TEST(Sketch, keeps_every_point_while_they_are_few) {
    Sketch sketch;
    sketch.add(numbered(0, 10));
    sketch.add(numbered(10, Sketch::most_points));
    EXPECT_EQ(sketch.points(), numbered(0, Sketch::most_points));
}

// 16,384 points in steps of 64 reach to 1,048,576; steps of 32 do not reach to a million.
TEST(Sketch, keeps_one_point_of_so_many_where_they_are_many) {
    Sketch whole;
    whole.add(numbered(0, 1'000'000));
    EXPECT_EQ(whole.points().size(), 15'625U);
    for (std::size_t k = 0; k < whole.points().size(); ++k)
        ASSERT_EQ(whole.points()[k].x, 64.0 * static_cast<double>(k));
    Sketch in_parts;
    for (std::size_t first = 0; first < 1'000'000; first += 1000) {
        in_parts.add(numbered(first, first + 1000));
        ASSERT_LE(in_parts.points().size(), Sketch::most_points);
        ASSERT_GE(in_parts.points().size(), std::min(first + 1000, Sketch::most_points / 2));
    }
    EXPECT_EQ(in_parts.points(), whole.points());
}

}  // namespace
}  // namespace batten::editor
