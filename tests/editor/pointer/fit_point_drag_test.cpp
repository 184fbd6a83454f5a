#include "app/editor/pointer/fit_point_drag.h"

#include <gtest/gtest.h>

#include "app/editor/commands/drawing_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/fit_point_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/tool_commands.h"
#include "app/editor/pointer/hit_test.h"
#include "core/evaluate/evaluate.h"
#include "core/make/through_points.h"
#include "tests/editor/canvas_fixture.h"

namespace batten::editor {
namespace {

using test::committed;
using test::px;

class FitPointDrag : public test::CanvasFixture {
  protected:
    FitPointDrag() {
        editor.run(ThroughPoints{.points = {{-4, 0}, {-1, 2}, {1, -1}, {4, 1}}});
        first_steps = editor.state().history.undo_count();
    }
    const core::FitPoints& fit() const { return *committed_fit(state()); }
    core::Point place(std::size_t i) const { return fit().points[i].place; }
};

TEST_F(FitPointDrag, fit_points_are_hit_and_control_points_are_not) {
    EXPECT_EQ(hit_canvas(state(), px(-1, 2)), Hover{HoveredFitPoint{1}});
    EXPECT_EQ(hit_canvas(state(), px(4, 1)), Hover{HoveredFitPoint{3}});
    const core::Point control = committed(editor).control_points()[2];
    EXPECT_FALSE(std::holds_alternative<HoveredPoint>(hit_canvas(state(), px(control.x, control.y))));
    editor.run(ThroughPoints{.points = {{-4, 0}, {-1, 2}, {1, -1}, {4, 1}}, .closed = true});
    EXPECT_EQ(hit_canvas(state(), px(-4, 0)), Hover{HoveredFitPoint{0}});
    EXPECT_EQ(hit_canvas(state(), px(4, 1)), Hover{HoveredFitPoint{3}});
}

TEST_F(FitPointDrag, a_point_follows_the_pointer) {
    pointer.press(px(-1, 2));
    EXPECT_EQ(state().selection.fit_point, 1U);
    pointer.move(px(-1, 3));
    EXPECT_EQ(state().shown().active_curve()->fit->points[1].place, core::Point(-1, 3));
    EXPECT_EQ(place(1), core::Point(-1, 2));
    pointer.release(px(-1, 3));
    EXPECT_EQ(place(1), core::Point(-1, 3));
    EXPECT_EQ(steps(), 1U);
    EXPECT_EQ(core::through_points(fit()).value(), committed(editor));
    pointer.press(px(1, -1));
    pointer.move(px(2, 2));
    pointer.escape(px(2, 2));
    EXPECT_EQ(place(2), core::Point(1, -1));
    EXPECT_FALSE(state().preview);
}

TEST_F(FitPointDrag, delete_takes_out_the_point_that_was_clicked) {
    pointer.click(px(1, -1));
    editor.run(Delete{});
    ASSERT_EQ(fit().points.size(), 3U);
    EXPECT_EQ(place(2), core::Point(4, 1));
}

TEST_F(FitPointDrag, a_double_click_on_the_curve_puts_in_a_point_there) {
    const double u = 0.5 * (fit().parameters[1] + fit().parameters[2]);
    const core::Point at = core::point_at(committed(editor), u);
    pointer.double_click(px(at.x, at.y));
    ASSERT_EQ(fit().points.size(), 5U);
    EXPECT_LT(core::distance(place(2), at), 1e-9);
    EXPECT_EQ(state().selection.fit_point, 2U);
    EXPECT_EQ(steps(), 1U);
}

TEST_F(FitPointDrag, a_drag_of_the_curve_pulls_out_a_new_point) {
    const double u = 0.5 * (fit().parameters[1] + fit().parameters[2]);
    const core::Point at = core::point_at(committed(editor), u);
    pointer.drag(px(at.x, at.y), px(at.x + 1, at.y + 1));
    ASSERT_EQ(fit().points.size(), 5U);
    EXPECT_LT(core::distance(place(2), at + core::Vector(1, 1)), 1e-9);
    EXPECT_EQ(steps(), 1U);
    pointer.click(px(at.x - 1, at.y - 1));
    EXPECT_EQ(steps(), 1U);
}

TEST_F(FitPointDrag, a_double_click_on_a_point_makes_a_corner_and_takes_it_away) {
    pointer.double_click(px(-1, 2));
    EXPECT_EQ(fit().points[1].joint, core::FitJoint::corner);
    pointer.double_click(px(-1, 2));
    EXPECT_EQ(fit().points[1].joint, core::FitJoint::smooth);
}

TEST_F(FitPointDrag, handles_turn_the_tangent) {
    editor.run(SetFitJoint{.index = 1, .joint = core::FitJoint::tangent, .handle = core::Vector(2, 0)});
    EXPECT_EQ(hit_canvas(state(), px(1, 2)), (Hover{HoveredFitHandle{1, HandleEnd::ahead}}));
    EXPECT_EQ(hit_canvas(state(), px(-3, 2)), (Hover{HoveredFitHandle{1, HandleEnd::behind}}));
    pointer.drag(px(1, 2), px(1, 3));
    EXPECT_EQ(fit().points[1].handle, core::Vector(2, 1));
    pointer.drag(px(-3, 1), px(-2, 2));
    EXPECT_EQ(fit().points[1].handle, core::Vector(1, 0));
    EXPECT_EQ(steps(), 3U);
    // Pulled onto its own point it would have no direction.
    pointer.drag(px(0, 2), px(-1, 2));
    EXPECT_EQ(fit().points[1].handle, core::Vector(1, 0));
}

TEST_F(FitPointDrag, the_tool_for_points_puts_in_fit_points) {
    editor.run(SetTool{.tool = Tool::add_point});
    pointer.click(px(6, 1));
    ASSERT_EQ(fit().points.size(), 5U);
    EXPECT_EQ(place(4), core::Point(6, 1));
}

TEST_F(FitPointDrag, a_box_selects_no_hidden_control_points) {
    pointer.drag(px(-9, -5), px(9, 5));
    EXPECT_TRUE(state().selection.points.empty());
}

TEST_F(FitPointDrag, number_of_a_new_point_is_that_after_its_span) {
    const core::FitPoints line = core::fit_points_at(std::vector<core::Point>{{0, 0}, {1, 0}, {3, 0}}, {}).value();
    EXPECT_EQ(index_of_new_point(line, 0.0), 1U);
    EXPECT_EQ(index_of_new_point(line, 0.5), 1U);
    EXPECT_EQ(index_of_new_point(line, 1.0), 2U);
    EXPECT_EQ(index_of_new_point(line, 3.0), 2U);
    EXPECT_EQ(fit_point_at(line, 1.0), 1U);
    EXPECT_EQ(fit_point_at(line, 1.5), std::nullopt);
    EXPECT_EQ(fit_point_at(line, 4.0), std::nullopt);
}

}  // namespace
}  // namespace batten::editor
