#include "app/editor/pointer/selection_press.h"

#include <gtest/gtest.h>

#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/group_commands.h"
#include "app/editor/commands/overlay_commands.h"
#include "app/editor/commands/selected_curve_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/transform_commands.h"
#include "tests/editor/canvas_fixture.h"

namespace batten::editor {
namespace {

using test::ctrl;
using test::px;
using test::shift;
using Points = std::vector<core::Point>;

/// The zigzag is curve 0 and active; above it a line of three points is curve 1, below it one of two is curve 2.
class SelectionPress : public test::CanvasFixture {
  protected:
    SelectionPress() {
        editor.run(NewCurve{.points = {{-4, 3.5}, {0, 3.5}, {4, 3.5}}, .degree = 1});
        editor.run(NewCurve{.points = {{-4, -4}, {4, -4}}, .degree = 1});
        editor.run(ActivateCurve{.index = 0});
        first_steps = state().history.undo_count();
    }

    std::string selected() const { return text_of_parts(selected_parts(state())); }
    Points points_of(std::size_t curve) const {
        const auto all = state().history.present().curves[curve].curve->control_points();
        return {all.begin(), all.end()};
    }
    void click_with(Modifiers modifiers, glm::dvec2 at) {
        pointer.modifiers = modifiers;
        pointer.move(at);
        pointer.click(at);
        pointer.modifiers = {};
    }
    void drag_with(Modifiers modifiers, glm::dvec2 from, glm::dvec2 to) {
        pointer.modifiers = modifiers;
        pointer.drag(from, to);
        pointer.modifiers = {};
    }
};

TEST_F(SelectionPress, a_plain_box_is_about_the_active_curve_and_one_with_ctrl_about_all) {
    pointer.drag(px(-5, 4), px(-1, -4.2));
    EXPECT_EQ(selected(), "0:0,1");
    drag_with(ctrl, px(-5, 4), px(-1, -4.2));
    EXPECT_EQ(selected(), "0:0,1 1:0 2:0");
    drag_with(ctrl, px(-5, 4.3), px(5, 3));
    EXPECT_EQ(selected(), "1") << "all of a curve is the curve";
    drag_with({true, true, false}, px(3.5, -1.5), px(4.5, -4.3));
    EXPECT_EQ(selected(), "0:4 1 2:1") << "with Shift beside what was selected";
    drag_with(shift, px(1.5, 1.5), px(2.5, 2.5));
    EXPECT_EQ(selected(), "0:3,4 1 2:1");
    pointer.drag(px(-5, 1), px(-1, 3));
    EXPECT_EQ(selected(), "0:1");
    EXPECT_EQ(steps(), 0U);
}

TEST_F(SelectionPress, hidden_and_locked_curves_are_in_no_box) {
    editor.run(SetCurveLocked{.index = 1, .locked = true});
    editor.run(SetCurveVisible{.index = 2, .visible = false});
    drag_with(ctrl, px(-5, 4.3), px(5, -4.3));
    EXPECT_EQ(selected(), "0");
    click_with(shift, px(2, 3.5));
    EXPECT_EQ(selected(), "0");
    EXPECT_EQ(state().message.text, "curve 'curve 2' is locked; unlock it in the inspector");
}

TEST_F(SelectionPress, shift_click_takes_curves_in_and_out) {
    click_with(shift, px(2, 3.5));
    EXPECT_EQ(selected(), "0 1") << "beside the active curve, which a click chose";
    click_with(shift, px(0, -4));
    EXPECT_EQ(selected(), "0 1 2");
    click_with(shift, px(2, 3.5));
    EXPECT_EQ(selected(), "0 2");
    const core::Point on_active = {-2.9, 0.0};
    static_cast<void>(on_active);
    click_with({}, px(3, 3.5));
    EXPECT_EQ(state().history.present().active, 1U);
    EXPECT_EQ(selected(), "") << "a plain click activates";
}

TEST_F(SelectionPress, a_curve_that_goes_while_it_is_pressed_is_not_taken) {
    pointer.modifiers = shift;
    pointer.press(px(0, -4));
    editor.run(Undo{});
    ASSERT_EQ(state().history.present().curves.size(), 2U);
    pointer.release(px(0, -4));
    EXPECT_EQ(selected(), "");
    EXPECT_FALSE(state().message.is_error);
}

TEST_F(SelectionPress, a_group_is_taken_in_and_out_as_one) {
    editor.run(GroupCurves{.name = "lines", .curves = {1, 2}});
    click_with(shift, px(2, 3.5));
    EXPECT_EQ(selected(), "0 1 2");
    click_with(shift, px(2, -4));
    EXPECT_EQ(selected(), "0");
}

TEST_F(SelectionPress, any_selected_point_drags_all_as_one_step) {
    editor.run(SelectParts{.parts = "0:1 1:2 2"});
    pointer.press(px(-2, 2));
    pointer.move(px(-1.7, 2.1));
    EXPECT_EQ(points_of(1)[2], core::Point(4, 3.5)) << "committed";
    EXPECT_TRUE(state().preview.has_value());
    EXPECT_EQ(state().selection.others.size(), 2U);
    pointer.move(px(-1.5, 2.25));
    pointer.release(px(-1.5, 2.25));
    EXPECT_EQ(point(1), core::Point(-1.5, 2.25));
    EXPECT_EQ(point(0), core::Point(-4, -2));
    EXPECT_EQ(points_of(1), (Points{{-4, 3.5}, {0, 3.5}, {4.5, 3.75}}));
    EXPECT_EQ(points_of(2), (Points{{-3.5, -3.75}, {4.5, -3.75}}));
    EXPECT_EQ(steps(), 1U);
    EXPECT_EQ(selected(), "0:1 1:2 2");
    pointer.drag(px(4.5, 3.75), px(4, 3.5));
    EXPECT_EQ(points_of(1)[2], core::Point(4, 3.5)) << "by the point of the other curve";
    EXPECT_EQ(point(1), core::Point(-2, 2));
    editor.run(Undo{});
    editor.run(Undo{});
    EXPECT_EQ(*test::committed(editor).control_points().begin(), core::Point(-4, -2));
    EXPECT_EQ(points_of(2)[0], core::Point(-4, -4));
}

TEST_F(SelectionPress, a_drag_makes_only_what_moves_anew) {
    editor.run(SelectParts{.parts = "0:1 2"});
    pointer.press(px(-2, 2));
    pointer.move(px(-1.5, 2.25));
    ASSERT_TRUE(state().preview.has_value());
    const auto& before = state().history.present().curves;
    EXPECT_EQ(state().preview->curves[1].curve, before[1].curve);
    EXPECT_NE(state().preview->curves[0].curve, before[0].curve);
    EXPECT_NE(state().preview->curves[2].curve, before[2].curve);
    pointer.escape(px(-1.5, 2.25));
    EXPECT_EQ(steps(), 0U);
}

TEST_F(SelectionPress, a_selected_curve_drags_all_and_escape_restores) {
    editor.run(SelectParts{.parts = "0 1"});
    pointer.drag(px(2, 3.5), px(2.5, 3));
    EXPECT_EQ(points_of(1)[0], core::Point(-3.5, 3));
    EXPECT_EQ(point(0), core::Point(-3.5, -2.5));
    EXPECT_EQ(points_of(2)[0], core::Point(-4, -4));
    pointer.press(px(2.5, 3));
    pointer.move(px(0, 0));
    pointer.escape(px(0, 0));
    EXPECT_FALSE(state().preview.has_value());
    EXPECT_EQ(steps(), 1U);
    EXPECT_EQ(selected(), "0 1");
}

TEST_F(SelectionPress, clicks_on_points_of_several_curves) {
    editor.run(SelectParts{.parts = "0:1 1:2"});
    click_with(shift, px(0, 3.5));
    EXPECT_EQ(selected(), "0:1 1:1,2") << "points of a curve in the selection are shown";
    click_with(shift, px(0, -2));
    EXPECT_EQ(selected(), "0:1,2 1:1,2");
    click_with(shift, px(4, 3.5));
    EXPECT_EQ(selected(), "0:1,2 1:1");
    click_with(shift, px(0, -2));
    EXPECT_EQ(selected(), "0:1 1:1");
    click_with({}, px(0, 3.5));
    EXPECT_EQ(state().history.present().active, 1U);
    EXPECT_EQ(selected(), "1:1") << "a plain click selects it alone";
    editor.run(SelectParts{.parts = "1:1 0:2"});
    click_with({}, px(4, 3.5));
    EXPECT_EQ(selected(), "1:2");
    click_with({}, px(0, 0.9));
    EXPECT_EQ(selected(), "");
}

TEST_F(SelectionPress, points_of_polygons_that_are_shown_are_taken_and_dragged) {
    editor.run(ToggleOverlay<Overlay::other_polygons>{});
    pointer.move(px(0, 3.5));
    EXPECT_EQ(canvas_hint(pointer.mode(), state()), "Drag P₁ of 'curve 2' to move it · Shift-click selects it, too");
    click_with(shift, px(0, 3.5));
    EXPECT_EQ(selected(), "1:1");
    click_with(shift, px(4, -4));
    EXPECT_EQ(selected(), "1:1 2:1");
    editor.run(SelectNone{});
    pointer.drag(px(0, 3.5), px(0.5, 3.75));
    EXPECT_EQ(points_of(1)[1], core::Point(0.5, 3.75));
    EXPECT_EQ(state().history.present().active, 1U);
    EXPECT_EQ(selected(), "1:1");
    EXPECT_EQ(steps(), 1U);
}

TEST_F(SelectionPress, what_is_dragged_does_not_snap_to_itself) {
    editor.run(NewCurve{.points = {{-4, 3.5}, {-4, 4}}, .degree = 1});
    editor.run(SelectParts{.parts = "1 3:0"});
    pointer.press(px(-4, 3.5));
    // Its end stood 1 pixel away.
    pointer.move(px(-4, 3.5) + glm::dvec2(4, 0));
    pointer.release(px(-4, 3.5) + glm::dvec2(4, 0));
    EXPECT_NE(points_of(1)[0], core::Point(-4, 3.5));
}

TEST_F(SelectionPress, the_hint_tells_what_a_drag_moves) {
    editor.run(SelectParts{.parts = "0 1"});
    pointer.move(px(2, 3.5));
    EXPECT_EQ(canvas_hint(pointer.mode(), state()),
              "Drag to move all that is selected · Shift-click takes 'curve 2' out");
    pointer.move(px(2, -4));
    EXPECT_EQ(canvas_hint(pointer.mode(), state()),
              "Click to make 'curve 3' the active curve · Shift-click selects it, too");
}

// 0.3 + 2 is 2.3 and 2.3 - 0.3 is 1.9999999999999998, so that the others would not come to 2.
TEST_F(SelectionPress, a_typed_way_is_that_of_all_that_is_dragged) {
    editor.run(NewCurve{.points = {{0.3, 2.5}, {0.1, 3}, {0.0, 3.5}}, .degree = 1});
    editor.run(SelectParts{.parts = "1:1 3"});
    pointer.press(px(0.3, 2.5));
    pointer.move(px(0.8, 2.5));
    type(U"x2\t0\n", px(0.8, 2.5));
    EXPECT_EQ(points_of(3), (Points{{2.3, 2.5}, {2.1, 3}, {2, 3.5}}));
    EXPECT_EQ(points_of(1)[1], core::Point(2, 3.5));
    ASSERT_NE(editor.log().back().as<Move>(), nullptr);
    EXPECT_EQ(editor.log().back().as<Move>()->offset, core::Vector(2, 0));
}

}  // namespace
}  // namespace batten::editor
