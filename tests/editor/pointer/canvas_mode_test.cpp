#include "app/editor/pointer/canvas_mode.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/overlay_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/view_commands.h"
#include "core/evaluate/evaluate.h"
#include "tests/editor/canvas_fixture.h"

namespace batten::editor {
namespace {

using test::alt;
using test::committed;
using test::ctrl;
using test::Indices;
using test::px;
using test::shift;

class CanvasModes : public test::CanvasFixture {};

TEST_F(CanvasModes, drag_by_64_pixels_moves_a_point_by_one_unit_and_nothing_else) {
    ASSERT_EQ(state().view.camera, render::Camera{});
    pointer.drag(px(-2, 2), px(-1, 2));
    EXPECT_EQ(point(1), core::Point(-1, 2));
    core::CurveDefinition expected = first_curve->definition();
    expected.points[1] = {-1, 2};
    EXPECT_EQ(committed(editor), core::Curve::make(expected).value());
    EXPECT_EQ(steps(), 1U);
    EXPECT_EQ(state().history.undo_label(), "Move P₁");
    EXPECT_EQ(selected(), Indices{1});
}

TEST_F(CanvasModes, drag_up_raises_y) {
    pointer.drag(px(-2, 2), px(-2, 2) + glm::dvec2(0, -32));
    EXPECT_EQ(point(1), core::Point(-2, 2.5));
}

TEST_F(CanvasModes, a_point_grabbed_off_its_center_does_not_jump) {
    pointer.drag(px(-2, 2) + glm::dvec2(5, 3), px(-1, 2) + glm::dvec2(5, 3));
    EXPECT_EQ(point(1), core::Point(-1, 2));
}

TEST_F(CanvasModes, drag_previews_without_touching_the_document) {
    pointer.press(px(-2, 2));
    pointer.move(px(0, 3));
    EXPECT_EQ(state().active_curve()->control_points()[1], core::Point(0, 3));
    EXPECT_EQ(state().history.present().active_curve()->curve, first_curve);
    EXPECT_EQ(steps(), 0U);
    pointer.move(px(-1.5, 2));
    pointer.release(px(-1.5, 2));
    EXPECT_EQ(point(1), core::Point(-1.5, 2));
    EXPECT_EQ(steps(), 1U);
    editor.run(Undo{});
    EXPECT_EQ(state().history.present().active_curve()->curve, first_curve);
}

TEST_F(CanvasModes, escape_restores_the_very_document) {
    pointer.press(px(-2, 2));
    pointer.move(px(0, 3));
    pointer.escape(px(0, 3));
    EXPECT_EQ(state().shown().active_curve()->curve, first_curve);
    pointer.move(px(1, 3));
    pointer.release(px(1, 3));
    EXPECT_EQ(state().shown().active_curve()->curve, first_curve);
    EXPECT_EQ(steps(), 0U);
    EXPECT_TRUE(is_in<CanvasIdle>());
}

TEST_F(CanvasModes, a_drag_that_comes_back_leaves_no_step) {
    pointer.press(px(-2, 2));
    pointer.move(px(0, 3));
    pointer.move(px(-2, 2));
    pointer.release(px(-2, 2));
    EXPECT_EQ(state().shown().active_curve()->curve, first_curve);
    EXPECT_EQ(steps(), 0U);
}

TEST_F(CanvasModes, press_that_moves_less_than_three_pixels_is_a_click) {
    pointer.drag(px(-2, 2), px(-2, 2) + glm::dvec2(2, 2));
    EXPECT_EQ(steps(), 0U);
    EXPECT_EQ(selected(), Indices{1});
    pointer.drag(px(-2, 2), px(-2, 2) + glm::dvec2(0, 4));
    EXPECT_EQ(point(1), core::Point(-2, 2 - 4.0 / 64.0));
}

TEST_F(CanvasModes, the_click_distance_grows_with_the_interface) {
    editor.change(SetInterfaceScale{2.0});
    pointer.drag(px(-2, 2), px(-2, 2) + glm::dvec2(5, 0));
    EXPECT_EQ(steps(), 0U);
    pointer.drag(px(-2, 2), px(-2, 2) + glm::dvec2(16, 0));
    EXPECT_EQ(point(1), core::Point(-1.75, 2));
}

TEST_F(CanvasModes, shift_click_toggles_a_point) {
    pointer.click(px(-2, 2));
    pointer.modifiers = shift;
    pointer.click(px(2, 2));
    EXPECT_EQ(selected(), (Indices{1, 3}));
    pointer.click(px(-2, 2));
    EXPECT_EQ(selected(), Indices{3});
}

TEST_F(CanvasModes, click_on_one_of_several_selected_points_selects_it_alone) {
    editor.run(SelectPoints{.points = {1, 2, 3}});
    pointer.press(px(2, 2));
    EXPECT_EQ(selected(), (Indices{1, 2, 3}));
    pointer.release(px(2, 2));
    EXPECT_EQ(selected(), Indices{3});
}

TEST_F(CanvasModes, drag_moves_the_whole_selection_in_one_step) {
    editor.run(SelectPoints{.points = {1, 3}});
    pointer.drag(px(2, 2), px(2.5, 1));
    EXPECT_EQ(point(1), core::Point(-1.5, 1));
    EXPECT_EQ(point(3), core::Point(2.5, 1));
    EXPECT_EQ(point(2), core::Point(0, -2));
    EXPECT_EQ(steps(), 1U);
    EXPECT_EQ(selected(), (Indices{1, 3}));
}

TEST_F(CanvasModes, shift_drag_of_a_selected_point_keeps_it_selected) {
    editor.run(SelectPoints{.points = {1, 3}});
    pointer.modifiers = shift;
    pointer.drag(px(2, 2), px(3, 2.25));
    EXPECT_EQ(point(1), core::Point(-1, 2));
    EXPECT_EQ(point(3), core::Point(3, 2));
    EXPECT_EQ(selected(), (Indices{1, 3}));
}

TEST_F(CanvasModes, shift_keeps_to_the_axis_of_the_larger_movement) {
    pointer.press(px(-2, 2));
    pointer.modifiers = shift;
    pointer.move(px(-1, 2.5));
    EXPECT_EQ(state().active_curve()->control_points()[1], core::Point(-1, 2));
    pointer.release(px(-1.5, 3));
    EXPECT_EQ(point(1), core::Point(-2, 3));
}

TEST_F(CanvasModes, ctrl_puts_the_point_on_the_minor_grid) {
    // Major lines are 2 apart at 64 px a unit, minor ones 0.5. The pointer moves by (37, -20) px = (0.578, 0.3125).
    pointer.modifiers = ctrl;
    pointer.drag(px(-2, 2), px(-2, 2) + glm::dvec2(37, -20));
    EXPECT_EQ(point(1), core::Point(-1.5, 2.5));
}

TEST_F(CanvasModes, snapped_coordinates_are_the_doubles_of_their_decimals) {
    // At 1280 px a unit the major step is 0.1 and the minor one 0.02; P_2 at (0, -2) is brought to the center.
    editor.change(ZoomCamera{20.0, px(0, -2)});
    const glm::dvec2 start = px(0, -2);
    pointer.modifiers = ctrl;
    pointer.drag(start, start + glm::dvec2(0.3 * 1280 + 5, -0.14 * 1280 - 5));
    EXPECT_EQ(point(2).x, 0.3);
    EXPECT_EQ(point(2).y, -1.86);
}

TEST_F(CanvasModes, snapping_a_selection_puts_the_grabbed_point_exactly_on_the_grid) {
    editor.run(SetPoint{.index = 1, .position = {-2.1, 2.3}});
    editor.run(SelectPoints{.points = {1, 3}});
    pointer.modifiers = ctrl;
    pointer.drag(px(-2.1, 2.3), px(-1.1, 1.1));
    EXPECT_EQ(point(1), core::Point(-1, 1));
    EXPECT_NEAR(point(3).x, 3.1, 1e-15);
    EXPECT_NEAR(point(3).y, 0.7, 1e-15);
}

TEST_F(CanvasModes, alt_drag_multiplies_the_weight) {
    pointer.modifiers = alt;
    pointer.drag(px(-2, 2), px(-2, 2) + glm::dvec2(100, 0));
    EXPECT_NEAR(weight(1), std::sqrt(10.0), 1e-14);
    EXPECT_EQ(point(1), core::Point(-2, 2));
    EXPECT_EQ(steps(), 1U);
    EXPECT_EQ(state().history.undo_label(), "Set weight of P₁");
    pointer.drag(px(-2, 2), px(-2, 2) + glm::dvec2(0, 300));
    EXPECT_NEAR(weight(1), 0.1, 1e-15);
}

TEST_F(CanvasModes, weights_grow_as_far_up_as_to_the_right_and_shrink_as_far) {
    pointer.modifiers = alt;
    pointer.drag(px(-2, 2), px(-2, 2) + glm::dvec2(0, -400));
    EXPECT_NEAR(weight(1), 100.0, 1e-12);
    pointer.drag(px(-2, 2), px(-2, 2) + glm::dvec2(-400, 400));
    EXPECT_NEAR(weight(1), 0.01, 1e-16);
}

TEST_F(CanvasModes, ctrl_catches_the_parameter_at_a_knot) {
    // C(1) = (-1, 0) with C'(1) = (2, -4): 8 px are 0.028 there.
    pointer.press(px(0, -1));
    pointer.move(px(-0.96, -0.08));
    EXPECT_NEAR(state().parameter(), 1.02, 0.001);
    pointer.modifiers = ctrl;
    pointer.move(px(-0.961, -0.08));
    EXPECT_EQ(state().parameter(), 1.0);
    pointer.move(px(-0.8, -0.39));
    EXPECT_NEAR(state().parameter(), 1.1, 0.01) << "too far";
    pointer.release(px(-0.8, -0.39));
}

TEST_F(CanvasModes, ctrl_keeps_weights_to_two_digits) {
    pointer.modifiers = {true, false, true};
    const auto weight_at = [&](double moved_px) {
        pointer.press(px(-2, 2));
        pointer.move(px(-2, 2) + glm::dvec2(moved_px, 0.0));
        pointer.release(px(-2, 2) + glm::dvec2(moved_px, 0.0));
        const double found = weight(1);
        editor.run(Undo{});
        return found;
    };
    EXPECT_EQ(weight_at(95.0), 3.0);     // 10^0.475 = 2.985
    EXPECT_EQ(weight_at(-60.0), 0.5);    // 0.501
    EXPECT_EQ(weight_at(-140.0), 0.2);   // 0.1995
    EXPECT_EQ(weight_at(-190.0), 0.11);  // 0.1122
    EXPECT_EQ(weight_at(230.0), 14.0);   // 14.13
}

TEST_F(CanvasModes, weights_stay_within_twelve_decades) {
    pointer.modifiers = alt;
    pointer.drag(px(-2, 2), px(-2, 2) + glm::dvec2(2000, -2000));
    EXPECT_EQ(weight(1), 1e6);
    pointer.drag(px(-2, 2), px(-2, 2) - glm::dvec2(9000, -9000));
    EXPECT_EQ(weight(1), 1e-6);
}

TEST_F(CanvasModes, weight_drag_is_scaled_with_the_interface_and_given_up_by_escape) {
    editor.change(SetInterfaceScale{2.0});
    pointer.modifiers = alt;
    pointer.drag(px(-2, 2), px(-2, 2) + glm::dvec2(400, 0));
    EXPECT_NEAR(weight(1), 10.0, 1e-14);
    pointer.press(px(-2, 2));
    pointer.move(px(0, 2));
    EXPECT_GT(state().active_curve()->weights()[1], 10.0);
    pointer.escape(px(0, 2));
    EXPECT_EQ(state().active_curve(), &committed(editor));
}

TEST_F(CanvasModes, the_ring_of_a_selected_point_drags_its_weight) {
    pointer.click(px(-2, 2));
    const glm::dvec2 on_ring = px(-2, 2) + glm::dvec2(0, -12);
    pointer.drag(on_ring, on_ring + glm::dvec2(200, 0));
    EXPECT_NEAR(weight(1), 10.0, 1e-14);
}

TEST_F(CanvasModes, box_selects_points_and_shift_adds_them) {
    pointer.drag(px(-4.5, 3), px(-1.5, -3));
    EXPECT_EQ(selected(), (Indices{0, 1}));
    pointer.modifiers = shift;
    pointer.drag(px(3, 3), px(1.5, 1));
    EXPECT_EQ(selected(), (Indices{0, 1, 3}));
    EXPECT_EQ(steps(), 0U);
}

TEST_F(CanvasModes, box_shows_where_it_is_and_escape_keeps_the_selection) {
    pointer.click(px(2, 2));
    pointer.press(px(-4.5, 3));
    pointer.move(px(-1.5, -3));
    ASSERT_TRUE(is_in<BoxSelecting>());
    EXPECT_EQ(std::get<BoxSelecting>(pointer.mode()).press_px, px(-4.5, 3));
    EXPECT_EQ(std::get<BoxSelecting>(pointer.mode()).position_px, px(-1.5, -3));
    pointer.escape(px(-1.5, -3));
    EXPECT_EQ(selected(), Indices{3});
}

TEST_F(CanvasModes, click_on_the_empty_canvas_clears_the_selection_unless_shift_is_held) {
    pointer.click(px(2, 2));
    pointer.modifiers = shift;
    pointer.click(px(-4.5, 3));
    EXPECT_EQ(selected(), Indices{3});
    pointer.modifiers = {};
    pointer.click(px(-4.5, 3));
    EXPECT_TRUE(selected().empty());
}

TEST_F(CanvasModes, hidden_points_are_neither_grabbed_nor_boxed) {
    editor.run(ToggleOverlay<Overlay::polygon>{});
    pointer.drag(px(-2, 2), px(-1, 2.5));
    pointer.drag(px(-4.5, 3), px(-1.5, -3));
    EXPECT_TRUE(selected().empty());
    EXPECT_EQ(steps(), 0U);
}

TEST_F(CanvasModes, the_wheel_zooms_about_the_pointer) {
    const glm::dvec2 at = px(2, 2);
    const glm::dvec2 before = render::world_from_screen(state().view.camera, at);
    pointer.send(PointerAction::wheel, at, 2.0);
    EXPECT_NEAR(state().view.camera.scale, 64.0 * 1.15 * 1.15, 1e-12);
    const glm::dvec2 after = render::world_from_screen(state().view.camera, at);
    EXPECT_NEAR(after.x, before.x, 1e-14);
    EXPECT_NEAR(after.y, before.y, 1e-14);
}

TEST_F(CanvasModes, a_sideways_wheel_pans_and_so_does_one_with_shift) {
    const glm::dvec2 before = render::screen_from_world(state().view.camera, {0.0, 0.0});
    const auto moved = [&] { return render::screen_from_world(state().view.camera, {0.0, 0.0}) - before; };
    pointer.turn_sideways(px(1, 1), 2.0, 0.5);
    EXPECT_EQ(moved(), glm::dvec2(120.0, 0.0)) << "to the left: what is there comes in, and nothing zooms";
    EXPECT_EQ(state().view.camera.scale, 64.0);
    pointer.modifiers.shift = true;
    pointer.send(PointerAction::wheel, px(1, 1), -3.0);
    EXPECT_EQ(moved(), glm::dvec2(-60.0, 0.0));
    pointer.modifiers.shift = false;
    pointer.turn_sideways(px(0, 0), 0.25, 1.0);
    EXPECT_NEAR(state().view.camera.scale, 64.0 * 1.15, 1e-12) << "mostly upward: it zooms";
}

TEST_F(CanvasModes, hover_is_asked_for_only_when_it_changes) {
    pointer.move(px(-2, 2));
    EXPECT_EQ(state().hover, Hover{HoveredPoint{1}});
    pointer.move(px(-2, 2) + glm::dvec2(1, 1));
    EXPECT_FALSE(pointer.was_asked());
    pointer.send(PointerAction::leave, px(-2, 2));
    EXPECT_EQ(state().hover, Hover{HoveredNothing{}});
    pointer.send(PointerAction::leave, px(-2, 2));
    EXPECT_FALSE(pointer.was_asked());
}

TEST_F(CanvasModes, every_hovered_thing_of_the_canvas_arrives_in_the_state) {
    pointer.move(px(0, -1));
    EXPECT_EQ(state().hover, Hover{HoveredParameter{}});
    pointer.move(px(-1, 0));
    EXPECT_EQ(state().hover, Hover{HoveredKnot{3}});
    pointer.move(px(-3, 0));
    EXPECT_EQ(state().hover, Hover{HoveredLeg{0}});
    const core::Point at = core::point_at(*first_curve, 0.5);
    pointer.move(px(at.x, at.y));
    ASSERT_TRUE(std::holds_alternative<HoveredCurve>(state().hover));
    EXPECT_NEAR(std::get<HoveredCurve>(state().hover).u, 0.5, 1e-9);
}

TEST_F(CanvasModes, a_locked_curve_is_not_changed_and_says_why) {
    editor.run(SetCurveLocked{.index = 0, .locked = true});
    const std::shared_ptr<const core::Curve> locked = state().history.present().active_curve()->curve;
    pointer.drag(px(-2, 2), px(0, 2));
    pointer.modifiers = alt;
    pointer.drag(px(-2, 2), px(0, 2));
    EXPECT_EQ(state().shown().active_curve()->curve, locked);
    EXPECT_NE(canvas_hint(pointer.mode(), state()).find("locked"), std::string::npos);
}

TEST_F(CanvasModes, undoing_in_the_middle_of_a_drag_is_safe) {
    pointer.press(px(4, -2));
    pointer.move(px(4, 0));
    editor.run(Undo{});
    editor.run(Undo{});
    pointer.move(px(4, 1));
    pointer.release(px(4, 1));
    EXPECT_TRUE(is_in<CanvasIdle>());
}

}  // namespace
}  // namespace batten::editor
