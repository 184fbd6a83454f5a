#include "app/editor/pointer/joint_mode.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/joint_tool_commands.h"
#include "app/editor/commands/making_commands.h"
#include "app/editor/commands/tool_commands.h"
#include "app/editor/pointer/joint_command.h"
#include "core/measure/continuity.h"
#include "tests/editor/canvas_fixture.h"

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
    }
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
            case JointOperation::join:
                break;
        }
        return UseJointTool<JointOperation::join>{};
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
    ASSERT_EQ(reading.size(), 3U);
    EXPECT_EQ(reading[0].find("gap: gap 2.236"), 0U) << reading[0];
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
    EXPECT_EQ(reading[0].find("gap: gap 2.236"), 0U) << reading[0];
    EXPECT_EQ(reading[3].find("then G"), 0U) << reading[3];
    pointer.click(px(-1.1, 0));
    EXPECT_EQ(present().curves[1].curve->control_points().front(), core::Point(-1, 0));
    EXPECT_EQ(present().curves[0].curve->control_points().back(), core::Point(-1, 0));
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
