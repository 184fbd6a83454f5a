#include "app/editor/commands/arranging_commands.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/commands/array_commands.h"
#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/pin_commands.h"
#include "app/editor/commands/selected_curve_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/symmetry_commands.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/arc_length.h"
#include "core/measure/bounds.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

class ArrangingCommands : public ::testing::Test {
  protected:
    ArrangingCommands() { open_text(editor_, bezier_text); }
    const std::string& message() const { return editor_.state().message.text; }
    bool run(const Command& command) { return editor_.run(command); }
    core::Box box(std::size_t i) const { return core::tight_box(*document(editor_).curves[i].curve); }

    Editor editor_;
};

TEST_F(ArrangingCommands, align_selected_points) {
    run(SelectPoints{.points = {0, 1, 3}});
    EXPECT_TRUE(run(Align{.at = Alignment::left, .what = Arranged::points}));
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{0, 0}, {0, 2}, {3, 2}, {0, 0}}));
    EXPECT_EQ(message().rfind("Aligned what is selected at the left; the curve moved by at most ", 0), 0U) << message();
    EXPECT_TRUE(run(Undo{}));
    EXPECT_TRUE(run(Align{.at = Alignment::middle, .what = Arranged::points}));
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{0, 1}, {1, 1}, {3, 2}, {4, 1}}));
    EXPECT_TRUE(run(Undo{}));
    EXPECT_TRUE(run(Align{.at = Alignment::top, .what = Arranged::points}));
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{0, 2}, {1, 2}, {3, 2}, {4, 2}}));
    run(SelectPoints{.points = {1}});
    EXPECT_FALSE(run(Align{.at = Alignment::top, .what = Arranged::points}));
    EXPECT_EQ(message(), "at least 2 control points or curves must be selected that are not pinned, not 1");
}

// The arch rises to 3/2.
TEST_F(ArrangingCommands, align_curves_by_what_is_seen_of_them) {
    EXPECT_TRUE(run(DuplicateCurve{.index = 0, .shift = 10.0}));
    EXPECT_TRUE(run(Align{.at = Alignment::top, .what = Arranged::curves}));
    EXPECT_NEAR(box(1).upper.y, 1.5, 1e-14);
    EXPECT_NEAR(box(1).lower.x, 10.0, 1e-14);
    EXPECT_TRUE(run(Align{.at = Alignment::center, .what = Arranged::curves}));
    for (const std::size_t i : {0U, 1U}) EXPECT_NEAR(0.5 * (box(i).lower.x + box(i).upper.x), 7.0, 1e-14);
    run(SetCurveLocked{.index = 0, .locked = true});
    EXPECT_FALSE(run(Align{.at = Alignment::left, .what = Arranged::curves}));
    run(SetCurveVisible{.index = 0, .visible = false});
    EXPECT_FALSE(run(Align{.at = Alignment::left, .what = Arranged::curves}));
    EXPECT_EQ(message(), "at least 2 curves must be visible, not 1");
}

TEST_F(ArrangingCommands, distribute_keeps_the_outermost_and_the_order) {
    run(SelectPoints{.points = {0, 1, 2, 3}});
    EXPECT_TRUE(run(Distribute{.direction = Direction::horizontal, .what = Arranged::points}));
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(points(editor_)[i].x, 4.0 / 3.0 * static_cast<double>(i), 1e-15);
    EXPECT_EQ(points(editor_)[1].y, 2.0);
    EXPECT_EQ(points(editor_)[3], core::Point(4, 0));
}

TEST_F(ArrangingCommands, pinned_points_do_not_come_along) {
    run(PinPoints{.points = {3}});
    run(SelectPoints{.points = {0, 1, 3}});
    EXPECT_TRUE(run(Align{.at = Alignment::right, .what = Arranged::points}));
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{1, 0}, {1, 2}, {3, 2}, {4, 0}}));
}

TEST_F(ArrangingCommands, rows_and_rings_of_copies) {
    EXPECT_TRUE(run(LinearArray{.count = 3, .step = {5.0, 1.0}}));
    ASSERT_EQ(document(editor_).curves.size(), 3U);
    EXPECT_EQ(document(editor_).active, 0U);
    EXPECT_EQ(document(editor_).curves[2].name, "arch 3");
    EXPECT_EQ(document(editor_).curves[2].curve->control_points()[1], core::Point(11, 4));
    EXPECT_EQ(message(), "Made a row of 3 curves");
    EXPECT_TRUE(run(Undo{}));
    EXPECT_TRUE(run(PolarArray{.count = 4, .center = {0.0, 0.0}, .step = 90.0}));
    EXPECT_EQ(document(editor_).curves[1].curve->control_points()[1], core::Point(-2, 1));
    EXPECT_EQ(document(editor_).curves[2].curve->control_points()[1], core::Point(-1, -2));
    EXPECT_EQ(document(editor_).curves[3].curve->control_points()[1], core::Point(2, -1));
    EXPECT_TRUE(run(Undo{}));
    std::vector<core::Point> many;
    for (int i = 0; i <= 500; ++i) many.emplace_back(i, 0.0);
    run(NewCurve{.points = many});
    EXPECT_FALSE(run(LinearArray{.count = 10'000, .step = {5.0, 1.0}}));
    EXPECT_EQ(message(), "10000 times 501 control points are too many; at most 5000000 in all are allowed");
    EXPECT_FALSE(run(LinkRotation{.turns = 10'000, .center = {0.0, 0.0}}));
    EXPECT_FALSE(run(PolarArray{.count = 1, .center = {0.0, 0.0}, .step = 90.0}));
}

TEST_F(ArrangingCommands, rows_and_rings_of_all_curves_that_are_selected) {
    run(NewCurve{.points = {{0, 5}, {1, 5}}, .degree = 1});
    run(NewCurve{.points = {{9, 9}, {8, 9}}, .degree = 1});
    ASSERT_TRUE(run(SelectParts{.parts = "0 1"}));
    EXPECT_TRUE(run(LinearArray{.count = 3, .step = {5.0, 1.0}}));
    EXPECT_EQ(message(), "Made a row of 3 of each of 2 curves");
    ASSERT_EQ(document(editor_).curves.size(), 7U);
    EXPECT_EQ(document(editor_).curves[3].curve->control_points()[1], core::Point(6, 3));
    EXPECT_EQ(document(editor_).curves[4].curve->control_points()[1], core::Point(6, 6));
    EXPECT_EQ(document(editor_).curves[6].curve->control_points()[0], core::Point(10, 7));
    EXPECT_EQ(document(editor_).curves[6].name.rfind(document(editor_).curves[1].name, 0), 0U);
    EXPECT_TRUE(run(Undo{}));
    ASSERT_TRUE(run(SelectParts{.parts = "1 2"}));
    EXPECT_TRUE(run(PolarArray{.count = 2, .center = {0.0, 0.0}, .step = 90.0}));
    ASSERT_EQ(document(editor_).curves.size(), 5U);
    EXPECT_EQ(document(editor_).curves[3].curve->control_points()[1], core::Point(-5, 1));
    EXPECT_EQ(document(editor_).curves[4].curve->control_points()[1], core::Point(-9, 8));
    EXPECT_EQ(message(), "Made a ring of 2 of each of 2 curves");
}

TEST_F(ArrangingCommands, set_length_of_all_curves_that_are_selected) {
    run(NewCurve{.points = {{0, 5}, {1, 5}}, .degree = 1});
    run(NewCurve{.points = {{9, 9}, {9, 5}}, .degree = 1});
    ASSERT_TRUE(run(SelectParts{.parts = "1 2"}));
    EXPECT_TRUE(run(SetLength{.length = 2.0}));
    EXPECT_EQ(message().rfind("Set length of each of 2 curves to 2", 0), 0U) << message();
    EXPECT_EQ(document(editor_).curves[1].curve->control_points()[1], core::Point(2, 5));
    EXPECT_EQ(document(editor_).curves[2].curve->control_points()[1], core::Point(9, 7));
    EXPECT_TRUE(run(Undo{}));
    run(SetCurveLocked{.index = 1, .locked = true});
    run(ActivateCurve{.index = 1});
    EXPECT_FALSE(run(SetLength{.length = 2.0}));
}

TEST_F(ArrangingCommands, set_length_scales_about_the_first_point) {
    EXPECT_TRUE(run(SetLength{.length = 10.0}));
    EXPECT_NEAR(core::arc_length(curve(editor_)).value, 10.0, 1e-12);
    EXPECT_EQ(points(editor_)[0], core::Point(0, 0));
    EXPECT_NEAR(points(editor_)[1].y / points(editor_)[1].x, 2.0, 1e-14);
    EXPECT_FALSE(run(SetLength{.length = 0.0}));
    EXPECT_EQ(message(), "a length is 0; radii, axes and other lengths must be above 0");
}

TEST_F(ArrangingCommands, set_distance_moves_the_second_point_along_the_line) {
    EXPECT_TRUE(run(SetDistance{.from = 2, .to = 1, .distance = 5.0}));
    EXPECT_EQ(points(editor_)[1], core::Point(-2, 2));
    EXPECT_EQ(message().rfind("Moved P₁ to the distance 5 from P₂; ", 0), 0U) << message();
    EXPECT_FALSE(run(SetDistance{.from = 1, .to = 1, .distance = 5.0}));
    EXPECT_EQ(message(), "the two control points are one place; there is no direction between them");
}

}  // namespace
}  // namespace batten::editor
