#include "app/editor/pointer/placing_step.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/editor/command_spec.h"
#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/drawing_commands.h"
#include "app/editor/commands/fit_point_commands.h"
#include "app/editor/commands/making_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/selected_curve_commands.h"
#include "app/editor/commands/snap_commands.h"
#include "app/editor/commands/tool_commands.h"
#include "app/editor/commands/unit_commands.h"
#include "app/editor/pointer/place_text.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/area.h"
#include "tests/editor/canvas_fixture.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

using test::px;

class Placed : public test::CanvasFixture {
  protected:
    const std::optional<ShownPlace>& place() const { return state().placing.place; }
    std::string hint() const { return canvas_hint(pointer.mode(), state()); }
    const core::Document& document() const { return state().history.present(); }
    void expect_point(std::size_t i, core::Point wanted) const {
        EXPECT_LE(core::distance(point(i), wanted), 1e-15 * (1.0 + core::length(core::vector_to(wanted))))
            << point(i).x << ", " << point(i).y;
    }
};

// Numbers and axes for a handle count from its point, not from where it was.
TEST_F(Placed, a_handle_is_turned_to_a_typed_angle) {
    editor.run(ThroughPoints{.points = {{-4, 0}, {-1, 2}, {1, -1}, {4, 1}}});
    editor.run(SetFitJoint{.index = 1, .joint = core::FitJoint::tangent, .handle = core::Vector(2, 0)});
    const auto handle = [&] { return document().active_curve()->fit->points[1].handle; };
    pointer.press(px(1, 2));
    pointer.move(px(1.5, 2.5));
    EXPECT_EQ(place()->from, core::Point(-1, 2));
    type(U"1.5\t30\n", px(1.5, 2.5));
    pointer.release(px(1.5, 2.5));
    EXPECT_LT(core::length(handle() - core::Vector(1.5 * std::cos(std::numbers::pi / 6.0), 0.75)), 1e-15);
    const core::Point tip = core::Point(-1, 2) + handle();
    pointer.modifiers = test::shift;
    pointer.drag(px(tip.x, tip.y), px(-1.2, 3.0));
    EXPECT_EQ(handle().x, 0.0);
    EXPECT_NEAR(handle().y, 1.0, 1e-12);
}

// The example of the documentation: sqrt(2)/2 in the direction of 30 degrees.
TEST_F(Placed, an_expression_may_begin_with_a_function) {
    pointer.press(px(-2, 2));
    pointer.move(px(-1, 2.5));
    type(U"sqrt(2)/2<pi/6 rad\n", px(-1, 2.5));
    pointer.release(px(-1, 2.5));
    expect_point(1, core::Point(-2 + std::sqrt(0.375), 2 + std::sqrt(0.125)));
    pointer.press(px(2, 2));
    pointer.move(px(2.5, 2.5));
    type(U"sqrt(-1)\n", px(2.5, 2.5));
    EXPECT_FALSE(is_in<CanvasIdle>());
    EXPECT_TRUE(state().message.is_error) << state().message.text;
}

TEST_F(Placed, a_dragged_point_snaps_to_another_and_tells_it) {
    pointer.press(px(-2, 2));
    pointer.move(px(1.95, 1.93));
    ASSERT_TRUE(place() && place()->snap);
    EXPECT_EQ(place()->position, core::Point(2, 2));
    EXPECT_EQ(place()->from, core::Point(-2, 2));
    EXPECT_EQ(hint(),
              "Snaps to P₃ · Alt lets go · P₁ at (2.000, 2.000) · Ctrl snaps to the grid · Shift keeps to an "
              "axis · Escape restores");
    pointer.modifiers = test::alt;
    pointer.move(px(1.95, 1.93));
    EXPECT_FALSE(place()->snap);
    EXPECT_NEAR(place()->position.x, 1.95, 1e-12);
    pointer.modifiers = {};
    pointer.release(px(1.95, 1.93));
    EXPECT_EQ(point(1), core::Point(2, 2));
    EXPECT_EQ(steps(), 1U);
    EXPECT_FALSE(place());
}

TEST_F(Placed, all_that_is_selected_takes_typed_numbers) {
    editor.run(NewCurve{.points = {{-4, 3.5}, {4, 3.5}}, .degree = 1});
    editor.run(SelectParts{.parts = "0:1 1"});
    pointer.press(px(-2, 2));
    pointer.move(px(-1.6, 1.8));
    type(U"@1.25,-0.5\n", px(-1.6, 1.8));
    EXPECT_EQ(document().curves[0].curve->control_points()[1], core::Point(-0.75, 1.5));
    EXPECT_EQ(document().curves[1].curve->control_points()[0], core::Point(-2.75, 3));
    pointer.release(px(-1.6, 1.8));
    EXPECT_EQ(document().curves[1].curve->control_points()[1], core::Point(5.25, 3));
}

TEST_F(Placed, with_shift_a_snap_aligns) {
    pointer.press(px(-2, 2));
    pointer.modifiers = test::shift;
    pointer.move(px(1.95, 1.5));
    pointer.release(px(1.95, 1.5));
    EXPECT_EQ(point(1), core::Point(2, 2));
    pointer.modifiers = {};
    pointer.press(px(0, -2));
    pointer.modifiers = test::shift;
    pointer.move(px(0.5, -2.05));
    pointer.release(px(0.5, -2.05));
    EXPECT_EQ(point(2), core::Point(0.5, -2));
}

// The second point of the zigzag is at (-2, 2).
TEST_F(Placed, digits_set_length_and_angle_of_a_drag) {
    pointer.press(px(-2, 2));
    pointer.move(px(-1, 2.3));
    type(U"12.5\t30", px(-1, 2.3));
    const core::Point wanted{-2 + 12.5 * std::sqrt(0.75), 2 + 6.25};
    EXPECT_LE(core::distance(state().active_curve()->control_points()[1], wanted), 1e-14);
    EXPECT_EQ(steps(), 0U);
    type(U"\n", px(-1, 2.3));
    expect_point(1, wanted);
    EXPECT_EQ(steps(), 1U);
    EXPECT_TRUE(is_in<CanvasIdle>());
    EXPECT_TRUE(state().placing.typed.is_empty());
    pointer.release(px(-1, 2.3));
    EXPECT_EQ(steps(), 1U);
}

TEST_F(Placed, lengths_are_typed_in_the_unit_of_the_document) {
    editor.run(SetUnits{.unit = UnitChoice::mm, .scale = 0.5});
    pointer.press(px(-2, 2));
    pointer.move(px(-1, 2.3));
    type(U"4\t0\n", px(-1, 2.3));  // 4 mm are 2 of the world
    expect_point(1, {0, 2});
    pointer.press(px(0, 2));
    pointer.move(px(1, 2.3));
    type(U"1in\t-90\n", px(1, 2.3));
    expect_point(1, {0, 2 - 12.7});
}

TEST_F(Placed, digits_need_no_movement_and_one_number_binds_one_direction) {
    pointer.press(px(-2, 2));
    type(U"x3", px(-2, 2));
    expect_point(1, {-2, 2});
    EXPECT_EQ(state().active_curve()->control_points()[1], core::Point(1, 2));
    pointer.move(px(0, 2.5));
    EXPECT_EQ(state().active_curve()->control_points()[1], core::Point(1, 2.5));
    pointer.release(px(0, 2.5));
    EXPECT_EQ(point(1), core::Point(1, 2.5));
    EXPECT_EQ(steps(), 1U);
}

TEST_F(Placed, escape_drops_the_numbers_first_and_backspace_edits_them) {
    pointer.press(px(-2, 2));
    pointer.move(px(-1, 2));
    type(U"57\b", px(-1, 2));
    EXPECT_EQ(state().active_curve()->control_points()[1], core::Point(3, 2));
    pointer.escape(px(-1, 2));
    EXPECT_TRUE(state().placing.typed.is_empty());
    EXPECT_EQ(state().active_curve()->control_points()[1], core::Point(-1, 2));
    pointer.escape(px(-1, 2));
    EXPECT_TRUE(is_in<CanvasIdle>());
    EXPECT_EQ(point(1), core::Point(-2, 2));
    EXPECT_FALSE(state().preview);
}

TEST_F(Placed, what_cannot_be_read_is_refused_at_enter_and_the_drag_goes_on) {
    pointer.press(px(-2, 2));
    pointer.move(px(-1, 2));
    type(U"5+\n", px(-1, 2));
    EXPECT_EQ(state().message.text, "a number is missing at the end");
    EXPECT_TRUE(is_in<DraggingPoints>());
    type(U"1\n", px(-1, 2));
    expect_point(1, {4, 2});
}

TEST_F(Placed, the_reading_is_broken_between_its_parts_where_the_canvas_is_narrow) {
    constexpr double width = 170.0;
    editor.change(ResizeCanvas{{width, 300.0}});
    const auto at = [&](core::Point place) { return render::screen_from_world(state().view.camera, place); };
    pointer.press(at({-2, 2}));
    pointer.move(at({-1.25, 1.5}));
    ASSERT_TRUE(place());
    std::string told;
    for (const auto& label : test::all_of<render::Label>(test::canvas_picture(state(), pointer.mode()))) {
        if (label.text.find("∠") == std::string::npos && !label.text.starts_with("d")) continue;
        EXPECT_GE(test::box_of(label).lower_px.x, 0.0) << label.text;
        EXPECT_LE(test::box_of(label).upper_px.x, width) << label.text;
        told += (told.empty() ? "" : " · ") + label.text;
    }
    EXPECT_EQ(told, reading_of(state(), *place()));
}

// C(1.5) = (0, -1).
TEST_F(Placed, the_curve_is_dragged_by_numbers) {
    pointer.press(px(0, -1));
    ASSERT_TRUE(is_in<DraggingParameter>());  // C(u) lies there
    pointer.escape(px(0, -1));
    editor.run(SetParameter{.u = 0.0});
    pointer.press(px(0, -1));
    type(U"@0.5,-2\n", px(0, -1));
    const core::Point moved = core::point_at(test::committed(editor), 1.5);
    EXPECT_LE(core::distance(moved, {0.5, -3}), 1e-14);
}

TEST_F(Placed, the_next_point_of_a_drawing_is_typed) {
    editor.run(SetTool{.tool = Tool::draw_curve});
    pointer.move(px(0, 0));
    type(U"3,4\n", px(0, 0));
    type(U"@10,5\n", px(0, 0));
    type(U"10<90\n", px(0, 0));
    pointer.move(px(-5, 0));
    type(U"4<0\n", px(-5, 0));
    ASSERT_TRUE(is_in<DrawingCurve>());
    const auto& points = std::get<DrawingCurve>(pointer.mode()).points;
    EXPECT_EQ(points, (std::vector<core::Point>{{3, 4}, {13, 9}, {13, 19}, {17, 19}}));
}

TEST_F(Placed, tools_that_put_points_show_where) {
    editor.run(SetTool{.tool = Tool::add_point});
    pointer.move(px(-3.95, -1.95));
    ASSERT_TRUE(place() && place()->snap);
    EXPECT_EQ(place()->snap->label, "P₀");
    EXPECT_FALSE(place()->from);
    pointer.send(PointerAction::leave, px(-3.95, -1.95));
    EXPECT_FALSE(place());
    pointer.move(px(1, 1));
    type(U"3", px(1, 1));
    pointer.escape(px(1, 1));
    EXPECT_TRUE(state().placing.typed.is_empty());
    EXPECT_EQ(state().tool, Tool::add_point);
    EXPECT_TRUE(place());
    editor.run(SetTool{.tool = Tool::select});
    EXPECT_FALSE(place());
}

TEST_F(Placed, the_view_moves_while_a_shape_is_drawn) {
    editor.run(DrawShape<ShapeKind::line>{});
    pointer.modifiers = test::alt;
    pointer.click(px(-3, 3));
    const glm::dvec2 center = state().view.camera.center;
    pointer.button = PointerButton::middle;
    pointer.press(px(0, 0));
    pointer.move(px(2, 0));
    pointer.release(px(2, 0));
    pointer.button = PointerButton::left;
    pointer.space = true;
    pointer.press(px(0, 0));
    pointer.move(px(0, 1));
    pointer.release(px(0, 1));
    pointer.space = false;
    EXPECT_NEAR(state().view.camera.center.x, center.x - 2.0, 1e-12);
    EXPECT_NEAR(state().view.camera.center.y, center.y - 1.0, 1e-12);
    ASSERT_TRUE(is_in<DrawingShape>());
    EXPECT_EQ(std::get<DrawingShape>(pointer.mode()).points.size(), 1U);
    pointer.click(px(0, 0));
    ASSERT_EQ(document().curves.size(), 2U);
    EXPECT_LE(core::distance(point(1), {-2, -1}), 1e-12);
}

TEST_F(Placed, a_guide_is_dragged_and_typed) {
    editor.run(AddGuide{.position = {0.0, 4.0}, .angle = 0.0});
    pointer.move(px(5, 4.03));
    EXPECT_EQ(state().hover, Hover(HoveredGuide{0}));
    pointer.drag(px(5, 4), px(5, 5.25));
    EXPECT_EQ(document().guides[0].point, core::Point(0, 5.25));
    pointer.press(px(5, 5.25));
    type(U"y-2.25\n", px(5, 5.25));
    EXPECT_EQ(document().guides[0].point.y, 3.0);
    EXPECT_EQ(document().guides[0].angle, 0.0);
    editor.run(RemoveGuide{.index = 0});
    EXPECT_TRUE(document().guides.empty());
}

class Shapes : public Placed {
  protected:
    void draw(ShapeKind kind) { editor.run(Command(draw_shape_spec(kind), draw_shape_spec(kind).run.make())); }
    const core::DocumentCurve& last() const { return document().curves.back(); }
    core::Point at(double u) const { return core::point_at(*last().curve, u); }
    void expect_at(double u, core::Point wanted) const {
        EXPECT_LE(core::distance(at(u), wanted), 1e-14) << at(u).x << ", " << at(u).y;
    }
    /// Whether all of the last curve is as far from `center`.
    void expect_round(core::Point center, double radius) const {
        for (double u = 0.0; u <= 1.0; u += 0.0625) EXPECT_NEAR(core::distance(at(u), center), radius, 1e-14 * radius);
    }
};

TEST_F(Shapes, a_line_by_clicks_and_numbers_is_one_step) {
    draw(ShapeKind::line);
    EXPECT_EQ(state().tool, Tool::shape);
    pointer.click(px(-6, 3));
    pointer.move(px(-5, 3));
    EXPECT_EQ(state().shown().curves.size(), 2U);  // previewed
    type(U"12.5\t30\n", px(-5, 3));
    EXPECT_EQ(last().name, "line");
    expect_at(1.0, {-6 + 12.5 * std::sqrt(0.75), 9.25});
    EXPECT_EQ(steps(), 1U);
    EXPECT_TRUE(is_in<CanvasIdle>());
    EXPECT_EQ(state().tool, Tool::shape);
}

TEST_F(Shapes, a_circle_has_the_radius_that_was_typed_to_the_last_bit) {
    draw(ShapeKind::circle);
    pointer.move(px(0, 0));
    type(U"0.1,0.7\n", px(0, 0));
    pointer.move(px(3, 3));
    type(U"1.3\n", px(3, 3));
    ASSERT_EQ(document().curves.size(), 2U);
    EXPECT_EQ(last().curve->control_points()[0], core::Point(0.1 + 1.3, 0.7));
    expect_round({0.1, 0.7}, 1.3);
}

TEST_F(Shapes, arcs_go_the_way_that_the_pointer_went) {
    draw(ShapeKind::arc);
    pointer.click(px(0, 0));
    pointer.click(px(3, 0));
    pointer.move(px(2, -2));
    pointer.move(px(0, -3));
    pointer.move(px(-2, -2));
    pointer.click(px(-3, 0));
    expect_round({0, 0}, 3);
    expect_at(0.0, {3, 0});
    expect_at(0.5, {0, -3});
    expect_at(1.0, {-3, 0});
    pointer.click(px(0, 0));
    pointer.click(px(3, 0));
    pointer.move(px(2, 2));
    type(U"<90\n", px(2, 2));
    expect_at(0.5, {3 * std::sqrt(0.5), 3 * std::sqrt(0.5)});
    expect_at(1.0, {0, 3});
}

TEST_F(Shapes, through_three_points) {
    draw(ShapeKind::arc_through_points);
    pointer.click(px(3, 0));
    pointer.click(px(0, 3));
    pointer.click(px(0, -3));
    expect_round({0, 0}, 3);
    expect_at(0.0, {3, 0});
    expect_at(1.0, {0, 3});
    expect_at(0.5, {-3 * std::sqrt(0.5), -3 * std::sqrt(0.5)});
    draw(ShapeKind::circle_through_points);
    pointer.click(px(5, 1));
    pointer.click(px(1, 5));
    pointer.click(px(-3, 1));
    expect_round({1, 1}, 4);
    draw(ShapeKind::circle_through_points);
    pointer.click(px(-5, 3));
    pointer.click(px(0, 3));
    pointer.click(px(5, 3));
    EXPECT_EQ(state().message.text, "the three places lie on one line, so no circle passes through them");
    EXPECT_TRUE(is_in<DrawingShape>());
    pointer.escape(px(5, 3));
    EXPECT_TRUE(is_in<CanvasIdle>());
}

TEST_F(Shapes, rectangles_polygons_ellipses_and_conics) {
    draw(ShapeKind::rectangle);
    pointer.click(px(-5, 3));
    type(U"x4\t-2.5\n", px(-4, 4));
    EXPECT_NEAR(std::abs(core::enclosed_area(*last().curve)->signed_area), 10.0, 1e-14);
    EXPECT_TRUE(last().curve->is_periodic());
    pointer.click(px(1, 3));
    pointer.modifiers = test::shift;
    pointer.move(px(3, 4));
    pointer.click(px(3, 4));
    pointer.modifiers = {};
    EXPECT_EQ(last().curve->control_points()[2], core::Point(3, 5));
    editor.run(SetPolygonSides{.sides = 4});
    draw(ShapeKind::polygon);
    pointer.click(px(0, 0));
    type(U"3<0\n", px(1, 1));
    EXPECT_EQ(last().curve->control_points()[0], core::Point(3, 0));
    EXPECT_EQ(last().curve->control_points().size(), 4U);
    draw(ShapeKind::ellipse);
    pointer.click(px(0, 0));
    pointer.click(px(0, 3));
    pointer.click(px(2, 1));
    expect_at(0.0, {0, 3});
    expect_at(0.25, {-2, 0});
    draw(ShapeKind::conic);
    pointer.click(px(-4, 0));
    pointer.click(px(4, 0));
    pointer.click(px(0, 4));
    pointer.click(px(0, 2));
    expect_at(0.5, {0, 2});
    EXPECT_NEAR(last().curve->weights()[1], 1.0, 1e-15);
}

// The pointer has not come to the canvas since the tool was taken.
TEST_F(Shapes, the_first_place_may_be_typed_at_once) {
    draw(ShapeKind::line);
    type(U"1,2\n", px(0, 0));
    ASSERT_TRUE(is_in<DrawingShape>());
    type(U"10<45\n", px(0, 0));
    ASSERT_EQ(document().curves.size(), 2U);
    expect_at(0.0, {1, 2});
    expect_at(1.0, {1 + std::sqrt(50.0), 2 + std::sqrt(50.0)});
    editor.run(TakeTool<Tool::draw_curve>{});
    type(U"-1,3\n", px(0, 0));
    ASSERT_TRUE(is_in<DrawingCurve>());
    EXPECT_EQ(std::get<DrawingCurve>(pointer.mode()).points.front(), core::Point(-1, 3));
}

TEST_F(Shapes, places_are_taken_back_one_by_one_and_no_step_of_the_document) {
    draw(ShapeKind::arc_through_points);
    pointer.click(px(3, 0));
    pointer.click(px(0, 3));
    pointer.move(px(0, -3));
    EXPECT_TRUE(listens_to_drawing_keys(pointer.mode(), state()));
    pointer.send(PointerAction::take_back, px(0, -3));
    ASSERT_TRUE(is_in<DrawingShape>());
    EXPECT_EQ(std::get<DrawingShape>(pointer.mode()).points, (std::vector<core::Point>{{3, 0}}));
    EXPECT_FALSE(state().preview);
    pointer.click(px(-3, 0));
    pointer.click(px(0, 3));
    expect_at(1.0, {-3, 0});
    expect_at(0.5, {0, 3});
    EXPECT_EQ(steps(), 1U);
    pointer.click(px(1, 1));
    pointer.send(PointerAction::take_back, px(1, 1));
    EXPECT_TRUE(is_in<CanvasIdle>());
    pointer.click(px(1, 1));
    pointer.button = PointerButton::right;
    pointer.click(px(2, 2));
    EXPECT_TRUE(is_in<CanvasIdle>());
    EXPECT_EQ(steps(), 1U);
}

// The first axis leads 20 away at 30 degrees, and the pointer is anywhere.
TEST_F(Shapes, an_ellipse_reaches_as_far_from_its_axis_as_is_typed) {
    draw(ShapeKind::ellipse);
    pointer.move(px(0, 0));
    type(U"0,0\n2<30\n", px(0, 0));
    pointer.move(px(0, 2));
    type(U"1\n", px(0, 2));
    EXPECT_NEAR(core::enclosed_area(*last().curve)->signed_area, 2.0 * std::numbers::pi, 1e-13);
    expect_at(0.0, {std::sqrt(3.0), 1});
    expect_at(0.25, {-0.5, std::sqrt(0.75)});
}

TEST_F(Shapes, a_place_typed_twice_is_refused) {
    draw(ShapeKind::line);
    type(U"1,2\n1,2\n", px(0, 0));
    EXPECT_TRUE(is_in<DrawingShape>());
    EXPECT_EQ(state().message.text, "the next place must be another one than the last");
}

TEST_F(Shapes, are_given_up_with_the_tool) {
    draw(ShapeKind::circle);
    pointer.click(px(0, 0));
    pointer.move(px(1, 1));
    ASSERT_TRUE(state().preview);
    editor.run(SetTool{.tool = Tool::select});
    EXPECT_FALSE(state().preview);
    pointer.move(px(1, 1));
    EXPECT_TRUE(is_in<CanvasIdle>());
    EXPECT_EQ(document().curves.size(), 1U);
    draw(ShapeKind::circle);
    pointer.click(px(0, 0));
    draw(ShapeKind::line);
    pointer.move(px(1, 1));
    EXPECT_TRUE(is_in<CanvasIdle>());
}

}  // namespace
}  // namespace batten::editor
