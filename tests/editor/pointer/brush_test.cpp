#include "app/editor/pointer/brush.h"

#include <gtest/gtest.h>

#include "app/editor/commands/axis_commands.h"
#include "app/editor/commands/brush_commands.h"
#include "app/editor/commands/closing_commands.h"
#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/drawing_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/fairing_commands.h"
#include "app/editor/commands/fit_point_commands.h"
#include "app/editor/commands/overlay_commands.h"
#include "app/editor/commands/pin_commands.h"
#include "app/editor/commands/tool_commands.h"
#include "app/editor/commands/unit_commands.h"
#include "app/editor/pointer/placing_step.h"
#include "core/edit/fair.h"
#include "core/evaluate/evaluate.h"
#include "tests/editor/canvas_fixture.h"

namespace batten::editor {
namespace {

using test::committed;
using test::px;

/// A brush of five world units, 320 pixels, over the zigzag (-4,-2) (-2,2) (0,-2) (2,2) (4,-2).
class BrushTest : public test::CanvasFixture {
  protected:
    BrushTest() {
        editor.run(SetBrushSize{.radius = 320});
        editor.run(UseBrush<BrushKind::soft_move>{});
    }
    const Brushing& brushing() const { return std::get<Brushing>(pointer.mode()); }
    double share_of(std::size_t i) const {
        for (const HeldPoint& held : brushing().held)
            if (held.index == i) return held.share;
        return 0.0;
    }
};

TEST_F(BrushTest, tells_what_it_would_hold) {
    pointer.move(px(-2.05, 2.02));
    EXPECT_EQ(brushing().center, core::Point(-2, 2));
    // (1 - d^2 / 25)^2.
    EXPECT_EQ(share_of(1), 1.0);
    EXPECT_NEAR(share_of(0), 0.04, 1e-15);
    EXPECT_NEAR(share_of(2), 0.04, 1e-15);
    EXPECT_NEAR(share_of(3), 0.1296, 1e-15);
    EXPECT_EQ(share_of(4), 0.0);
    EXPECT_EQ(steps(), 0U);
}

TEST_F(BrushTest, points_follow_the_less_the_farther_they_are) {
    pointer.press(px(-2, 2));
    pointer.move(px(-2, 3));
    EXPECT_EQ(state().shown().active_curve()->curve->control_points()[1], core::Point(-2, 3));
    EXPECT_EQ(point(1), core::Point(-2, 2));
    pointer.release(px(-2, 3));
    EXPECT_EQ(point(1), core::Point(-2, 3));
    EXPECT_NEAR(point(0).y, -1.96, 1e-15);
    EXPECT_NEAR(point(2).y, -1.96, 1e-15);
    EXPECT_NEAR(point(3).y, 2.1296, 1e-15);
    EXPECT_EQ(point(4), core::Point(4, -2));
    EXPECT_EQ(steps(), 1U);
    editor.run(Undo{});
    EXPECT_EQ(committed(editor), *first_curve);
}

TEST_F(BrushTest, nothing_is_read_beside_it_after_the_drag) {
    pointer.drag(px(-2, 2), px(-2, 3));
    EXPECT_FALSE(state().placing.place);
    pointer.press(px(-2, 3));
    pointer.move(px(-2, 3.5));
    EXPECT_TRUE(state().placing.place);
    type(U"x0\t1\n", px(-2, 3.5));
    EXPECT_EQ(point(1), core::Point(-2, 4));
    EXPECT_EQ(steps(), 2U);
    EXPECT_FALSE(state().placing.place);
    EXPECT_TRUE(state().placing.typed.is_empty());
    pointer.release(px(-2, 3.5));
    pointer.move(px(0, 0));
    EXPECT_FALSE(state().placing.place);
    EXPECT_EQ(steps(), 2U);
}

TEST_F(BrushTest, leaves_rulers_to_guides_and_axes_to_clicks) {
    editor.run(ToggleOverlay<Overlay::rulers>{});
    pointer.move(px(0, 0));
    EXPECT_TRUE(is_in<Brushing>());
    pointer.move({640.0, -5.0});
    EXPECT_TRUE(std::holds_alternative<HoveredRuler>(state().hover));
    EXPECT_TRUE(is_in<CanvasIdle>());
    pointer.move(px(0, 0));
    EXPECT_TRUE(is_in<Brushing>());
    EXPECT_FALSE(std::holds_alternative<HoveredRuler>(state().hover));
    pointer.press({640.0, -5.0});
    pointer.move(px(0.03, 1.02));
    pointer.release(px(0.03, 1.02));
    ASSERT_EQ(state().history.present().guides.size(), 1U);
    EXPECT_EQ(committed(editor), *first_curve);
    pointer.move(px(0, 0));
    editor.run(PickMirror{});
    pointer.click(px(5, -3));
    pointer.click(px(5, 1));
    EXPECT_EQ(point(0), core::Point(14, -2));
}

TEST_F(BrushTest, a_menu_interrupts_no_drag) {
    EXPECT_TRUE(is_at_rest(pointer.mode()));
    pointer.move(px(0, 0));
    EXPECT_TRUE(is_at_rest(pointer.mode()));
    pointer.press(px(-2, 2));
    EXPECT_FALSE(is_at_rest(pointer.mode()));
    pointer.release(px(-2, 2));
    EXPECT_TRUE(is_at_rest(pointer.mode()));
}

TEST_F(BrushTest, pinned_points_stay) {
    editor.run(PinPoints{.points = {3}});
    pointer.drag(px(-2, 2), px(-2, 3));
    EXPECT_EQ(point(3), core::Point(2, 2));
    EXPECT_EQ(point(1), core::Point(-2, 3));
}

TEST_F(BrushTest, the_wheel_and_brackets_change_it_also_in_mid_drag) {
    pointer.move(px(-2, 2));
    pointer.send(PointerAction::wheel, px(-2, 2), 1.0);
    EXPECT_NEAR(state().view.brush.radius, 320 * 1.15, 1e-9);
    type(U"[", px(-2, 2));
    EXPECT_NEAR(state().view.brush.radius, 320, 1e-9);
    const double scale = state().view.camera.scale;
    pointer.modifiers = test::ctrl;
    pointer.send(PointerAction::wheel, px(0, 0), 1.0);
    EXPECT_GT(state().view.camera.scale, scale);
    pointer.send(PointerAction::wheel, px(0, 0), -1.0);
    pointer.modifiers = {};
    pointer.press(px(-2, 2));
    pointer.move(px(-2, 3));
    pointer.send(PointerAction::wheel, px(-2, 3), -5.0);
    // 320 / 1.15^5 is two and a half units: nothing else is within it.
    EXPECT_EQ(state().shown().active_curve()->curve->control_points()[3], core::Point(2, 2));
    pointer.release(px(-2, 3));
    EXPECT_EQ(point(0), core::Point(-4, -2));
    EXPECT_EQ(point(1), core::Point(-2, 3));
    for (int k = 0; k < 100; ++k) pointer.send(PointerAction::wheel, px(0, 0), -1.0);
    EXPECT_EQ(state().view.brush.radius, 4.0);
}

TEST_F(BrushTest, nothing_stays_lit_that_was_under_the_pointer_before) {
    for (const Tool tool : {Tool::brush, Tool::joint}) {
        editor.run(SetTool{.tool = Tool::select});
        pointer.move(px(-2, 2));
        ASSERT_EQ(state().hover, Hover(HoveredPoint{1}));
        editor.run(SetTool{.tool = tool});
        pointer.move(px(3, -3));
        EXPECT_EQ(state().hover, Hover(HoveredNothing{}));
    }
}

TEST_F(BrushTest, keys_in_the_place_of_brackets_change_it_where_none_are_printed) {
    pointer.move(px(-2, 2));
    for (const Key key : {Key::right_bracket, Key::right_bracket, Key::left_bracket}) {
        PointerEvent event;
        event.action = PointerAction::key;
        event.position_px = px(-2, 2);
        event.key = key;
        EXPECT_TRUE(takes_key(pointer.mode(), state(), event));
        pointer.send(event);
    }
    EXPECT_NEAR(state().view.brush.radius, 320 * 1.15, 1e-9);
}

TEST_F(BrushTest, typed_numbers_and_escape) {
    pointer.press(px(-2, 2));
    pointer.move(px(-2, 3));
    type(U"0.5<0\n", px(-2, 3));
    EXPECT_EQ(point(1), core::Point(-1.5, 2));
    EXPECT_EQ(steps(), 1U);
    pointer.press(px(-1.5, 2));
    pointer.move(px(0, 3));
    pointer.escape(px(0, 3));
    EXPECT_FALSE(state().preview);
    EXPECT_EQ(steps(), 1U);
    pointer.escape(px(0, 3));
    EXPECT_EQ(state().tool, Tool::select);
}

TEST_F(BrushTest, part_within_ends_where_the_curve_leaves_the_circle) {
    const core::Curve line =
        core::Curve::make({.degree = 1, .knots = {0, 0, 10, 10}, .points = {{0, 0}, {10, 0}}}).value();
    const auto part = part_within(line, 5.0, {5, 0}, 2.0);
    ASSERT_TRUE(part);
    // By steps of an eighth of the radius, not beyond it.
    EXPECT_GE(part->lower, 3.0);
    EXPECT_LE(part->lower, 3.25);
    EXPECT_LE(part->upper, 7.0);
    EXPECT_GE(part->upper, 6.75);
    EXPECT_EQ(part_within(line, 0.0, {0, 0}, 2.0)->lower, 0.0);
    EXPECT_FALSE(part_within(line, 5.0, {5, 3}, 2.0));
}

TEST_F(BrushTest, painted_parts_grow_where_they_touch_also_over_the_seam) {
    const core::Curve open =
        core::Curve::make({.degree = 1, .knots = {0, 0, 10, 10}, .points = {{0, 0}, {10, 0}}}).value();
    EXPECT_EQ(painted_over(open, {2, 4}, {3, 6}), (core::Interval{2, 6}));
    EXPECT_EQ(painted_over(open, {2, 4}, {5, 6}), (core::Interval{2, 4}));
    const core::Curve closed = core::Curve::make(test::closed_cubic()).value();
    EXPECT_EQ(painted_over(closed, {5, 6}, {-0.5, 0.5}), (core::Interval{5, 6.5}));
    EXPECT_EQ(painted_over(closed, {0, 1}, {5, 6}), (core::Interval{5, 7}));
    EXPECT_EQ(painted_over(closed, {1, 5}, {4, 8}), (core::Interval{1, 7}));
}

/// A wave of 21 points with a dent.
class FairingBrush : public BrushTest {
  protected:
    FairingBrush() {
        std::vector<core::Point> points;
        for (int i = 0; i <= 20; ++i) points.push_back({0.4 * (i - 10), i == 10 ? 0.8 : 0.02 * (i - 10) * (i - 10)});
        editor.run(NewCurve{.points = points, .degree = 3});
        editor.run(UseBrush<BrushKind::fair>{});
        editor.run(SetBrushSize{.radius = 40});
        first_steps = state().history.undo_count();
    }
};

TEST_F(FairingBrush, fairs_the_part_that_was_painted_over) {
    const core::Curve before = committed(editor);
    pointer.press(px(-1.2, 0.2));
    pointer.move(px(0, 0.5));
    ASSERT_TRUE(brushing().painted);
    EXPECT_FALSE(state().preview);
    pointer.move(px(1.2, 0.2));
    const core::Interval painted = *brushing().painted;
    EXPECT_LT(core::point_at(before, painted.lower).x, -1.2);
    EXPECT_GT(core::point_at(before, painted.upper).x, 1.2);
    EXPECT_LT(core::point_at(before, painted.upper).x, 2.0);
    pointer.release(px(1.2, 0.2));
    EXPECT_EQ(steps(), 1U);
    const double distance = brush_distance(state());
    EXPECT_EQ(committed(editor), core::fair_part(before, painted, distance).value().curve);
    EXPECT_LT(point(10).y, 0.8);
    EXPECT_EQ(point(0), before.control_points()[0]);
    EXPECT_EQ(point(20), before.control_points()[20]);
    // Another distance, in the same step.
    ASSERT_TRUE(editor.run(RefairPart{.distance = 3.0 * distance}));
    EXPECT_EQ(steps(), 1U);
    EXPECT_EQ(committed(editor), core::fair_part(before, painted, 3.0 * distance).value().curve);
    EXPECT_EQ(brush_distance(state()), 3.0 * distance);
    EXPECT_FALSE(editor.run(RefairPart{.distance = 0.0}));
    editor.run(Undo{});
    EXPECT_EQ(committed(editor), before);
    EXPECT_FALSE(editor.run(RefairPart{.distance = distance}));
    EXPECT_EQ(state().message.text, "the last step faired no part; paint over one with the fairing brush first");
}

TEST_F(FairingBrush, fairing_again_keeps_given_tangents_and_tells_the_unit) {
    std::vector<core::Point> points;
    for (int i = 0; i <= 8; ++i) points.push_back({i - 4.0, i % 2 == 0 ? 0.0 : 0.6});
    ASSERT_TRUE(editor.run(ThroughPoints{.points = points}));
    ASSERT_TRUE(
        editor.run(SetFitJoint{.index = 4, .joint = core::FitJoint::tangent, .handle = core::Vector(1.0, 1.0)}));
    ASSERT_TRUE(editor.run(SetUnits{.unit = UnitChoice::mm, .scale = 2.0}));
    const double u = state().history.present().active_curve()->fit->parameters[4];
    const core::Vector given = core::derivatives_at(committed(editor), u, 1)[1];
    const core::Interval domain = committed(editor).domain();
    ASSERT_TRUE(editor.run(FairPart{.from = domain.lower, .to = domain.upper, .distance = 0.05}));
    ASSERT_TRUE(editor.run(RefairPart{.distance = 0.5})) << state().message.text;
    const core::Vector now = core::derivatives_at(committed(editor), u, 1)[1];
    EXPECT_NEAR(now.x, given.x, 1e-12);
    EXPECT_NEAR(now.y, given.y, 1e-12);
    EXPECT_EQ(state().message.text.rfind("Faired the part within 0.25 mm; ", 0), 0U) << state().message.text;
}

TEST_F(FairingBrush, a_fast_stroke_has_no_gaps) {
    pointer.press(px(-1.6, 0.3));
    pointer.release(px(1.6, 0.3));
    const core::Interval part = state().faired->part;
    EXPECT_LT(core::point_at(*state().history.previous().active_curve()->curve, part.lower).x, -1.6);
    EXPECT_GT(core::point_at(*state().history.previous().active_curve()->curve, part.upper).x, 1.6);
}

TEST_F(FairingBrush, beside_the_curve_nothing_happens) {
    pointer.drag(px(-3, -3), px(3, -3));
    EXPECT_EQ(steps(), 0U);
    editor.run(SetCurveLocked{.index = state().history.present().active, .locked = true});
    pointer.press(px(0, 0.5));
    EXPECT_NE(state().message.text.find("is locked; unlock it"), std::string::npos) << state().message.text;
}

TEST_F(FairingBrush, over_the_seam_of_a_closed_curve) {
    std::vector<core::Point> points;
    for (int i = 0; i < 16; ++i) {
        const double angle = 2.0 * 3.14159265358979 * i / 16.0;
        const double radius = i == 0 ? 2.4 : 2.0;
        points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    editor.run(NewCurve{.points = points, .degree = 3, .closed = true});
    first_steps = state().history.undo_count();
    const core::Point seam = core::point_at(committed(editor), committed(editor).domain().lower);
    pointer.drag(px(seam.x, seam.y - 0.6), px(seam.x, seam.y + 0.6));
    EXPECT_EQ(steps(), 1U);
    const core::Interval part = state().faired->part;
    const core::Interval domain = committed(editor).domain();
    EXPECT_LT(part.lower, domain.upper);
    EXPECT_GT(part.upper, domain.upper);
}

TEST_F(BrushTest, without_a_curve_nothing_happens) {
    Editor empty;
    test::CanvasPointer idle{empty, test::CanvasStep{}};
    for (const Command& brush : {Command(UseBrush<BrushKind::soft_move>{}), Command(UseBrush<BrushKind::fair>{})}) {
        empty.run(brush);
        idle.drag(px(-2, 2), px(2, -2));
        EXPECT_EQ(empty.state().history.undo_count(), 0U);
        EXPECT_EQ(empty.state().message.text, "there is no curve; draw one or open a file");
    }
}

}  // namespace
}  // namespace batten::editor
