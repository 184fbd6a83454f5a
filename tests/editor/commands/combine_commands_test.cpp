#include "app/editor/commands/combine_commands.h"

#include <gtest/gtest.h>

#include <numbers>

#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "core/measure/area.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

// Two squares of side 2 that have the unit square (1, 1) to (2, 2) in common, an open line, and a far square.
constexpr const char* squares = R"({ "format": "batten", "version": 1, "curves": [
  { "name": "a", "degree": 1, "knots": [0,0,1,2,3,4,4], "points": [[0,0],[2,0],[2,2],[0,2],[0,0]], "color": "#ff0000" },
  { "name": "line", "degree": 1, "knots": [0,0,1,1], "points": [[0,0],[9,9]] },
  { "name": "b", "degree": 1, "knots": [0,0,1,2,3,4,4], "points": [[1,1],[3,1],[3,3],[1,3],[1,1]] },
  { "name": "far", "degree": 1, "knots": [0,0,1,2,3,4,4], "points": [[5,5],[6,5],[6,6],[5,6],[5,5]], "visible": false } ] })";

class CombineCommands : public ::testing::Test {
  protected:
    CombineCommands() { open_text(editor_, squares); }
    const core::Document& document() const { return editor_.state().history.present(); }
    const std::string& message() const { return editor_.state().message.text; }
    double area(std::size_t i) const { return core::enclosed_area(*document().curves[i].curve)->signed_area; }

    Editor editor_;
};

TEST_F(CombineCommands, union_takes_all_visible_closed_curves) {
    EXPECT_TRUE(editor_.run(Unite{}));
    ASSERT_EQ(document().curves.size(), 3U);
    EXPECT_EQ(document().curves[0].name, "a");
    EXPECT_TRUE(document().curves[0].color.has_value());
    EXPECT_EQ(document().curves[1].name, "line");
    EXPECT_EQ(document().curves[2].name, "far");
    EXPECT_NEAR(area(0), 7.0, 1e-14);
    EXPECT_EQ(document().active, 0U);
    EXPECT_EQ(message(), "Made the union; one closed curve encloses the area 7");
    EXPECT_EQ(editor_.state().history.undo_label(), "Union");
    EXPECT_TRUE(editor_.run(Undo{}));
    EXPECT_EQ(document().curves.size(), 4U);
}

TEST_F(CombineCommands, difference_intersection_and_exclusion) {
    EXPECT_TRUE(editor_.run(Subtract{.others = "b"}));
    EXPECT_NEAR(area(0), 3.0, 1e-14);
    EXPECT_TRUE(editor_.run(Undo{}));
    EXPECT_TRUE(editor_.run(IntersectShapes{.others = "b"}));
    EXPECT_NEAR(area(0), 1.0, 1e-14);
    EXPECT_TRUE(editor_.run(Undo{}));
    EXPECT_TRUE(editor_.run(ExcludeShapes{.others = "b"}));
    ASSERT_EQ(document().curves.size(), 4U);
    EXPECT_NEAR(area(0) + area(1), 6.0, 1e-14);
    EXPECT_EQ(document().curves[1].name, "a 2");
    EXPECT_EQ(message(), "Made the exclusion; 2 closed curves enclose the area 6");
}

TEST_F(CombineCommands, the_active_curve_may_come_after_the_others) {
    EXPECT_TRUE(editor_.run(ActivateCurve{.index = 2}));
    EXPECT_TRUE(run_typed(editor_, "difference a"));
    ASSERT_EQ(document().curves.size(), 3U);
    EXPECT_EQ(document().active, 1U);
    EXPECT_EQ(document().active_curve()->name, "b");
    EXPECT_NEAR(area(1), 3.0, 1e-14);
}

TEST_F(CombineCommands, several_others_are_named_with_commas) {
    EXPECT_TRUE(editor_.run(Unite{.others = "b, far"}));
    ASSERT_EQ(document().curves.size(), 3U);
    EXPECT_NEAR(area(0) + area(1), 8.0, 1e-14);
    EXPECT_EQ(message(), "Made the union; 2 closed curves enclose the area 8");
}

TEST_F(CombineCommands, say_what_cannot_be_combined) {
    EXPECT_FALSE(editor_.run(Subtract{.others = "line"}));
    EXPECT_EQ(message(), "'line' is not closed and encloses nothing; its ends must meet");
    EXPECT_FALSE(editor_.run(Subtract{.others = "a"}));
    EXPECT_EQ(message(), "'a' is the active curve; name another one");
    EXPECT_FALSE(editor_.run(IntersectShapes{.others = "far"}));
    EXPECT_EQ(message(), "nothing would be left of 'a'");
    EXPECT_FALSE(editor_.run(Unite{.others = "b, nobody"}));
    EXPECT_EQ(message(), "there is no curve 'nobody'; there are 'a', 'line', 'b', 'far', with the numbers 0 to 3");
    EXPECT_TRUE(editor_.run(ActivateCurve{.index = 1}));
    EXPECT_FALSE(editor_.run(Unite{}));
    EXPECT_EQ(message(), "'line' is not closed and encloses nothing; its ends must meet");
}

// A triangle with a quarter of it run through twice: the centroid of the signed area lies elsewhere.
TEST_F(CombineCommands, centroid_counts_each_place_once) {
    open_text(editor_, R"({ "format": "batten", "version": 1, "curves": [
      { "name": "t", "degree": 1, "knots": [0,0,1,2,3,4,5,6,6],
        "points": [[0,0],[6,0],[0,6],[0,0],[3,0],[0,3],[0,0]] } ] })");
    EXPECT_TRUE(editor_.run(FindCentroid{}));
    ASSERT_TRUE(editor_.state().findings.has_value());
    const Finding& row = editor_.state().findings->rows[0];
    EXPECT_NEAR(row.point->x, 2.0, 1e-14);
    EXPECT_NEAR(row.point->y, 2.0, 1e-14);
    EXPECT_NEAR(row.numbers[0].value, 18.0, 1e-13);
    EXPECT_TRUE(editor_.run(FindCentroid{.rule = core::InsideRule::even_odd}));
    // 18 * 2 - 4.5 * 1 over 13.5
    EXPECT_NEAR(editor_.state().findings->rows[0].point->x, 31.5 / 13.5, 1e-14);
}

}  // namespace
}  // namespace batten::editor
