#include "app/editor/scene/pen.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

constexpr glm::dvec2 picture_size{800.0, 600.0};
constexpr Stroke dashed{.color = {1, 2, 3, 255}, .width = 1.5, .dash = 6.0, .gap = 5.0};

std::vector<render::Polyline> lines(const std::vector<glm::dvec2>& points, const Stroke& stroke, double scale = 1.0) {
    render::DrawList list;
    Pen(list, picture_size, scale).line(points, stroke);
    return test::all_of<render::Polyline>(list);
}

TEST(Pen, line_inside_of_the_picture_stays_one_line) {
    const auto found = lines({{10, 10}, {20, 30}, {700, 500}}, dashed, 2.0);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].points, (std::vector<render::Pixel>{{10, 10}, {20, 30}, {700, 500}}));
    EXPECT_FLOAT_EQ(found[0].width_px, 3.0F);
    EXPECT_FLOAT_EQ(found[0].dash_px, 12.0F);
    EXPECT_FLOAT_EQ(found[0].gap_px, 10.0F);
}

TEST(Pen, line_that_leaves_and_returns_becomes_two) {
    const auto found = lines({{100, 100}, {100, 5000}, {300, 5000}, {300, 100}}, dashed);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].points.front(), render::Pixel(100, 100));
    EXPECT_EQ(found[1].points.back(), render::Pixel(300, 100));
    for (const auto& line : found)
        for (const auto place : line.points) EXPECT_LT(place.y, 600.0F + 65.0F + 11.0F);
}

TEST(Pen, dashes_count_from_the_true_beginning_of_the_line) {
    const auto found = lines({{-100003.0, 300.0}, {400.0, 300.0}}, dashed);
    ASSERT_EQ(found.size(), 1U);
    const double periods = (found[0].points.front().x + 100003.0) / 11.0;
    EXPECT_NEAR(periods, std::round(periods), 1e-3);
    EXPECT_LT(found[0].points.front().x, -64.0F + 0.01F) << "at most a period before what is seen";
    EXPECT_GT(found[0].points.front().x, -64.0F - 11.01F);
}

TEST(Pen, line_through_the_picture_between_huge_ends_passes_where_it_should) {
    const auto found = lines({{-1e15, -1e15 + 100.0}, {1e15, 1e15 + 100.0}}, {.color = {}, .width = 1.0});
    ASSERT_EQ(found.size(), 1U);
    for (const auto place : found[0].points) EXPECT_NEAR(place.y - place.x, 100.0, 1.0);
}

TEST(Pen, what_is_far_away_is_left_out) {
    render::DrawList list;
    Pen pen(list, picture_size, 1.0);
    pen.symbol({1e9, 10.0}, {.fill = {}, .outline = {}});
    pen.text({10.0, -1e300}, "far", {.color = {}});
    pen.segment({1e9, 0.0}, {1e9, 500.0}, dashed);
    pen.fill({{1e9, 0.0}, {2e9, 0.0}, {1e9, 1e9}}, {});
    EXPECT_TRUE(list.commands.empty());
}

TEST(Pen, fill_larger_than_the_picture_is_cut) {
    render::DrawList list;
    Pen pen(list, picture_size, 1.0);
    pen.fill({{-1e30, -1e30}, {1e30, -1e30}, {1e30, 1e30}, {-1e30, 1e30}}, {});
    ASSERT_EQ(list.commands.size(), 1U);
    EXPECT_EQ(test::faults_of(list, picture_size, 64.5), std::vector<std::string>{});
}

TEST(Pen, clears_the_texts_that_reach_into_a_box_and_nothing_else) {
    render::DrawList list;
    Pen pen(list, picture_size, 1.0);
    pen.segment({0, 0}, {100, 100}, dashed);
    // Ten letters of 10 pixels are some 50 wide: to the right of 100, to the left of it, and on both sides.
    const std::string text = "ten letter";
    for (const auto anchor : {render::Anchor::left, render::Anchor::right, render::Anchor::center})
        pen.text({100, 50}, text, {.color = dashed.color, .size = 10.0, .anchor = anchor});
    pen.text({100, 80}, text, {.color = dashed.color, .size = 10.0});
    pen.clear_texts({{110, 40}, {140, 60}});
    const auto left = test::all_of<render::Label>(list);
    ASSERT_EQ(left.size(), 2U);
    EXPECT_EQ(left[0].anchor, render::Anchor::right);
    EXPECT_EQ(left[1].position, render::Pixel(100, 80));
    EXPECT_EQ(test::all_of<render::Polyline>(list).size(), 1U);
}

}  // namespace
}  // namespace batten::editor
