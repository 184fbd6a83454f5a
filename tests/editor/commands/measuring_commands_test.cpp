#include "app/editor/commands/measuring_commands.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/commands/selection_commands.h"
#include "tests/editor/finding_fixture.h"

namespace batten::editor {
namespace {

// y = x^2 for x from 0 to 2; a triangle; a line.
constexpr const char* measures_text = R"({ "format": "batten", "version": 1, "curves": [
  { "name": "parabola", "degree": 2, "knots": [0,0,0,1,1,1], "points": [[0,0],[1,0],[2,4]] },
  { "name": "triangle", "degree": 1, "knots": [0,0,1,2,3,3], "points": [[0,0],[0,3],[6,0],[0,0]] },
  { "name": "line", "degree": 1, "knots": [0,0,1,1], "points": [[0,1],[2,1]] } ] })";

class MeasuringCommands : public FindingFixture {
  protected:
    void SetUp() override { open_text(editor_, measures_text); }
};

TEST_F(MeasuringCommands, arc_length_and_its_inverse) {
    ASSERT_TRUE(editor_.run(ActivateCurve{.index = 0}));
    const double whole = std::sqrt(17.0) + 0.25 * std::asinh(4.0);
    const double half = 0.5 * std::sqrt(5.0) + 0.25 * std::asinh(2.0);
    find(MeasureArcLength{.begin = 0.0, .end = 1.0});
    EXPECT_NEAR(number(0, "length"), whole, 1e-13);
    EXPECT_LE(number(0, "error"), 1e-12);
    EXPECT_EQ(state().message.text, "parabola has the length 4.64678376243294");
    find(MeasureArcLength{.begin = 0.5, .end = 1.0});
    EXPECT_NEAR(number(0, "length"), whole - half, 1e-13);
    find(FindPointAtLength{.length = half});
    EXPECT_NEAR(rows()[0].parameter.value(), 0.5, 1e-13);
    EXPECT_NEAR(number(0, "point y"), 1.0, 1e-13);
}

TEST_F(MeasuringCommands, area_of_a_figure_of_eight_says_what_cancels) {
    open_text(editor_, R"({ "format": "batten", "version": 1, "curves": [
      { "name": "eight", "degree": 1, "knots": [0,0,1,2,3,4,4], "points": [[0,0],[2,2],[2,0],[0,2],[0,0]] } ] })");
    find(MeasureArea{});
    EXPECT_EQ(number(0, "area"), 0.0);
    EXPECT_EQ(state().message.text, "eight encloses the area 0, as parts to its left and to its right cancel");
}

TEST_F(MeasuringCommands, arc_length_says_where_the_curve_ends) {
    ASSERT_TRUE(editor_.run(ActivateCurve{.index = 2}));
    find(MeasureArcLength{.begin = -1.0, .end = 3.0});
    EXPECT_EQ(number(0, "length"), 2.0);
    EXPECT_EQ(rows()[0].note,
              "u = -1 is outside the domain from 0 to 1; its end 0 is taken; u = 3 is outside the domain from 0 to 1; "
              "its end 1 is taken");
    find(MeasureArcLength{.begin = 0.5, .end = 1.0});
    EXPECT_EQ(rows()[0].note, "");
}

TEST_F(MeasuringCommands, point_beyond_an_end_is_said_to_be_the_end) {
    ASSERT_TRUE(editor_.run(ActivateCurve{.index = 0}));
    const double whole = std::sqrt(17.0) + 0.25 * std::asinh(4.0);
    find(FindPointAtLength{.length = 7.5});
    EXPECT_EQ(rows()[0].parameter, 1.0);
    EXPECT_NEAR(number(0, "length"), whole, 1e-13);
    EXPECT_EQ(state().message.text, "parabola ends at the length 4.64678376243294, at u = 1: 7.5 is beyond it");
    find(FindPointAtLength{.length = -2.0});
    EXPECT_EQ(rows()[0].parameter, 0.0);
    EXPECT_EQ(number(0, "length"), 0.0);
    EXPECT_EQ(state().message.text, "parabola begins at the length 0, at u = 0: -2 is before it");
}

TEST_F(MeasuringCommands, what_is_too_large_for_a_number_is_refused) {
    open_text(editor_, R"({ "format": "batten", "version": 1, "curves": [
      { "name": "huge", "degree": 1, "knots": [0,0,1,2,3,3], "points": [[0,0],[1e200,0],[0,1e200],[0,0]] } ] })");
    EXPECT_EQ(
        refused(MeasureArea{}),
        "area of huge cannot be computed: its points, weights or knots are too far apart, too large or too small");
    EXPECT_FALSE(state().findings.has_value());
    find(MeasureArcLength{.begin = 0.0, .end = 3.0});
    EXPECT_NEAR(number(0, "length") / 1e200, 2.0 + std::sqrt(2.0), 1e-14);
}

TEST_F(MeasuringCommands, area_of_closed_curves_only) {
    ASSERT_TRUE(editor_.run(ActivateCurve{.index = 1}));
    find(MeasureArea{});
    EXPECT_NEAR(number(0, "area"), -9.0, 1e-13);
    EXPECT_EQ(rows()[0].label, "area -9");
    EXPECT_NEAR(rows()[0].point->x, 2.0, 1e-13);
    EXPECT_EQ(rows()[0].note, "negative: the curve runs clockwise");
    ASSERT_TRUE(editor_.run(ActivateCurve{.index = 0}));
    EXPECT_EQ(refused(MeasureArea{}), "the curve is not closed; its ends must meet and it must have no gaps");
}

TEST_F(MeasuringCommands, nearest_point_and_evaluation) {
    ASSERT_TRUE(editor_.run(ActivateCurve{.index = 1}));
    find(FindNearest{.position = {-1.0, 1.5}});
    EXPECT_NEAR(number(0, "distance"), 1.0, 1e-15);
    EXPECT_NEAR(rows()[0].parameter.value(), 0.5, 1e-15);
    find(Evaluate{.u = 1.0});
    ASSERT_EQ(rows().size(), 2U);
    EXPECT_EQ(rows()[0].label, "left of u = 1");
    EXPECT_EQ(number(0, "C' y"), 3.0);
    EXPECT_EQ(number(1, "C' x"), 6.0);
    ASSERT_TRUE(editor_.run(ActivateCurve{.index = 0}));
    find(Evaluate{.u = 0.5});
    ASSERT_EQ(rows().size(), 1U);
    EXPECT_EQ(number(0, "C x"), 1.0);
    EXPECT_EQ(number(0, "C'' y"), 8.0);
    EXPECT_NEAR(number(0, "curvature"), 2.0 / std::pow(5.0, 1.5), 1e-15);
}

TEST_F(MeasuringCommands, intersections_with_lines_and_curves) {
    ASSERT_TRUE(editor_.run(ActivateCurve{.index = 1}));
    find(IntersectLine{.first = {0.0, 1.0}, .second = {1.0, 1.0}});
    ASSERT_EQ(rows().size(), 2U);
    EXPECT_NEAR(number(0, "along"), 0.0, 1e-15);
    EXPECT_NEAR(number(1, "along"), 4.0, 1e-14);
    EXPECT_EQ(state().message.text, "triangle crosses the line 2 times, its polygon 2 times");
    find(IntersectSegment{.first = {-1.0, 1.0}, .second = {1.0, 1.0}});
    ASSERT_EQ(rows().size(), 1U);
    EXPECT_EQ(rows()[0].label, "crosses");
    EXPECT_EQ(refused(IntersectLine{.first = {1.0, 1.0}, .second = {1.0, 1.0}}),
              "point 1 lies on point 0; the two must differ");
    ASSERT_TRUE(editor_.run(ActivateCurve{.index = 0}));
    find(IntersectCurve{.other = "line"});
    ASSERT_EQ(rows().size(), 1U);
    EXPECT_NEAR(rows()[0].parameter.value(), 0.5, 1e-15);
    EXPECT_NEAR(number(0, "other u"), 0.5, 1e-15);
    EXPECT_EQ(state().message.text, "parabola meets line 1 time");
    EXPECT_EQ(refused(IntersectCurve{.other = "parabola"}),
              "'parabola' is the active curve itself; name another one, or use self-intersections");
    EXPECT_FALSE(editor_.run(IntersectCurve{.other = "nobody"}));
}

}  // namespace
}  // namespace batten::editor
