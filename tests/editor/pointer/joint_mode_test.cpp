#include "app/editor/pointer/joint_mode.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/joint_tool_commands.h"
#include "app/editor/commands/making_commands.h"
#include "app/editor/commands/overlay_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/tool_commands.h"
#include "app/editor/commands/unit_commands.h"
#include "app/editor/pointer/joint_reading.h"
#include "app/editor/pointer/place_text.h"
#include "app/editor/words/reading_text.h"
#include "core/measure/area.h"
#include "core/measure/continuity.h"
#include "core/measure/meeting.h"
#include "core/measure/nearest.h"
#include "tests/editor/canvas_fixture.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

using test::px;

class JointMode : public test::CanvasFixture {
  protected:
    // A line to (-1, 0), one from (1, 1) on, a corner below, and a bar across it.
    void SetUp() override {
        editor.run(DeleteCurve{.index = 0});
        editor.run(AddLine{.from = {-4, 0}, .to = {-1, 0}});
        editor.run(AddLine{.from = {1, 1}, .to = {4, 1}});
        editor.run(AddPolyline{.points = {{-4, -2}, {2, -2}, {2, -3}}, .closed = false});
        editor.run(AddLine{.from = {-2, -1.5}, .to = {-2, -3}});
        steps_of_setup_ = state().history.undo_count();
    }
    std::size_t steps_of_setup_ = 0;
    void take(JointOperation operation) { ASSERT_TRUE(editor.run(Command(*command_of(operation)))); }
    static std::optional<Command> command_of(JointOperation operation) {
        switch (operation) {
            case JointOperation::match:
                return UseJointTool<JointOperation::match>{};
            case JointOperation::blend:
                return UseJointTool<JointOperation::blend>{};
            case JointOperation::fillet:
                return UseJointTool<JointOperation::fillet>{};
            case JointOperation::trim:
                return UseJointTool<JointOperation::trim>{};
            case JointOperation::split:
                return UseJointTool<JointOperation::split>{};
            case JointOperation::extend:
                return UseJointTool<JointOperation::extend>{};
            case JointOperation::chamfer:
                return UseJointTool<JointOperation::chamfer>{};
            case JointOperation::offset:
                return UseJointTool<JointOperation::offset>{};
            case JointOperation::join:
                break;
        }
        return UseJointTool<JointOperation::join>{};
    }
    std::size_t steps_since_setup() const { return state().history.undo_count() - steps_of_setup_; }
    void press_enter() {
        PointerEvent event;
        event.action = PointerAction::key;
        event.position_px = px(1.7, -2.4);
        event.key = Key::enter;
        pointer.send(event);
    }
    void key(char32_t character) {
        PointerEvent event;
        event.action = PointerAction::key;
        event.position_px = px(0, 0);
        event.character = character;
        pointer.send(event);
    }
    const PickingJoint& picking() const { return std::get<PickingJoint>(pointer.mode()); }
    const core::Document& present() const { return state().history.present(); }
    std::string hint() const { return canvas_hint(pointer.mode(), state()); }
};

TEST_F(JointMode, shows_the_end_that_is_near) {
    take(JointOperation::join);
    EXPECT_EQ(state().tool, Tool::joint);
    pointer.move(px(-1.5, 0.05));
    ASSERT_TRUE(picking().hovered);
    EXPECT_EQ(picking().hovered->curve, 0U);
    EXPECT_EQ(picking().hovered->end, core::CurveEnd::end);
    EXPECT_EQ(picking().hovered->point, core::Point(-1, 0));
    EXPECT_EQ(hint(), "Click the end that stays where it is · 0 to 3 choose the continuity");
    pointer.move(px(0, -1));
    EXPECT_FALSE(picking().hovered);
}

TEST_F(JointMode, leaves_rulers_to_guides_and_menus_to_the_right_button) {
    editor.run(ToggleOverlay<Overlay::rulers>{});
    take(JointOperation::blend);
    pointer.move(px(-1.1, 0));
    EXPECT_TRUE(is_at_rest(pointer.mode()));
    pointer.press({300.0, -5.0});
    pointer.move(px(-3, 2.5));
    pointer.release(px(-3, 2.5));
    EXPECT_EQ(present().guides.size(), 1U);
    pointer.move(px(-1.1, 0));
    pointer.click(px(-1.1, 0));
    ASSERT_TRUE(picking().first);
    EXPECT_FALSE(is_at_rest(pointer.mode()));
    // What was picked waits while the pointer passes over a ruler.
    pointer.move(px(1.1, 1));
    EXPECT_TRUE(state().preview);
    pointer.move({300.0, -5.0});
    EXPECT_FALSE(state().preview);
    EXPECT_TRUE(picking().first);
    EXPECT_FALSE(picking().hovered);
    pointer.move(px(1.1, 1));
    EXPECT_TRUE(state().preview);
}

TEST_F(JointMode, blends_between_two_clicks_as_it_was_previewed) {
    take(JointOperation::blend);
    pointer.move(px(-1.1, 0));
    pointer.click(px(-1.1, 0));
    ASSERT_TRUE(picking().first);
    pointer.move(px(1.1, 1));
    ASSERT_TRUE(state().preview);
    ASSERT_EQ(state().preview->curves.size(), 5U);
    EXPECT_EQ(state().preview->active_curve()->curve->degree(), 5);
    EXPECT_EQ(present().curves.size(), 4U);
    const std::vector<std::string> reading = joint_reading(state(), picking());
    ASSERT_EQ(reading.size(), 9U);
    EXPECT_EQ(reading[3], "first end G²: gap 0, turn 0°");
    EXPECT_EQ(reading[6], "other end G²: gap 0, turn 0°");
    EXPECT_EQ(reading[7], "then curvature 0 and 0");
    EXPECT_EQ(reading[0].find("gap 2.236"), 0U) << reading[0];
    EXPECT_EQ(reading[1].find("curvature 0"), 0U) << reading[1];
    // Another continuity changes the preview with the next move.
    key(U'1');
    EXPECT_EQ(state().view.joint.continuity, core::GeometricContinuity::g1);
    pointer.move(px(1.15, 1));
    EXPECT_EQ(state().preview->active_curve()->curve->degree(), 3);
    pointer.click(px(1.15, 1));
    ASSERT_EQ(present().curves.size(), 5U);
    EXPECT_EQ(present().active_curve()->curve->control_points().front(), core::Point(-1, 0));
    EXPECT_EQ(present().active_curve()->curve->control_points().back(), core::Point(1, 1));
    EXPECT_FALSE(picking().first);
    ASSERT_TRUE(editor.run(Undo{}));
    EXPECT_EQ(present().curves.size(), 4U);
}

TEST_F(JointMode, matches_and_tells_what_jumps_before_and_after) {
    take(JointOperation::match);
    key(U'3');
    pointer.move(px(1.1, 1));
    pointer.click(px(1.1, 1));
    EXPECT_EQ(present().active, 1U);
    key(U'2');
    pointer.move(px(-1.1, 0));
    const std::vector<std::string> reading = joint_reading(state(), picking());
    ASSERT_EQ(reading.size(), 6U);
    EXPECT_EQ(reading[0].find("gap 2.236"), 0U) << reading[0];
    EXPECT_EQ(reading[3].find("then G"), 0U) << reading[3];
    pointer.click(px(-1.1, 0));
    EXPECT_EQ(present().curves[1].curve->control_points().front(), core::Point(-1, 0));
    EXPECT_EQ(present().curves[0].curve->control_points().back(), core::Point(-1, 0));
}

// The parabola (1 + t, 1 + t^2), of curvature 2 where it starts: beyond that it bends to the right.
TEST_F(JointMode, tells_beforehand_what_the_message_says) {
    ASSERT_TRUE(editor.run(NewCurve{.points = {{1, 1}, {1.5, 1}, {2, 2}}}));
    ASSERT_EQ(present().active_curve()->curve->degree(), 2);
    ASSERT_TRUE(editor.run(DeleteCurve{.index = 1}));
    struct Case {
        JointOperation operation;
        bool is_line_first;
        std::string was, was_said, is, is_said;
    };
    for (const Case& one : {Case{JointOperation::match, true, "curvature 0 and 2", "the curvatures 0 and 2; it ",
                                 "then curvature 2 and 2", " and the curvatures 2 and 2; "},
                            Case{JointOperation::match, false, "curvature −2 and 0", "the curvatures -2 and 0; it ",
                                 "then curvature 0 and 0", " and the curvatures 0 and 0; "},
                            Case{JointOperation::join, true, "curvature 0 and 2", "the curvatures 0 and 2; it ",
                                 "then curvature 0 and 0", " and the curvatures 0 and 0; "},
                            Case{JointOperation::join, false, "curvature −2 and 0", "the curvatures -2 and 0; it ",
                                 "then curvature −2 and −2", " and the curvatures -2 and -2; "}}) {
        take(one.operation);
        key(U'2');
        const glm::dvec2 line = px(-1.02, 0);
        const glm::dvec2 bow = px(1.02, 1);
        pointer.click(one.is_line_first ? line : bow);
        pointer.move(one.is_line_first ? bow : line);
        const std::vector<std::string> reading = joint_reading(state(), picking());
        ASSERT_EQ(reading.size(), 6U);
        EXPECT_EQ(reading[1], one.was);
        EXPECT_EQ(reading[4], one.is);
        pointer.click(one.is_line_first ? bow : line);
        const std::string said = state().message.text;
        EXPECT_NE(said.find(one.was_said), std::string::npos) << said;
        const std::size_t now = said.find("; it has a gap of 0, a turn of 0°");
        ASSERT_NE(now, std::string::npos) << said;
        EXPECT_EQ(reading_text(said.substr(now)).find(reading_text(one.is_said)) != std::string::npos, true) << said;
        ASSERT_TRUE(editor.run(Undo{}));
    }
}

TEST_F(JointMode, forgets_a_place_of_a_curve_that_is_another_one_since) {
    take(JointOperation::join);
    ASSERT_TRUE(editor.run(ActivateCurve{.index = 0}));
    ASSERT_TRUE(editor.run(SetPoint{.index = 1, .position = {-1, 0.25}}));
    pointer.move(px(-1, 0.25));
    pointer.click(px(-1, 0.25));
    ASSERT_TRUE(picking().first);
    ASSERT_TRUE(editor.run(Undo{}));
    CommandQueue queue;
    EXPECT_FALSE(std::get<PickingJoint>(with_present_tool(pointer.mode(), state(), queue)).first);
    pointer.move(px(1.1, 1));
    EXPECT_FALSE(picking().first);
    EXPECT_FALSE(state().preview);
    // An edit of another curve leaves it.
    pointer.move(px(-1, 0));
    pointer.click(px(-1, 0));
    ASSERT_TRUE(picking().first);
    ASSERT_TRUE(editor.run(Redo{}));
    ASSERT_TRUE(editor.run(Undo{}));
    pointer.move(px(-1, 0));
    EXPECT_TRUE(picking().first) << "the very same curve again";
    ASSERT_TRUE(editor.run(ActivateCurve{.index = 2}));
    ASSERT_TRUE(editor.run(SetPoint{.index = 1, .position = {2.5, -2}}));
    ASSERT_TRUE(editor.run(ActivateCurve{.index = 0}));
    pointer.move(px(1.1, 1));
    EXPECT_TRUE(picking().first);
    EXPECT_TRUE(state().preview);
    // One that is gone is forgotten, too.
    ASSERT_TRUE(editor.run(DeleteCurve{.index = 0}));
    pointer.move(px(1.2, 1));
    EXPECT_FALSE(picking().first);
}

TEST_F(JointMode, tells_lengths_in_the_unit_and_curvatures_in_its_inverse) {
    // A part of a unit circle from (4, -1) on, counterclockwise, whose curvature is 1: where a millimeter is 0.1,
    // it is 0.1.
    ASSERT_TRUE(editor.run(AddArc{.center = {3, -1}, .radius = 1.0, .start = 0.0, .sweep = 90.0}));
    ASSERT_TRUE(editor.run(SetUnits{.unit = UnitChoice::mm, .scale = 0.1}));
    take(JointOperation::match);
    pointer.click(px(2, -2.9));
    pointer.move(px(3.9, -0.9));
    const std::vector<std::string> reading = joint_reading(state(), picking());
    ASSERT_GE(reading.size(), 3U);
    EXPECT_EQ(reading[0].find("gap 28.28 mm, turn"), 0U) << reading[0];
    EXPECT_EQ(reading[1], "curvature 0 and 0.1");
    pointer.click(px(3.9, -0.9));
    const std::string& said = state().message.text;
    EXPECT_NE(said.find("the joint had a gap of 28.28427124746"), std::string::npos) << said;
    EXPECT_NE(said.find(" mm, a turn of "), std::string::npos) << said;
    EXPECT_NE(said.find(" and the curvatures 0 and 0.1;"), std::string::npos) << said;
}

TEST_F(JointMode, reading_hides_what_is_beneath_and_is_small_in_a_low_picture) {
    take(JointOperation::blend);
    pointer.click(px(-1.1, 0));
    pointer.move(px(1.1, 1));
    EditorState seen = state();
    const auto rows_in = [&](glm::dvec2 size_px) {
        seen.view.camera.size_px = size_px;
        const render::DrawList list = test::canvas_picture(seen, pointer.mode());
        EXPECT_EQ(test::overlapping_labels(list), std::vector<std::string>());
        std::vector<std::string> rows;
        for (const std::string& text : test::texts_of(list))
            for (const char* word : {"gap", "curvature", "change"})
                if (text.find(word) != std::string::npos) rows.push_back(text);
        return rows;
    };
    EXPECT_EQ(rows_in({1048.0, 566.0}).size(), 9U);
    const std::vector<std::string> few = rows_in({410.0, 280.0});
    ASSERT_EQ(few.size(), 3U);
    EXPECT_EQ(few[0].find("gap 2.236, turn"), 0U) << few[0];
    EXPECT_EQ(few[1], "first end G²: gap 0, turn 0°");
    EXPECT_EQ(few[2], "other end G²: gap 0, turn 0°");
}

TEST_F(JointMode, joins_the_ends_that_were_clicked) {
    take(JointOperation::join);
    pointer.click(px(-3.9, 0));
    pointer.move(px(3.9, 1));
    pointer.click(px(3.9, 1));
    ASSERT_EQ(present().curves.size(), 3U);
    const auto points = present().active_curve()->curve->control_points();
    EXPECT_EQ(points.back(), core::Point(-1, 0));
    EXPECT_LE(core::distance(points.front(), core::Point(1, 1)), 1e-12);
}

TEST_F(JointMode, trims_the_part_that_is_shown) {
    take(JointOperation::trim);
    pointer.move(px(-3, -2));
    ASSERT_TRUE(picking().part);
    EXPECT_NEAR(picking().part->upper, 1.0 / 3, 1e-12);
    EXPECT_EQ(picking().part->lower, 0.0);
    pointer.click(px(-3, -2));
    EXPECT_LE(core::distance(present().curves[2].curve->control_points().front(), core::Point(-2, -2)), 1e-12);
}

TEST_F(JointMode, rounds_a_corner_by_a_click_on_both_sides) {
    take(JointOperation::fillet);
    ASSERT_TRUE(editor.run(SetJointRadius{.radius = 0.5}));
    pointer.click(px(1, -2));
    pointer.move(px(2, -2.7));
    ASSERT_TRUE(state().preview);
    pointer.click(px(2, -2.7));
    for (const core::JointContinuity& joint : core::joint_continuity(*present().curves[2].curve))
        EXPECT_EQ(joint.geometric, 1);
    EXPECT_EQ(present().curves[2].curve->degree(), 2);
}

TEST_F(JointMode, a_join_tells_before_what_would_be_left) {
    take(JointOperation::join);
    key(U'1');
    pointer.click(px(-1.1, 0));
    pointer.move(px(1.1, 1));
    const std::vector<std::string> reading = joint_reading(state(), picking());
    ASSERT_EQ(reading.size(), 6U);
    EXPECT_EQ(reading[0].find("gap 2.236"), 0U) << reading[0];
    EXPECT_EQ(reading[3].find("then G"), 0U) << reading[3];
    EXPECT_NE(reading[3].find("gap 0, turn 0°"), std::string::npos) << reading[3];
}

TEST_F(JointMode, tells_what_jumps_at_the_ends_of_very_long_curves) {
    std::vector<core::Point> places;
    for (int i = 0; i <= 20'000; ++i) places.emplace_back(-1.0 - 0.0002 * i, 2.0 + std::sin(0.01 * i));
    ASSERT_TRUE(editor.run(NewCurve{.points = places}));
    take(JointOperation::match);
    pointer.click(px(-1.0, 2.0));
    ASSERT_TRUE(picking().first);
    pointer.move(px(1.1, 1));
    EXPECT_FALSE(state().preview);
    const std::vector<std::string> reading = joint_reading(state(), picking());
    ASSERT_EQ(reading.size(), 6U);
    EXPECT_EQ(reading[0].find("gap 2.236"), 0U) << reading[0];
    EXPECT_EQ(reading[3].find("then G²: gap 0, turn 0°"), 0U) << reading[3];
    pointer.click(px(1.1, 1));
    const core::Meeting meeting =
        core::meeting_of(core::passing_beyond(*present().active_curve()->curve, core::CurveEnd::start),
                         core::passing_at(*present().curves[1].curve, core::CurveEnd::start));
    EXPECT_LE(meeting.gap, 1e-12);
    EXPECT_NEAR(*meeting.before, 0.0, 1e-6);
}

TEST_F(JointMode, the_radius_of_a_fillet_is_dragged_out_of_a_corner) {
    take(JointOperation::fillet);
    pointer.move(px(2.02, -2.01));
    pointer.press(px(2.02, -2.01));
    pointer.modifiers = test::alt;
    pointer.move(px(1.7, -2.4));
    ASSERT_TRUE(state().preview);
    ASSERT_TRUE(picking().drag);
    // 0.3 to the left of the corner and 0.4 below it.
    EXPECT_NEAR(picking().drag->distance, 0.5, 1e-12);
    EXPECT_EQ(hint().substr(0, 10), "Radius 0.5");
    pointer.release(px(1.7, -2.4));
    // A polygon's corner (2, -2): the arc leaves at (1.5, -2) and arrives at (2, -2.5).
    const core::Curve& rounded = *present().curves[2].curve;
    EXPECT_EQ(rounded.degree(), 2);
    EXPECT_LE(core::distance(core::nearest_point(rounded, {2, -2}).point,
                             core::Point(1.5 + std::sqrt(0.125), -2.5 + std::sqrt(0.125))),
              1e-12);
    EXPECT_EQ(steps_since_setup(), 1U);
    EXPECT_FALSE(picking().first);
}

TEST_F(JointMode, a_radius_that_is_typed_is_exact) {
    take(JointOperation::fillet);
    pointer.press(px(2, -2));
    pointer.move(px(1.7, -2.4));
    PointerEvent digit;  // comes before its character
    digit.action = PointerAction::key;
    digit.position_px = px(1.7, -2.4);
    digit.key = Key::digit_1;
    pointer.send(digit);
    key(U'1');
    key(U'/');
    key(U'3');
    EXPECT_EQ(picking().drag->distance, 1.0 / 3);
    EXPECT_EQ(state().view.joint.continuity, core::GeometricContinuity::g2);
    press_enter();
    const core::Curve& rounded = *present().curves[2].curve;
    const core::Point start(2 - 1.0 / 3, -2);
    EXPECT_LE(core::distance(core::nearest_point(rounded, start).point, start), 1e-12);
    EXPECT_FALSE(picking().drag);
}

TEST_F(JointMode, what_is_typed_for_a_size_is_in_the_unit_of_the_document) {
    ASSERT_TRUE(editor.run(SetUnits{.unit = UnitChoice::mm, .scale = 0.1}));
    take(JointOperation::fillet);
    pointer.press(px(2, -2));
    pointer.modifiers = test::alt;
    pointer.move(px(1.7, -2.4));
    EXPECT_EQ(hint().substr(0, 12), "Radius 5 mm ");
    EXPECT_EQ(reading_of(state(), *state().placing.place), "Radius 5 mm");
    key(U'4');
    EXPECT_EQ(picking().drag->distance, 0.4) << "4 mm";
    EXPECT_EQ(typed_reading(state().placing.typed, state().placing.place->typed_for), "radius 4|");
    key(U'm');
    key(U'm');
    EXPECT_EQ(picking().drag->distance, 0.4);
    pointer.escape(px(1.7, -2.4));
    take(JointOperation::offset);
    pointer.press(px(2, 1));
    pointer.move(px(2, 1.3));
    EXPECT_EQ(hint().substr(0, 14), "Distance 3 mm ");
    key(U'5');
    EXPECT_EQ(picking().drag->distance, -0.5) << "5 mm to the right, where keys are typed: below the line";
}

TEST_F(JointMode, a_chamfer_is_dragged_between_the_ends_of_two_curves) {
    ASSERT_TRUE(editor.run(AddLine{.from = {-1, 0}, .to = {-1, 3}}));
    take(JointOperation::chamfer);
    pointer.press(px(-1, 0));
    pointer.modifiers = test::alt;
    pointer.move(px(-1, 1));
    ASSERT_TRUE(state().preview);
    pointer.release(px(-1, 1));
    EXPECT_EQ(present().curves.size(), 4U);
    std::vector<core::Point> corners(present().active_curve()->curve->control_points().begin(),
                                     present().active_curve()->curve->control_points().end());
    if (corners.front() != core::Point(-4, 0)) std::ranges::reverse(corners);
    const std::vector<core::Point> wanted{{-4, 0}, {-2, 0}, {-1, 1}, {-1, 3}};
    ASSERT_EQ(corners.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_LE(core::distance(corners[i], wanted[i]), 1e-12) << i;
}

// The triangle's ends meet at (-5, 3), in a corner of 45 degrees whose legs leave to the right and down to the right.
TEST_F(JointMode, the_corner_where_the_ends_of_a_curve_meet_is_rounded_too) {
    ASSERT_TRUE(editor.run(NewCurve{.points = {{-5, 3}, {-1, 3}, {-1, -1}, {-5, 3}}, .degree = 1}));
    take(JointOperation::fillet);
    pointer.press(px(-5, 3));
    pointer.modifiers = test::alt;
    pointer.move(px(-4.5, 2.8));
    ASSERT_TRUE(picking().drag);
    type(U"0.5\n", px(-4.5, 2.8));
    const core::Curve& rounded = *present().active_curve()->curve;
    EXPECT_TRUE(core::is_closed(rounded));
    // The center is 0.5 below the level leg, and as far from the other one.
    const core::Point center(-5 + 0.5 * (1 + std::sqrt(2.0)), 2.5);
    EXPECT_NEAR(core::distance(core::nearest_point(rounded, center).point, center), 0.5, 1e-12);
    EXPECT_GT(core::distance(core::nearest_point(rounded, {-5, 3}).point, core::Point(-5, 3)), 0.5);
}

TEST_F(JointMode, the_radius_may_be_an_expression_that_begins_with_a_function) {
    take(JointOperation::fillet);
    pointer.press(px(2, -2));
    pointer.modifiers = test::alt;
    pointer.move(px(1.7, -2.4));
    ASSERT_TRUE(picking().drag);
    type(U"sqrt(1/4)", px(1.7, -2.4));
    EXPECT_EQ(picking().drag->distance, 0.5);
}

// 2 along the level line that is picked, 0.5 along the upright one.
TEST_F(JointMode, both_distances_of_a_chamfer_can_be_typed) {
    ASSERT_TRUE(editor.run(AddLine{.from = {-1, 0}, .to = {-1, 3}}));
    ASSERT_TRUE(editor.run(ActivateCurve{.index = 1}));
    take(JointOperation::chamfer);
    pointer.press(px(-1, 0));
    pointer.modifiers = test::alt;
    pointer.move(px(-1, 1));
    type(U"2\t0.5", px(-1, 1));
    EXPECT_EQ(typed_reading(state().placing.typed, state().placing.place->typed_for), "first 2 · second 0.5|");
    EXPECT_EQ(state().placing.place->reading, "Distances 2 and 0.5");
    const bool is_level_picked = present().curves[picking().first->curve].curve->control_points()[0].y == 0.0;
    type(U"\n", px(-1, 1));
    const auto corners = present().active_curve()->curve->control_points();
    ASSERT_EQ(corners.size(), 4U);
    for (const core::Point wanted :
         is_level_picked ? std::vector<core::Point>{{-3, 0}, {-1, 0.5}} : std::vector<core::Point>{{-1.5, 0}, {-1, 2}})
        EXPECT_TRUE(std::ranges::any_of(corners, [&](core::Point p) { return core::distance(p, wanted) < 1e-12; }))
            << wanted.x << ", " << wanted.y;
}

TEST_F(JointMode, a_press_beside_a_corner_drags_nothing) {
    take(JointOperation::fillet);
    pointer.press(px(0, -2));
    pointer.move(px(0.5, -2.5));
    EXPECT_FALSE(picking().drag);
    EXPECT_FALSE(state().preview);
    pointer.release(px(0.5, -2.5));
    EXPECT_TRUE(picking().first);
}

TEST_F(JointMode, an_offset_is_dragged_out_of_a_curve) {
    take(JointOperation::offset);
    pointer.modifiers = test::alt;
    pointer.press(px(2, 1));
    pointer.move(px(2.5, 1.75));
    ASSERT_TRUE(state().preview);
    EXPECT_EQ(picking().drag->distance, 0.75);
    EXPECT_EQ(hint().substr(0, 13), "Distance 0.75");
    pointer.move(px(2.5, 0.75));
    EXPECT_EQ(picking().drag->distance, -0.25);
    pointer.release(px(2.5, 0.75));
    ASSERT_EQ(present().curves.size(), 5U);
    const auto points = present().active_curve()->curve->control_points();
    EXPECT_EQ(points.front(), core::Point(1, 0.75));
    EXPECT_EQ(points.back(), core::Point(4, 0.75));
    pointer.press(px(2, 1));
    pointer.escape(px(2, 1));
    EXPECT_FALSE(picking().first);
    pointer.release(px(2, 1));
    EXPECT_EQ(present().curves.size(), 5U);
}

TEST_F(JointMode, a_dragged_offset_has_few_points) {
    ASSERT_TRUE(editor.run(AddEllipse{.center = {0, 2}, .first_axis = 2, .second_axis = 1, .rotation = 0}));
    const auto ellipse = present().active_curve()->curve;
    ASSERT_TRUE(editor.run(ActivateCurve{.index = 0}));
    take(JointOperation::offset);
    pointer.modifiers = test::alt;
    pointer.press(px(0, 3));
    pointer.move(px(0, 3.5));
    pointer.release(px(0, 3.5));
    ASSERT_EQ(present().curves.size(), 6U);
    const core::Curve& offset = *present().active_curve()->curve;
    EXPECT_LE(offset.control_points().size(), 50U);
    for (int i = 0; i <= 100; ++i) {
        const double u = offset.domain().lower + offset.domain().length() * i / 100.0;
        const core::Point place = core::point_at(offset, u);
        EXPECT_NEAR(core::distance(core::nearest_point(*ellipse, place).point, place), 0.5, 4e-4)
            << "a ten-thousandth of the size";
    }
}

TEST_F(JointMode, offsets_on_both_sides_have_the_caps_of_the_tool) {
    take(JointOperation::offset);
    ASSERT_TRUE(editor.run(
        SetJointOffset{.both_sides = true, .corners = core::OffsetCorners::round, .caps = core::OffsetCaps::round}));
    pointer.press(px(2, 1));
    pointer.move(px(2, 1.3));
    key(U'.');
    key(U'5');
    press_enter();
    // A slot: two lines of length 3 and two half circles of radius 1/2.
    EXPECT_NEAR(core::enclosed_area(*present().active_curve()->curve)->signed_area, 3.0 + std::numbers::pi / 4, 1e-9);
}

TEST_F(JointMode, the_view_moves_while_something_is_picked) {
    take(JointOperation::blend);
    pointer.click(px(-1.1, 0));
    const core::Point center(state().view.camera.center);
    pointer.button = PointerButton::middle;
    pointer.press(px(0, 0));
    pointer.move(px(1, 0));
    pointer.release(px(1, 0));
    EXPECT_NEAR(state().view.camera.center.x, center.x - 1.0, 1e-12);
    pointer.button = PointerButton::left;
    pointer.space = true;
    pointer.press(px(0, 0));
    pointer.move(px(0, 1));
    pointer.release(px(0, 1));
    EXPECT_NEAR(state().view.camera.center.y, center.y - 1.0, 1e-12);
    EXPECT_TRUE(picking().first);
    EXPECT_FALSE(picking().panned_px);
}

TEST_F(JointMode, splits_and_extends) {
    take(JointOperation::split);
    pointer.click(px(-2, -1.7));
    EXPECT_EQ(present().curves.size(), 5U);
    take(JointOperation::extend);
    pointer.click(px(1.1, 1));
    pointer.move(px(-1.1, 0));
    EXPECT_FALSE(state().preview);
    EXPECT_TRUE(state().message.is_error);
}

TEST_F(JointMode, escape_gives_up_the_first_place_and_then_the_tool) {
    take(JointOperation::blend);
    pointer.click(px(-1.1, 0));
    pointer.move(px(1.1, 1));
    pointer.escape(px(1.1, 1));
    EXPECT_FALSE(state().preview);
    EXPECT_FALSE(picking().first);
    EXPECT_EQ(state().tool, Tool::joint);
    pointer.escape(px(1.1, 1));
    EXPECT_EQ(state().tool, Tool::select);
    pointer.move(px(1.1, 1));
    EXPECT_TRUE(std::holds_alternative<CanvasIdle>(pointer.mode()));
}

TEST_F(JointMode, a_change_of_the_tool_gives_up_what_was_picked) {
    take(JointOperation::blend);
    pointer.click(px(-1.1, 0));
    take(JointOperation::join);
    pointer.move(px(1.1, 1));
    EXPECT_FALSE(picking().first);
    EXPECT_FALSE(state().preview);
}

}  // namespace
}  // namespace batten::editor
