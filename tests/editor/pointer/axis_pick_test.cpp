#include "app/editor/pointer/axis_pick.h"

#include <gtest/gtest.h>

#include "app/editor/commands/axis_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/file_commands.h"
#include "app/editor/commands/help_commands.h"
#include "app/editor/commands/selected_curve_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/tool_commands.h"
#include "tests/editor/canvas_fixture.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

using test::px;

class AxisPicking : public test::CanvasFixture {
  protected:
    const std::vector<core::DocumentCurve>& curves() const { return state().history.present().curves; }
    core::Point image(std::size_t curve, std::size_t i) const { return curves()[curve].curve->control_points()[i]; }
};

TEST_F(AxisPicking, mirrors_in_the_line_through_two_clicks) {
    editor.run(PickMirror{});
    EXPECT_EQ(state().message.text, "Click two points of the axis · Escape gives up");
    pointer.move(px(5, -3));
    pointer.click(px(5, -3));
    EXPECT_EQ(steps(), 0U);
    pointer.move(px(5, 1));
    EXPECT_EQ(state().active_curve()->control_points()[0], core::Point(14, -2)) << "previewed";
    pointer.click(px(5, 1));
    EXPECT_EQ(point(0), core::Point(14, -2));
    EXPECT_EQ(point(4), core::Point(6, -2));
    EXPECT_EQ(steps(), 1U);
    EXPECT_FALSE(state().axis_pick);
}

TEST_F(AxisPicking, says_that_an_axis_needs_two_points) {
    editor.run(PickMirror{});
    pointer.click(px(5, -3));
    pointer.click(px(5, -3));
    EXPECT_TRUE(state().message.is_error);
    EXPECT_EQ(state().message.text, "an axis leads through two points; click another one than the first");
    ASSERT_TRUE(state().axis_pick);
    EXPECT_EQ(state().axis_pick->first, core::Point(5, -3));
    EXPECT_EQ(steps(), 0U);
    pointer.click(px(5, 1));
    EXPECT_EQ(point(0), core::Point(14, -2));
}

TEST_F(AxisPicking, snaps_to_points_and_mirrors_only_what_is_selected) {
    editor.run(SelectPoints{.points = {2}});
    editor.run(PickMirror{});
    pointer.click(px(-1.97, 1.98));
    pointer.click(px(2.03, 1.97));  // through P1 and P3
    EXPECT_EQ(point(2), core::Point(0, 6));
    EXPECT_EQ(point(0), core::Point(-4, -2));
}

TEST_F(AxisPicking, links_a_mirror_image_with_or_without_a_corner) {
    // Through the first point (-4, -2), from which the curve leaves aslant: the next one is (-2, 2).
    const core::Point next = point(1);
    for (const bool is_smooth : {false, true}) {
        EXPECT_TRUE(run_typed(editor, is_smooth ? "pick-link-mirror yes" : "pick-link-mirror no"));
        pointer.click(px(point(0).x, -5));
        pointer.click(px(point(0).x, 5));
        ASSERT_EQ(curves().size(), 2U);
        EXPECT_EQ(point(1), is_smooth ? core::Point(next.x, point(0).y) : next);
        EXPECT_EQ(state().message.text.find("turned") != std::string::npos, is_smooth) << state().message.text;
        ASSERT_TRUE(editor.run(Undo{}));
    }
}

TEST_F(AxisPicking, links_a_mirror_image) {
    editor.run(PickLinkMirror{.is_smooth = true});
    pointer.click(px(5, 0));
    pointer.move(px(5, 3));
    EXPECT_EQ(state().shown().curves.size(), 2U);
    EXPECT_EQ(curves().size(), 1U);
    pointer.click(px(5, 3));
    ASSERT_EQ(curves().size(), 2U);
    EXPECT_EQ(image(1, 0), core::Point(14, -2));
    ASSERT_TRUE(curves()[1].symmetry);
    EXPECT_EQ(curves()[1].symmetry->angle, 90.0);
    EXPECT_EQ(steps(), 1U);
}

TEST_F(AxisPicking, links_rotated_images_around_one_click) {
    EXPECT_TRUE(run_typed(editor, "pick-link-rotation 4"));
    pointer.move(px(0, -5));
    EXPECT_EQ(state().shown().curves.size(), 4U);
    pointer.click(px(0, -5));
    ASSERT_EQ(curves().size(), 4U);
    EXPECT_EQ(curves()[1].symmetry->center, core::Point(0, -5));
    EXPECT_EQ(image(2, 0), core::Point(4, -8)) << "half a turn";
    EXPECT_FALSE(state().axis_pick);
}

TEST_F(AxisPicking, makes_a_ring_around_one_click) {
    EXPECT_TRUE(run_typed(editor, "pick-array-polar 4"));
    pointer.click(px(0, -5));
    ASSERT_EQ(curves().size(), 4U);
    EXPECT_EQ(image(1, 0), core::Point(-3, -9)) << "a quarter counterclockwise";
    EXPECT_FALSE(curves()[1].symmetry);
}

TEST_F(AxisPicking, is_given_up_by_escape) {
    editor.run(PickMirror{});
    pointer.click(px(5, -3));
    pointer.move(px(5, 1));
    EXPECT_TRUE(state().preview);
    EXPECT_TRUE(run_typed(editor, "escape"));
    EXPECT_FALSE(state().axis_pick);
    EXPECT_FALSE(state().preview);
    EXPECT_EQ(steps(), 0U);
    pointer.click(px(5, 1));
    EXPECT_EQ(steps(), 0U);
}

TEST_F(AxisPicking, takes_the_first_click_back_and_then_gives_up) {
    editor.run(SelectPoints{.points = {3}});
    editor.run(PickMirror{});
    pointer.click(px(5, -3));
    EXPECT_TRUE(listens_to_drawing_keys(pointer.mode(), state()));
    pointer.send(PointerAction::take_back, {0, 0});
    ASSERT_TRUE(state().axis_pick);
    EXPECT_FALSE(state().axis_pick->first);
    pointer.send(PointerAction::take_back, {0, 0});
    EXPECT_FALSE(state().axis_pick);
    EXPECT_FALSE(listens_to_drawing_keys(pointer.mode(), state())) << "now they are about the document";
    EXPECT_EQ(steps(), 0U);
}

TEST_F(AxisPicking, is_given_up_for_a_tool_or_another_document) {
    for (const Tool tool : {Tool::select, Tool::pencil}) {
        editor.run(PickMirror{});
        pointer.click(px(5, -3));
        pointer.move(px(5, 1));
        ASSERT_TRUE(state().preview);
        editor.run(SetTool{.tool = tool});
        EXPECT_FALSE(state().axis_pick);
        EXPECT_FALSE(state().preview);
        EXPECT_EQ(state().tool, tool);
    }
    editor.run(PickMirror{});
    editor.run(NewDocument{});
    editor.run(AnswerUnsaved{.answer = UnsavedAnswer::discard});
    ASSERT_EQ(state().active_curve(), nullptr);
    EXPECT_FALSE(state().axis_pick);
}

TEST_F(AxisPicking, shows_no_result_while_the_pointer_is_elsewhere) {
    pointer.move(px(-2, 2));
    ASSERT_EQ(state().hover, Hover(HoveredPoint{1}));
    editor.run(PickMirror{});
    pointer.click(px(5, -3));
    pointer.move(px(5, 1));
    EXPECT_EQ(state().hover, Hover(HoveredNothing{}));
    ASSERT_TRUE(state().preview);
    pointer.send(PointerAction::leave, px(5, 1));
    EXPECT_FALSE(state().preview);
    pointer.move(px(5, 1));
    EXPECT_TRUE(state().preview);
}

TEST_F(AxisPicking, shows_nothing_before_the_click_where_all_that_is_selected_is_long) {
    std::vector<core::Point> many;
    for (int i = 0; i < 15'000; ++i) many.emplace_back(1e-3 * i, 50.0);
    editor.run(NewCurve{.points = many, .degree = 1});
    editor.run(ActivateCurve{.index = 0});
    editor.run(PickArrayPolar{.count = 2});
    pointer.move(px(5, 1));
    EXPECT_TRUE(state().preview) << "of the active curve alone";
    pointer.send(PointerAction::take_back, {0, 0});
    editor.run(SelectParts{.parts = "0 1"});
    editor.run(PickArrayPolar{.count = 2});
    pointer.move(px(5, 1));
    EXPECT_FALSE(state().preview) << "30 010 points of two curves";
    pointer.click(px(5, 1));
    EXPECT_EQ(document(editor).curves.size(), 4U);
}

TEST_F(AxisPicking, two_clicks_at_one_place_are_no_axis) {
    editor.run(PickMirror{});
    pointer.click(px(5, -3));
    pointer.click(px(5, -3));
    EXPECT_EQ(steps(), 0U);
    EXPECT_TRUE(state().axis_pick);
    EXPECT_FALSE(canvas_hint(pointer.mode(), state()).empty());
}

}  // namespace
}  // namespace batten::editor
