#include "app/editor/pointer/handlebar.h"

#include <gtest/gtest.h>

#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/drawing_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/overlay_commands.h"
#include "app/editor/commands/pin_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/tool_commands.h"
#include "app/editor/pointer/context_menu.h"
#include "app/editor/pointer/hit_test.h"
#include "core/evaluate/evaluate.h"
#include "tests/editor/canvas_fixture.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

using test::committed;

void expect_near(core::Point a, core::Point b, double tolerance = 1e-12) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
}

/// Of the zigzag C(1.5) = (0, -1) and C'(1.5) = (P3 - P1) / 2 = (2, 0); its functions there are 1/8, 3/4, 1/8.
class HandlebarTest : public test::CanvasFixture {
  protected:
    HandlebarTest() { editor.run(SetParameter{.u = 0.2}); }

    glm::dvec2 at(double x, double y) const { return render::screen_from_world(state().view.camera, {x, y}); }
    void show(double u) { editor.run(ShowHandlebar{.u = u}); }
    void open(core::CurveDefinition definition) {
        core::Document document;
        core::DocumentCurve& entry = document.curves.emplace_back();
        entry.name = "curve";
        entry.curve = std::make_shared<const core::Curve>(core::Curve::make(std::move(definition)).value());
        editor.run(NewDocument{});
        editor.run(AnswerUnsaved{.answer = UnsavedAnswer::discard});
        open_text(editor, core::format_document(document));
        editor.change(ZoomCamera{64.0 / state().view.camera.scale, at(0, 0)});
        first_steps = 0;
    }
    Handlebar bar() const { return shown_handlebar(state()).value(); }
    core::Vector derivative(double u, core::Side side = core::Side::right) const {
        return core::derivatives_at(committed(editor), u, 1, side)[1];
    }
};

core::CurveDefinition two_cubics(core::Point before, core::Point after) {
    return {.degree = 3,
            .knots = {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2},
            .points = {{-6, 0}, {-5, 3}, before, {0, 0}, after, {5, 3}, {6, 0}}};
}

TEST_F(HandlebarTest, a_click_on_the_curve_shows_it) {
    pointer.click(at(0, -1));
    ASSERT_TRUE(state().selection.handlebar);
    EXPECT_NEAR(*state().selection.handlebar, 1.5, 1e-9);
    EXPECT_EQ(steps(), 0U);
    // Half as long as the legs of the Bézier piece, which are half of C'.
    expect_near(bar().place, {0, -1}, 1e-9);
    expect_near(bar().ahead->tip, {0.5, -1}, 1e-9);
    expect_near(bar().behind->tip, {-0.5, -1}, 1e-9);
    EXPECT_FALSE(bar().is_kinked);
    EXPECT_EQ(state().hover, Hover(HoveredHandlebar{HandlebarPart::middle}));
    EXPECT_TRUE(canvas_hint(pointer.mode(), state()).starts_with("Drag to move the curve here"));
    EXPECT_EQ(hit_canvas(state(), at(0.5, -1)), Hover(HoveredHandlebar{HandlebarPart::ahead}));
    EXPECT_EQ(hit_canvas(state(), at(-0.5, -1)), Hover(HoveredHandlebar{HandlebarPart::behind}));
    EXPECT_EQ(hit_canvas(state(), at(0, -1)), Hover(HoveredHandlebar{HandlebarPart::middle}));
    pointer.click(at(5, 3));
    EXPECT_FALSE(state().selection.handlebar);
}

TEST_F(HandlebarTest, with_ctrl_a_click_is_at_the_knot) {
    editor.run(ToggleOverlay<Overlay::knots>{});
    pointer.modifiers = test::ctrl;
    const core::Point near_knot = core::point_at(committed(editor), 1.02);
    pointer.click(at(near_knot.x, near_knot.y));
    EXPECT_EQ(state().selection.handlebar, 1.0);
}

TEST_F(HandlebarTest, with_ctrl_a_click_on_a_corner_is_about_the_tangent_not_the_point) {
    open(two_cubics({-2, 3}, {2, 2}));
    pointer.click(at(0, 0));
    EXPECT_EQ(selected(), test::Indices{3});
    EXPECT_FALSE(state().selection.handlebar);
    pointer.modifiers = test::ctrl;
    pointer.click(at(0, 0) + glm::dvec2(5, 4));
    EXPECT_EQ(state().selection.handlebar, 1.0);
    EXPECT_EQ(selected(), test::Indices{});
    EXPECT_TRUE(bar().is_kinked);
    // The ends of the curve, too; not where it only passes by.
    pointer.click(at(6, 0));
    EXPECT_EQ(state().selection.handlebar, 2.0);
    pointer.click(at(5, 3));
    EXPECT_EQ(selected(), test::Indices{5});
    EXPECT_FALSE(state().selection.handlebar);
    EXPECT_EQ(steps(), 0U);
    // A drag is that of the point, on the grid.
    pointer.drag(at(6, 0), at(6.1, 2.05));
    EXPECT_EQ(point(6), core::Point(6, 2));
}

TEST_F(HandlebarTest, knows_through_which_points_a_curve_runs) {
    const auto smooth = core::Curve::make(test::cubic()).value();
    EXPECT_EQ(parameter_at_point(smooth, 0), 0.0);
    EXPECT_EQ(parameter_at_point(smooth, 6), 1.0);
    for (std::size_t i = 1; i < 6; ++i) EXPECT_FALSE(parameter_at_point(smooth, i)) << i;
    EXPECT_FALSE(parameter_at_point(smooth, 7));
    const auto closed =
        core::Curve::make({.degree = 1, .knots = {0, 1, 3, 4}, .points = {{0, 0}, {4, 0}, {0, 4}}, .periodic = true})
            .value();
    for (std::size_t i = 0; i < 3; ++i) {
        const auto u = parameter_at_point(closed, i);
        ASSERT_TRUE(u) << i;
        EXPECT_EQ(core::point_at(closed, *u), closed.control_points()[i]) << i;
    }
}

TEST_F(HandlebarTest, arms_stay_within_reach_and_off_control_points) {
    for (const double leg_px : {4.0, 19.0, 21.0, 39.0, 41.0, 100.0, 300.0, 5000.0}) {
        open({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {leg_px / 64.0, 0}}});
        show(0.0);
        const double arm_px = 64.0 * bar().ahead->tip.x;
        EXPECT_GE(arm_px, 20.0 - 1e-9) << leg_px;
        EXPECT_LE(arm_px, 160.0 + 1e-9) << leg_px;
        EXPECT_GE(std::abs(arm_px - leg_px), 20.0 - 1e-9) << leg_px;
    }
}

TEST_F(HandlebarTest, a_tip_turns_the_tangent_with_the_least_change) {
    show(1.5);
    pointer.press(at(0.5, -1));
    pointer.move(at(0.5, -0.5));
    EXPECT_EQ(state().shown().active_curve()->curve->control_points()[1], core::Point(-2, 0));
    EXPECT_EQ(point(1), core::Point(-2, 2));
    pointer.release(at(0.5, -0.5));
    expect_near(core::point_at(committed(editor), 1.5), {0, -1});
    expect_near(core::Point(derivative(1.5).x, derivative(1.5).y), {2, 2});
    EXPECT_EQ(point(1), core::Point(-2, 0));
    EXPECT_EQ(point(2), core::Point(0, -2));
    EXPECT_EQ(point(3), core::Point(2, 4));
    EXPECT_EQ(point(0), core::Point(-4, -2));
    EXPECT_EQ(point(4), core::Point(4, -2));
    EXPECT_EQ(steps(), 1U);
    expect_near(bar().ahead->tip, {0.5, -0.5});
}

TEST_F(HandlebarTest, the_tip_behind_is_the_opposite_one) {
    show(1.5);
    pointer.drag(at(-0.5, -1), at(-1, -1.5));
    // The arm ahead is then (1, 1/2), a quarter of C' = (4, 2).
    expect_near(core::Point(derivative(1.5).x, derivative(1.5).y), {4, 2});
    expect_near(bar().ahead->tip, {1, -0.5});
}

TEST_F(HandlebarTest, the_middle_moves_the_curve_and_keeps_the_tangent) {
    show(1.5);
    pointer.drag(at(0, -1), at(0, 0));
    // Shares 1/8, 3/4, 1/8 over the sum of their squares, 19/32.
    expect_near(point(1), {-2, 2.0 + 4.0 / 19.0});
    expect_near(point(2), {0, -2.0 + 24.0 / 19.0});
    expect_near(point(3), {2, 2.0 + 4.0 / 19.0});
    expect_near(core::point_at(committed(editor), 1.5), {0, 0});
    expect_near(core::Point(derivative(1.5).x, derivative(1.5).y), {2, 0});
    EXPECT_EQ(steps(), 1U);
    editor.run(Undo{});
    EXPECT_EQ(*state().history.present().active_curve()->curve, *first_curve);
}

TEST_F(HandlebarTest, off_the_middle_of_a_span_the_tangent_stays_too) {
    show(1.25);
    const core::Vector before = derivative(1.25);
    const core::Point place = bar().place;
    pointer.drag(at(place.x, place.y), at(place.x + 1, place.y + 0.5));
    expect_near(core::point_at(committed(editor), 1.25), place + core::Vector(1, 0.5));
    expect_near(core::Point(derivative(1.25).x, derivative(1.25).y), core::Point(before.x, before.y));
}

TEST_F(HandlebarTest, escape_restores_and_a_click_does_nothing) {
    show(1.5);
    pointer.press(at(0.5, -1));
    pointer.move(at(2, 2));
    pointer.escape(at(2, 2));
    pointer.click(at(0.5, -1));
    EXPECT_EQ(steps(), 0U);
    EXPECT_FALSE(state().preview);
    EXPECT_EQ(state().selection.handlebar, 1.5);
}

TEST_F(HandlebarTest, typed_length_and_angle_are_those_of_the_arm) {
    show(1.5);
    pointer.press(at(0.5, -1));
    pointer.move(at(1.5, -0.5));
    type(U"2<90\n", at(1.5, -0.5));
    expect_near(core::Point(derivative(1.5).x, derivative(1.5).y), {0, 8});
    EXPECT_EQ(steps(), 1U);
}

TEST_F(HandlebarTest, shift_keeps_the_arm_level_or_upright) {
    show(1.5);
    pointer.modifiers = test::shift;
    pointer.drag(at(0.5, -1), at(0.6, 1));
    expect_near(core::Point(derivative(1.5).x, derivative(1.5).y), {0, 8});
}

TEST_F(HandlebarTest, pinned_points_stay) {
    editor.run(PinPoints{.points = {1}});
    first_steps = state().history.undo_count();
    show(1.5);
    pointer.drag(at(0.5, -1), at(0.5, -0.5));
    EXPECT_EQ(point(1), core::Point(-2, 2));
    expect_near(core::Point(derivative(1.5).x, derivative(1.5).y), {2, 2});
    expect_near(core::point_at(committed(editor), 1.5), {0, -1});
    // Two of three: the place can be moved, the tangent not be kept.
    editor.run(PinPoints{.points = {3}});
    const core::Point place = bar().place;
    pointer.drag(at(place.x, place.y), at(place.x, place.y + 1));
    expect_near(core::point_at(committed(editor), 1.5), place + core::Vector(0, 1));
    EXPECT_EQ(point(1), core::Point(-2, 2));
}

TEST_F(HandlebarTest, a_corner_has_two_arms_of_its_own) {
    open(two_cubics({-2, 3}, {2, 2}));
    show(1.0);
    ASSERT_TRUE(bar().is_kinked);
    expect_near(bar().behind->tip, {-1, 1.5});
    expect_near(bar().ahead->tip, {1, 1});
    pointer.drag(at(1, 1), at(1.5, -0.5));
    expect_near(point(4), {3, -1});
    EXPECT_EQ(point(2), core::Point(-2, 3));
    EXPECT_EQ(point(3), core::Point(0, 0));
    pointer.drag(at(-1, 1.5), at(-1, 0.5));
    expect_near(point(2), {-2, 1});
    expect_near(point(4), {3, -1});
    EXPECT_EQ(point(3), core::Point(0, 0));
    pointer.drag(at(0, 0), at(0, 1));
    expect_near(point(3), {0, 1});
    EXPECT_EQ(steps(), 3U);
}

TEST_F(HandlebarTest, a_smooth_joint_of_pieces_stays_smooth) {
    open(two_cubics({-2, -1}, {4, 2}));
    show(1.0);
    ASSERT_FALSE(bar().is_kinked);
    pointer.drag(at(2, 1), at(1.5, 1.5));
    expect_near(point(4), {3, 3}, 1e-9);
    EXPECT_NEAR(core::cross(derivative(1.0, core::Side::left), derivative(1.0)), 0.0, 1e-8);
    EXPECT_GT(core::dot(derivative(1.0, core::Side::left), derivative(1.0)), 1.0);
    expect_near(point(3), {0, 0}, 1e-9);
}

TEST_F(HandlebarTest, ends_of_open_curves_have_one_arm_and_closed_ones_two) {
    show(0.0);
    EXPECT_TRUE(bar().ahead);
    EXPECT_FALSE(bar().behind);
    show(3.0);
    EXPECT_FALSE(bar().ahead);
    EXPECT_TRUE(bar().behind);
    open(test::closed_cubic());
    show(0.0);
    EXPECT_TRUE(bar().ahead && bar().behind && !bar().is_kinked);
    const HandlebarArm arm = *bar().behind;
    pointer.drag(at(arm.tip.x, arm.tip.y), at(arm.tip.x - 0.25, arm.tip.y));
    EXPECT_EQ(steps(), 1U);
    expect_near(bar().place + arm.reach * derivative(0.0), arm.tip - core::Vector(0.25, 0), 1e-9);
    open({.degree = 2, .knots = {0, 0, 0, 1, 2, 2, 2}, .points = {{0, 0}, {3, 0}, {3, 3}, {0, 0}}});
    show(0.0);
    ASSERT_TRUE(bar().is_kinked);
    // The arm behind is that of the last span.
    expect_near(bar().behind->tip, {1.5, 1.5});
    pointer.drag(at(1.5, 1.5), at(0.5, 1.5));
    expect_near(point(2), {1, 3});
    EXPECT_EQ(point(1), core::Point(3, 0));
}

TEST_F(HandlebarTest, of_rational_and_straight_curves) {
    open({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{4, 0}, {4, 4}, {0, 4}}, .weights = {1, 0.5, 2}});
    show(0.4);
    const core::Point tip = bar().ahead->tip;
    pointer.drag(at(tip.x, tip.y), at(tip.x + 0.5, tip.y + 0.25));
    expect_near(bar().ahead->tip, tip + core::Vector(0.5, 0.25), 1e-9);
    open({.degree = 1, .knots = {0, 0, 1, 2, 2}, .points = {{-4, 0}, {0, 2}, {4, 0}}});
    show(0.5);
    EXPECT_EQ(bar().place, core::Point(-2, 1));
    pointer.drag(at(-2, 1), at(-2, 2));
    EXPECT_EQ(point(0), core::Point(-4, 1));
    EXPECT_EQ(point(1), core::Point(0, 3));
    show(1.0);
    EXPECT_TRUE(bar().is_kinked);
}

TEST_F(HandlebarTest, short_arms_are_drawn_out_and_lead_as_far_as_they_look) {
    editor.change(ZoomCamera{1.0 / 16.0, at(0, 0)});
    show(1.5);
    // A world unit is four pixels now; the arms have 40.
    expect_near(bar().ahead->tip, {10, -1}, 1e-9);
    pointer.drag(at(10, -1), at(20, -1));
    expect_near(core::Point(derivative(1.5).x, derivative(1.5).y), {4, 0}, 1e-9);
}

TEST_F(HandlebarTest, a_double_click_inserts_a_knot_and_a_right_click_offers_the_place) {
    show(1.5);
    pointer.double_click(at(0, -1));
    EXPECT_EQ(committed(editor).knots().multiplicity(1.5), 1);
    show(1.2);
    const auto menu = context_menu(state(), OnCanvas{HoveredHandlebar{}, {0, -1}});
    EXPECT_TRUE(std::ranges::any_of(menu, [](const MenuEntry& entry) { return entry.spec == &InsertKnot::spec(); }));
}

TEST_F(HandlebarTest, is_not_there_for_other_tools_curves_or_fit_points) {
    show(1.5);
    editor.run(SetTool{.tool = Tool::insert_knot});
    EXPECT_FALSE(shown_handlebar(state()));
    editor.run(SetTool{.tool = Tool::select});
    EXPECT_TRUE(shown_handlebar(state()));
    editor.run(SetKnots{.knots = {0, 0, 0, 0.5, 0.75, 1, 1, 1}});
    EXPECT_FALSE(state().selection.handlebar);
    editor.run(ThroughPoints{.points = {{-4, 0}, {-1, 2}, {1, -1}, {4, 1}}});
    EXPECT_FALSE(editor.run(ShowHandlebar{.u = 0.5}));
    EXPECT_EQ(state().message.text, "the curve is made of fit points; drag these, or make it an ordinary curve");
}

TEST_F(HandlebarTest, holds_a_curve_of_10000_points) {
    core::CurveDefinition definition{.degree = 3};
    for (int i = 0; i < 10'000; ++i) definition.points.push_back({0.01 * i - 5.0, i % 2 == 0 ? 0.5 : -0.5});
    for (int i = 0; i < 10'004; ++i) definition.knots.push_back(i);
    open(std::move(definition));
    show(500.5);
    // A tip is 40 pixels from the place however dense the points are.
    EXPECT_NEAR(core::distance(bar().place, bar().ahead->tip), 40.0 / state().view.camera.scale, 1e-9);
    const Handlebar old = bar();
    const core::Point tip = old.ahead->tip;
    const core::Curve before = committed(editor);
    pointer.modifiers = test::alt;
    pointer.drag(at(tip.x, tip.y), at(tip.x, tip.y + 0.5));
    const core::Vector wanted = (tip + core::Vector(0, 0.5) - old.place) / old.ahead->reach;
    expect_near(core::tip_of(derivative(500.5)), core::tip_of(wanted), 1e-9);
    for (std::size_t i = 0; i < 10'000; ++i)
        if (i < 497 || i > 501) {
            ASSERT_EQ(point(i), before.control_points()[i]) << i;
        }
}

}  // namespace
}  // namespace batten::editor
