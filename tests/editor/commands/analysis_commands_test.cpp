#include "app/editor/commands/analysis_commands.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/commands/measuring_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "tests/editor/finding_fixture.h"

namespace batten::editor {
namespace {

// Two cubics with legs of lengths 1 and 2 along one line at their joint; (t^2, t^3 - t), which passes (1, 0) twice;
// (t^2, t^3).
constexpr const char* shapes_text = R"({ "format": "batten", "version": 1, "curves": [
  { "name": "joint", "degree": 3, "knots": [0,0,0,0,0.5,0.5,0.5,1,1,1,1],
    "points": [[0,0],[1,2],[2,1],[3,1],[5,1],[6,3],[7,0]] },
  { "name": "loop", "degree": 3, "knots": [0,0,0,0,1,1,1,1],
    "points": [[2.25,-1.875],[-0.75,3.875],[-0.75,-3.875],[2.25,1.875]] },
  { "name": "cusp", "degree": 3, "knots": [0,0,0,0,1,1,1,1], "points": [[0,0],[1,1],[0,1],[1,0]] },
  { "name": "valley", "degree": 2, "knots": [0,0,0,1,1,1], "points": [[-2,4],[1,-8],[4,16]], "locked": true } ] })";

class AnalysisCommands : public FindingFixture {
  protected:
    void SetUp() override { open_text(editor_, shapes_text); }
    void find_in(std::size_t index, const Command& command) {
        ASSERT_TRUE(editor_.run(ActivateCurve{.index = index}));
        find(command);
    }
};

TEST_F(AnalysisCommands, continuity_by_knots_and_by_shape) {
    find_in(0, FindContinuity{});
    ASSERT_EQ(rows().size(), 1U);
    EXPECT_EQ(rows()[0].label, "knot 0.5");
    EXPECT_EQ(rows()[0].note, "C⁰ by its knots, G¹ by its shape");
    EXPECT_EQ(number(0, "multiplicity"), 3.0);
    EXPECT_NEAR(number(0, "relative jump of C'"), 0.5, 1e-14);
    EXPECT_NEAR(number(0, "curvature before"), 2.0 / 3.0, 1e-14);
    EXPECT_EQ(state().message.text, "joint has 1 joint; 1 smoother by shape than by the knots");
}

TEST_F(AnalysisCommands, inflections_and_curvature_extrema) {
    find_in(3, FindInflections{});
    EXPECT_TRUE(rows().empty());
    EXPECT_EQ(state().message.text, "valley has no inflections");
    find_in(3, FindCurvatureExtrema{});
    ASSERT_EQ(rows().size(), 1U);
    EXPECT_EQ(rows()[0].label, "maximum");
    EXPECT_NEAR(rows()[0].parameter.value(), 1.0 / 3.0, 1e-12);
    EXPECT_NEAR(number(0, "curvature"), 2.0, 1e-10);
    EXPECT_NEAR(number(0, "radius"), 0.5, 1e-10);
    find_in(0, FindInflections{});
    EXPECT_EQ(rows().size(), 2U);
}

TEST_F(AnalysisCommands, cusps_and_double_points) {
    find_in(2, FindCusps{});
    ASSERT_EQ(rows().size(), 1U);
    EXPECT_EQ(rows()[0].label, "cusp");
    EXPECT_EQ(rows()[0].parameter, 0.5);
    EXPECT_NEAR(std::abs(number(0, "turn in degrees")), 180.0, 1e-9);
    EXPECT_EQ(state().message.text, "cusp has 1 cusp");
    find_in(1, FindSelfIntersections{});
    ASSERT_EQ(rows().size(), 1U);
    EXPECT_NEAR(rows()[0].parameter.value(), 1.0 / 6.0, 1e-12);
    EXPECT_NEAR(number(0, "second u"), 5.0 / 6.0, 1e-12);
    EXPECT_NEAR(rows()[0].point->x, 1.0, 1e-12);
}

TEST_F(AnalysisCommands, bounds_and_hulls) {
    find_in(3, FindBounds{});
    ASSERT_EQ(rows().size(), 2U);
    EXPECT_NEAR(number(0, "bottom"), 0.0, 1e-14);
    EXPECT_EQ(number(0, "top"), 16.0);
    EXPECT_EQ(number(1, "bottom"), -8.0);
    EXPECT_EQ(state().message.text, "valley is 6 wide and 16 high");
    find_in(0, FindSpanHulls{});
    ASSERT_EQ(rows().size(), 2U);
    EXPECT_EQ(number(0, "corner 1 x"), 0.0);
    EXPECT_EQ(number(1, "from"), 0.5);
}

TEST_F(AnalysisCommands, need_a_curve) {
    Editor empty;
    for (const Command& command : std::vector<Command>{
             FindContinuity{}, FindInflections{}, FindCurvatureExtrema{}, FindCusps{}, FindSelfIntersections{},
             FindBounds{}, FindSpanHulls{}, MeasureArea{}, Evaluate{.u = 0.5}, IntersectCurve{.other = "line"}})
        EXPECT_FALSE(empty.run(command)) << command.spec().name;
}

}  // namespace
}  // namespace batten::editor
