#include "app/editor/pointer/canvas_press.h"

#include <gtest/gtest.h>

#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/tool_commands.h"
#include "app/editor/commands/view_commands.h"
#include "core/evaluate/evaluate.h"
#include "core/make/fit_points.h"
#include "core/measure/deviation.h"
#include "tests/editor/canvas_fixture.h"

namespace batten::editor {
namespace {

using test::committed;
using test::Indices;
using test::px;

class CanvasPress : public test::CanvasFixture {};

TEST_F(CanvasPress, double_click_on_the_curve_inserts_a_knot_there_and_keeps_the_shape) {
    const core::Point at = core::point_at(*first_curve, 0.5);
    pointer.double_click(px(at.x, at.y));
    ASSERT_EQ(test::stored_knots(committed(editor)).size(), 9U);
    EXPECT_NEAR(test::stored_knots(committed(editor))[3], 0.5, 1e-9);
    EXPECT_LT(core::largest_deviation(*first_curve, committed(editor)), 1e-14);
    EXPECT_EQ(steps(), 1U);
}

TEST_F(CanvasPress, double_click_on_the_parameter_inserts_it) {
    pointer.double_click(px(0, -1));
    EXPECT_EQ(test::stored_knots(committed(editor)), (std::vector<double>{0, 0, 0, 1, 1.5, 2, 3, 3, 3}));
}

TEST_F(CanvasPress, double_click_on_a_leg_adds_a_point_between_its_ends) {
    pointer.double_click(px(-3, 0));
    ASSERT_EQ(committed(editor).control_points().size(), 6U);
    EXPECT_EQ(point(1), core::Point(-3, 0));
    EXPECT_EQ(point(2), core::Point(-2, 2));
    EXPECT_EQ(selected(), Indices{1});
    EXPECT_EQ(steps(), 1U);
}

TEST_F(CanvasPress, double_click_on_a_knot_raises_its_multiplicity) {
    pointer.double_click(px(-1, 0));
    EXPECT_EQ(test::stored_knots(committed(editor)), (std::vector<double>{0, 0, 0, 1, 1, 2, 3, 3, 3}));
    EXPECT_LT(core::largest_deviation(*first_curve, committed(editor)), 1e-14);
    EXPECT_EQ(steps(), 1U);
}

TEST_F(CanvasPress, a_second_press_that_comes_as_double_click_still_drags_a_point) {
    pointer.click(px(-2, 2));
    pointer.send(PointerAction::double_click, px(-2, 2));
    pointer.move(px(-1, 2));
    pointer.release(px(-1, 2));
    EXPECT_EQ(point(1), core::Point(-1, 2));
}

TEST_F(CanvasPress, a_second_press_on_the_curve_that_is_dragged_moves_it_and_inserts_nothing) {
    const core::Point at = core::point_at(*first_curve, 0.5);
    const glm::dvec2 place = px(at.x, at.y);
    pointer.click(place);
    pointer.send(PointerAction::double_click, place);
    EXPECT_EQ(steps(), 0U);
    pointer.move(place + glm::dvec2(0, -64));
    EXPECT_TRUE(state().preview);
    pointer.release(place + glm::dvec2(0, -64));
    ASSERT_EQ(test::stored_knots(committed(editor)).size(), 8U);
    const core::Point now = core::point_at(committed(editor), 0.5);
    EXPECT_NEAR(now.x, at.x, 1e-6);
    EXPECT_NEAR(now.y, at.y + 1.0, 1e-6);
    EXPECT_EQ(steps(), 1U);
}

TEST_F(CanvasPress, a_second_press_that_is_dragged_is_that_of_one_press) {
    // A knot is dragged along the curve, a leg begins a box, the parameter follows.
    pointer.click(px(-1, 0));
    pointer.send(PointerAction::double_click, px(-1, 0));
    pointer.move(px(-0.5, -0.75));
    pointer.release(px(-0.5, -0.75));
    EXPECT_NEAR(test::stored_knots(committed(editor))[3], 1.25, 1e-6);
    EXPECT_EQ(steps(), 1U);
    pointer.click(px(-3, 0));
    pointer.send(PointerAction::double_click, px(-3, 0));
    pointer.move(px(-5, -3));
    EXPECT_TRUE(is_in<BoxSelecting>());
    pointer.release(px(-5, -3));
    EXPECT_EQ(selected(), Indices{0});
    EXPECT_EQ(steps(), 1U);
}

TEST_F(CanvasPress, escape_gives_up_the_second_press) {
    pointer.click(px(-3, 0));
    pointer.send(PointerAction::double_click, px(-3, 0));
    pointer.move(px(-3, 0) + glm::dvec2(1, 1));
    pointer.escape(px(-3, 0));
    pointer.release(px(-3, 0));
    EXPECT_EQ(steps(), 0U);
}

TEST_F(CanvasPress, drag_of_the_parameter_follows_the_curve) {
    const core::Point target = core::point_at(*first_curve, 1.75);
    pointer.press(px(0, -1));
    EXPECT_EQ(state().parameter(), 1.5);
    pointer.move(px(target.x, target.y));
    EXPECT_NEAR(state().parameter(), 1.75, 1e-9);
    pointer.release(px(target.x, target.y));
    EXPECT_EQ(steps(), 0U);
    EXPECT_EQ(selected(), Indices{});
}

TEST_F(CanvasPress, escape_puts_the_dragged_parameter_back) {
    pointer.press(px(0, -1));
    pointer.move(px(1, 0));
    pointer.escape(px(1, 0));
    EXPECT_EQ(state().parameter(), 1.5);
}

TEST_F(CanvasPress, drag_of_a_diamond_moves_the_knot_along_the_curve) {
    const core::Point target = core::point_at(*first_curve, 0.5);
    editor.run(SetKnotMove{.mode = core::KnotMove::stop});
    pointer.drag(px(-1, 0), px(target.x, target.y));
    const std::vector<double> knots = test::stored_knots(committed(editor));
    EXPECT_NEAR(knots[3], 0.5, 1e-9);
    EXPECT_EQ(knots[4], 2.0);
    EXPECT_EQ(steps(), 1U);
    EXPECT_EQ(state().selection.knot, std::optional<std::size_t>(3));
}

TEST_F(CanvasPress, drag_of_a_diamond_snaps_onto_a_knot_within_eight_pixels) {
    // C'(2) is the leg (2, 4), so that 0.02 is 5.7 px there and 0.03 is 8.6 px.
    editor.run(SetKnotMove{.mode = core::KnotMove::snap});
    const core::Point far = core::point_at(*first_curve, 1.97);
    pointer.drag(px(-1, 0), px(far.x, far.y));
    EXPECT_NEAR(test::stored_knots(committed(editor))[3], 1.97, 1e-9);
    editor.run(Undo{});
    const core::Point near = core::point_at(*first_curve, 1.98);
    pointer.drag(px(-1, 0), px(near.x, near.y));
    EXPECT_EQ(test::stored_knots(committed(editor)), (std::vector<double>{0, 0, 0, 2, 2, 3, 3, 3}));
}

TEST_F(CanvasPress, click_on_a_diamond_selects_its_knot) {
    pointer.click(px(-1, 0));
    EXPECT_EQ(state().selection.knot, std::optional<std::size_t>(3));
    EXPECT_EQ(steps(), 0U);
}

TEST_F(CanvasPress, drag_of_the_curve_moves_its_point_as_one_step) {
    const core::Point start = core::point_at(*first_curve, 0.5);
    pointer.press(px(start.x, start.y));
    pointer.move(px(start.x + 1, start.y + 0.5));
    EXPECT_EQ(committed(editor), *first_curve);
    pointer.move(px(start.x + 0.5, start.y + 1));
    pointer.release(px(start.x + 0.5, start.y + 1));
    EXPECT_EQ(steps(), 1U);
    EXPECT_EQ(state().history.undo_label(), "Move curve point");
    const core::Point moved = core::point_at(committed(editor), 0.5);
    EXPECT_NEAR(moved.x, start.x + 0.5, 1e-6);
    EXPECT_NEAR(moved.y, start.y + 1, 1e-6);
    EXPECT_EQ(test::stored_knots(committed(editor)), test::stored_knots(*first_curve));
    EXPECT_EQ(point(3), first_curve->control_points()[3]);
}

TEST_F(CanvasPress, escape_gives_up_the_drag_of_the_curve_and_a_click_only_deselects) {
    const core::Point start = core::point_at(*first_curve, 0.5);
    pointer.press(px(start.x, start.y));
    pointer.move(px(start.x + 1, start.y));
    EXPECT_TRUE(state().preview.has_value());
    pointer.send(PointerAction::escape, px(start.x + 1, start.y));
    pointer.release(px(start.x + 1, start.y));
    EXPECT_FALSE(state().preview.has_value());
    EXPECT_EQ(steps(), 0U);
    editor.run(SelectPoints{.points = {1, 2}});
    pointer.click(px(start.x, start.y));
    EXPECT_TRUE(selected().empty());
    EXPECT_EQ(steps(), 0U);
}

TEST_F(CanvasPress, a_locked_curve_is_not_dragged) {
    const core::Point start = core::point_at(*first_curve, 0.5);
    editor.run(SetCurveLocked{.index = 0, .locked = true});
    pointer.press(px(start.x, start.y));
    pointer.move(px(start.x + 1, start.y));
    pointer.release(px(start.x + 1, start.y));
    EXPECT_EQ(committed(editor), *first_curve);
}

TEST_F(CanvasPress, tools_leave_a_hidden_curve_as_it_is_and_say_so) {
    const core::Point on = core::point_at(*first_curve, 0.5);
    editor.run(SetCurveVisible{.index = 0, .visible = false});
    for (const Tool tool : {Tool::insert_knot, Tool::add_point, Tool::brush}) {
        editor.run(SetTool{.tool = tool});
        pointer.click(px(on.x, on.y));
        EXPECT_NE(state().message.text.find("is hidden; show it"), std::string::npos) << state().message.text;
    }
    EXPECT_EQ(committed(editor), *first_curve);
    EXPECT_EQ(steps(), 1U) << "that which hid it";
}

TEST_F(CanvasPress, click_on_another_curve_makes_it_active) {
    editor.run(NewCurve{.points = {{-4, 4}, {4, 4}}, .degree = 1});
    ASSERT_EQ(state().history.present().active, 1U);
    pointer.click(px(-1, 0));
    EXPECT_EQ(state().history.present().active, 0U);
}

TEST_F(CanvasPress, middle_drag_and_space_drag_pan) {
    pointer.button = PointerButton::middle;
    pointer.drag(px(-2, 2), px(-1, 1));
    EXPECT_EQ(state().view.camera.center, glm::dvec2(-1, 1));
    pointer.button = PointerButton::left;
    pointer.space = true;
    pointer.drag(px(-2, 2), px(-3, 3));
    EXPECT_EQ(state().view.camera.center, glm::dvec2(0, 0));
    EXPECT_EQ(steps(), 0U);
    EXPECT_TRUE(selected().empty());
}

TEST_F(CanvasPress, add_point_tool_adds_on_the_nearest_leg_or_end) {
    editor.run(SetTool{.tool = Tool::add_point});
    pointer.click(px(-3, 0.5));
    EXPECT_EQ(point(1), core::Point(-3, 0.5));
    pointer.click(px(5, -3));
    EXPECT_EQ(committed(editor).control_points().back(), core::Point(5, -3));
    pointer.click(px(-6, -2));
    EXPECT_EQ(point(0), core::Point(-6, -2));
    EXPECT_EQ(steps(), 3U);
}

TEST_F(CanvasPress, add_point_tool_drags_a_point_that_is_there) {
    editor.run(SetTool{.tool = Tool::add_point});
    pointer.drag(px(-2, 2), px(-1, 2));
    EXPECT_EQ(committed(editor).control_points().size(), 5U);
    EXPECT_EQ(point(1), core::Point(-1, 2));
}

TEST_F(CanvasPress, insert_knot_tool_inserts_at_the_nearest_parameter) {
    editor.run(SetTool{.tool = Tool::insert_knot});
    pointer.click(px(0, -1) + glm::dvec2(0, 20));
    EXPECT_NEAR(test::stored_knots(committed(editor))[4], 1.5, 1e-9);
    EXPECT_EQ(steps(), 1U);
    pointer.click(px(0, -1) + glm::dvec2(0, 40));
    EXPECT_EQ(steps(), 1U);
    pointer.click(px(-1, 0));
    EXPECT_EQ(committed(editor).knots().multiplicity(1.0), 2);
}

TEST_F(CanvasPress, weight_tool_drags_weights) {
    editor.run(SetTool{.tool = Tool::weight});
    pointer.drag(px(-2, 2), px(-2, 2) + glm::dvec2(0, -200));
    EXPECT_NEAR(weight(1), 10.0, 1e-14);
}

TEST_F(CanvasPress, parameter_tool_sets_u_from_anywhere) {
    editor.run(SetTool{.tool = Tool::parameter});
    pointer.press(px(-8, -4));
    EXPECT_EQ(state().parameter(), 0.0);
    pointer.move(px(9, -4));
    EXPECT_EQ(state().parameter(), 3.0);
    pointer.release(px(9, -4));
    EXPECT_EQ(steps(), 0U);
}

TEST_F(CanvasPress, draw_tool_makes_a_curve_of_its_clicks) {
    editor.run(SetTool{.tool = Tool::draw_curve});
    pointer.click(px(-1, 1));
    pointer.click(px(0, 3));
    pointer.move(px(1, 2));
    ASSERT_TRUE(is_in<DrawingCurve>());
    EXPECT_EQ(std::get<DrawingCurve>(pointer.mode()).next, core::Point(1, 2));
    pointer.double_click(px(2, 1));
    EXPECT_TRUE(is_in<CanvasIdle>());
    ASSERT_EQ(state().history.present().curves.size(), 2U);
    // The pen is at first the one through points, C2.
    ASSERT_NE(state().history.present().active_curve()->fit, nullptr);
    const core::FitPoints& drawn = *state().history.present().active_curve()->fit;
    EXPECT_EQ(drawn.kind, core::FitKind::c2);
    ASSERT_EQ(drawn.points.size(), 3U);
    EXPECT_EQ(drawn.points[0].place, core::Point(-1, 1));
    EXPECT_EQ(drawn.points[1].place, core::Point(0, 3));
    EXPECT_EQ(drawn.points[2].place, core::Point(2, 1));
    EXPECT_EQ(steps(), 1U);
    EXPECT_EQ(state().tool, Tool::select);
}

TEST_F(CanvasPress, drawing_ends_on_its_last_point_and_is_given_up_by_escape_or_another_tool) {
    editor.run(SetTool{.tool = Tool::draw_curve});
    pointer.click(px(-1, 1));
    pointer.click(px(-1, 1));
    EXPECT_TRUE(is_in<DrawingCurve>());
    pointer.escape(px(0, 3));
    EXPECT_TRUE(is_in<CanvasIdle>());
    EXPECT_EQ(state().tool, Tool::select);
    editor.run(SetTool{.tool = Tool::draw_curve});
    pointer.click(px(-1, 1));
    editor.run(SetTool{.tool = Tool::select});
    pointer.move(px(0, 3));
    EXPECT_TRUE(is_in<CanvasIdle>());
    EXPECT_EQ(steps(), 0U);
    editor.run(SetTool{.tool = Tool::draw_curve});
    pointer.click(px(-1, 1));
    pointer.click(px(3, 3));
    pointer.click(px(3, 3));
    EXPECT_EQ(state().history.present().curves.size(), 2U);
}

TEST_F(CanvasPress, another_tool_ends_what_the_pen_draws_and_loses_no_click) {
    editor.run(TakeTool<Tool::draw_curve>{});
    for (const core::Point p : {core::Point(-1, 1), core::Point(0, 3), core::Point(2, 3)}) pointer.click(px(p.x, p.y));
    editor.run(TakeTool<Tool::select>{});
    editor.run(TakeTool<Tool::draw_curve>{});
    pointer.move(px(3, 2));
    EXPECT_TRUE(is_in<CanvasIdle>());
    EXPECT_EQ(steps(), 1U);
    ASSERT_EQ(state().history.present().curves.size(), 2U);
    const auto& fit = state().history.present().active_curve()->fit;
    ASSERT_TRUE(fit);
    ASSERT_EQ(fit->points.size(), 3U);
    EXPECT_EQ(fit->points[0].place, core::Point(-1, 1));
    EXPECT_EQ(fit->points[2].place, core::Point(2, 3));
    pointer.click(px(2, 1));
    ASSERT_TRUE(is_in<DrawingCurve>());
    EXPECT_EQ(std::get<DrawingCurve>(pointer.mode()).points, (std::vector<core::Point>{{2, 1}}));
    editor.run(TakeTool<Tool::draw_curve>{});
    pointer.click(px(3, 3));
    EXPECT_EQ(std::get<DrawingCurve>(pointer.mode()).points.size(), 2U) << "the pen in hand goes on";
}

TEST_F(CanvasPress, without_a_curve_nothing_breaks) {
    Editor empty;
    test::CanvasPointer idle{empty, test::CanvasStep{}};
    for (const Tool tool : all_tools) {
        empty.run(SetTool{.tool = tool});
        idle.drag(px(-2, 2), px(2, -2));
        idle.escape(px(0, 0));
        idle.double_click(px(0, 0));
        idle.escape(px(0, 0));
        EXPECT_FALSE(canvas_hint(idle.mode(), empty.state()).empty());
    }
    EXPECT_EQ(empty.state().history.undo_count(), 3U)
        << "the pencil has drawn, the brush moved that, and a point came in";
}

TEST_F(CanvasPress, hints_tell_what_a_click_would_do) {
    pointer.move(px(-2, 2));
    EXPECT_EQ(canvas_hint(pointer.mode(), state()), "Drag P₁ to move it · hold Alt to change its weight");
    pointer.move(px(0, -1));
    EXPECT_EQ(canvas_hint(pointer.mode(), state()),
              "Drag C(u) along the curve · double-click to insert a knot at u = 1.500 (keeps the shape)");
    pointer.move(px(-3, 0));
    EXPECT_EQ(canvas_hint(pointer.mode(), state()),
              "Double-click to add a control point between P₀ and P₁ (changes the shape)");
    pointer.move(px(0.5, -1));
    EXPECT_EQ(canvas_hint(pointer.mode(), state()), "P₃¹ = 3/4 P₂ + 1/4 P₃ · right-click for what can be done at u");
    pointer.press(px(-2, 2));
    pointer.move(px(-1, 2));
    EXPECT_EQ(canvas_hint(pointer.mode(), state()),
              "P₁ at (−1.000, 2.000) · Ctrl snaps to the grid · Shift keeps to an axis · Escape restores");
}

TEST(BestIndex, keeps_the_polygon_shortest) {
    const core::Curve line = [] {
        core::CurveDefinition definition;
        definition.degree = 1;
        definition.knots = {0, 0, 1, 2, 2};
        definition.points = {{0, 0}, {4, 0}, {4, 4}};
        return core::Curve::make(definition).value();
    }();
    EXPECT_EQ(best_index_for(line, {-1, 0}), 0U);
    EXPECT_EQ(best_index_for(line, {2, 1}), 1U);
    EXPECT_EQ(best_index_for(line, {4.5, 2}), 2U);
    EXPECT_EQ(best_index_for(line, {4, 5}), 3U);
}

TEST(BestIndex, closes_the_polygon_of_a_periodic_curve) {
    const core::Curve curve = core::Curve::make(test::closed_cubic()).value();
    EXPECT_EQ(best_index_for(curve, {1.5, -1}), 6U);
    EXPECT_EQ(best_index_for(curve, {1.5, 1}), 1U);
}

}  // namespace
}  // namespace batten::editor
