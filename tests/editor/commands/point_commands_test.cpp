#include "app/editor/commands/point_commands.h"

#include <gtest/gtest.h>

#include "app/editor/command_reader.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

class PointCommands : public ::testing::Test {
  protected:
    PointCommands() { open_text(editor_, bezier_text); }

    const EditorState& state() const { return editor_.state(); }
    bool run(const Command& command) { return editor_.run(command); }
    bool type(const std::string& text) { return run_typed(editor_, text); }
    Command nudge_right(double distance) const { return *read_command(NudgeRight::spec(), state(), {distance}); }

    Editor editor_;
};

TEST_F(PointCommands, move_set_and_weigh_points) {
    EXPECT_TRUE(run(MovePoints{.points = {1}, .offset = {0.25, -0.5}}));
    EXPECT_EQ(points(editor_)[1], (core::Point{1.25, 1.5}));
    EXPECT_EQ(state().history.undo_label(), "Move P₁");
    EXPECT_TRUE(run(SetPoint{.index = 3, .position = {5.0, -1.0}}));
    EXPECT_EQ(points(editor_)[3], (core::Point{5, -1}));
    EXPECT_EQ(state().history.undo_label(), "Move P₃");
    EXPECT_TRUE(run(SetWeight{.index = 2, .weight = 0.01}));
    EXPECT_EQ(curve(editor_).weights()[2], 0.01);
    EXPECT_EQ(state().history.undo_label(), "Set weight of P₂");
    EXPECT_FALSE(run(SetPoint{.index = 4, .position = {0.0, 0.0}}));
    EXPECT_EQ(state().message.text, "there is no control point 4; the last one is 3");
    EXPECT_FALSE(run(MovePoints{.points = {0, 9}, .offset = {1.0, 1.0}}));
    EXPECT_EQ(points(editor_)[0], (core::Point{0, 0}));
}

TEST_F(PointCommands, add_and_select_a_point) {
    EXPECT_TRUE(run(AddPoint{.index = 2, .position = {2.0, 5.0}}));
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{0, 0}, {1, 2}, {2, 5}, {3, 2}, {4, 0}}));
    EXPECT_EQ(state().selection.points, std::vector<std::size_t>{2});
    EXPECT_EQ(state().history.undo_label(), "Add P₂");
    EXPECT_TRUE(run(AddPoint{.index = 5, .position = {6.0, 0.0}}));
    EXPECT_EQ(points(editor_).back(), (core::Point{6, 0}));
    EXPECT_FALSE(run(AddPoint{.index = 9, .position = {6.0, 0.0}}));
    EXPECT_EQ(state().selection.points, std::vector<std::size_t>{5});
}

TEST_F(PointCommands, delete_points) {
    run(AddPoint{.index = 2, .position = {2.0, 5.0}});
    run(AddPoint{.index = 2, .position = {1.5, 5.0}});
    run(SelectPoints{.points = {2, 1}});
    EXPECT_TRUE(type("delete-points"));
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{0, 0}, {2, 5}, {3, 2}, {4, 0}}));
    EXPECT_EQ(state().selection, Selection{});
    EXPECT_EQ(state().history.undo_label(), "Delete 2 points");
    EXPECT_FALSE(type("delete-points"));
    EXPECT_FALSE(run(DeletePoints{.points = {0, 1, 2}}));
    EXPECT_EQ(points(editor_).size(), 4U);
}

TEST_F(PointCommands, delete_what_is_selected_points_first) {
    EXPECT_FALSE(run(Delete{}));
    EXPECT_EQ(state().message, (Message{"nothing is selected", false}));
    run(ShowHandlebar{.u = 0.5});
    EXPECT_FALSE(run(Delete{})) << "a handlebar selects nothing";
    EXPECT_EQ(state().message, (Message{"nothing is selected", false}));
    run(InsertKnot{.u = 0.5});
    run(InsertKnot{.u = 0.25});
    ASSERT_EQ(state().selection.knot, 4U);
    EXPECT_TRUE(run(Delete{}));
    EXPECT_EQ(state().history.undo_label(), "Delete knot 0.25");
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.5, 1, 1, 1, 1}));
    run(SelectPoints{.points = {1}});
    EXPECT_TRUE(run(Delete{}));
    EXPECT_EQ(state().history.undo_label(), "Delete P₁");
    EXPECT_EQ(points(editor_).size(), 4U);
}

TEST_F(PointCommands, delete_the_curve_with_all_of_its_points) {
    run(SelectPoints{.points = {0, 1, 2}});
    EXPECT_FALSE(run(Delete{})) << "one point is no curve, but not all of it either";
    run(SelectAll{});
    EXPECT_TRUE(run(Delete{}));
    EXPECT_TRUE(document(editor_).curves.empty());
    EXPECT_EQ(state().history.undo_label(), "Delete curve 'arch'");
    EXPECT_EQ(state().message, (Message{"Deleted curve 'arch'", false}));
    EXPECT_EQ(state().selection, Selection{});
    run(Undo{});
    EXPECT_EQ(points(editor_).size(), 4U);
    EXPECT_TRUE(run(DeletePoints{.points = {3, 2, 1, 0}}));
    EXPECT_TRUE(document(editor_).curves.empty());
    EXPECT_EQ(state().history.undo_label(), "Delete curve 'arch'");
}

TEST_F(PointCommands, nudge_by_the_grid) {
    EXPECT_FALSE(type("nudge-left"));
    EXPECT_EQ(state().message, (Message{"no control point is selected", true}));
    run(SelectPoints{.points = {0, 3}});
    editor_.change(ZoomCamera{64.0 / state().view.camera.scale, {0.0, 0.0}});
    ASSERT_NEAR(state().view.camera.scale, 64.0, 1e-12);
    // At 64 pixels to the unit the minor lines are half a unit apart.
    EXPECT_TRUE(type("nudge-right-far"));
    EXPECT_EQ(points(editor_)[0], (core::Point{0.5, 0}));
    EXPECT_EQ(points(editor_)[1], (core::Point{1, 2}));
    EXPECT_EQ(points(editor_)[3], (core::Point{4.5, 0}));
    EXPECT_TRUE(type("nudge-up"));
    EXPECT_EQ(points(editor_)[0], (core::Point{0.5, 0.05}));
    EXPECT_TRUE(type("nudge-down-far"));
    EXPECT_NEAR(points(editor_)[0].y, -0.45, 1e-15);
    EXPECT_TRUE(type("nudge-left"));
    EXPECT_NEAR(points(editor_)[0].x, 0.45, 1e-15);
    EXPECT_EQ(state().history.undo_label(), "Nudge 2 points");
    EXPECT_EQ(state().selection.points, (std::vector<std::size_t>{0, 3}));
    EXPECT_TRUE(run(Nudge{.offset = {1.0, 2.0}}));
    EXPECT_NEAR(points(editor_)[3].x, 5.45, 1e-14);
}

TEST_F(PointCommands, tells_a_nudge_to_15_digits) {
    run(SelectPoints{.points = {0}});
    EXPECT_TRUE(run(Nudge{.offset = {1.0 / 3.0, -1.0 / 3.0}}));
    const std::string told = "Nudged P₀ by (0.333333333333333, -0.333333333333333); ";
    EXPECT_EQ(state().message.text.substr(0, told.size()), told);
}

TEST_F(PointCommands, nudges_that_follow_at_once_are_one_step) {
    run(SelectPoints{.points = {0}});
    const core::Point start = points(editor_)[0];
    const auto nudge_at = [&](double seconds, const Command& command) {
        editor_.change(TellTime{seconds});
        return run(command);
    };
    const auto right = [&] { return nudge_right(0.25); };
    EXPECT_TRUE(nudge_at(10.0, right()));
    EXPECT_EQ(state().message.text.substr(0, 24), "Nudged P₀ by (0.25, 0)");
    editor_.change(TellTime{10.9});
    EXPECT_TRUE(run(right()));
    editor_.change(TellTime{11.8});
    EXPECT_TRUE(run(*read_command(NudgeUpFar::spec(), state(), {2.0})));
    EXPECT_EQ(state().history.undo_count(), 1U);
    EXPECT_EQ(points(editor_)[0], core::Point(start.x + 0.5, start.y + 2.0));
    EXPECT_EQ(state().message.text.substr(0, 23), "Nudged P₀ by (0.5, 2)");
    EXPECT_EQ(state().ghost->curve->control_points()[0], start) << "the shape before all of them";
    // A pause begins a new step.
    editor_.change(TellTime{12.9});
    EXPECT_TRUE(run(right()));
    EXPECT_EQ(state().history.undo_count(), 2U);
    run(Undo{});
    EXPECT_EQ(points(editor_)[0], core::Point(start.x + 0.5, start.y + 2.0));
    EXPECT_TRUE(run(right())) << "undoing ended the burst";
    EXPECT_EQ(state().history.undo_count(), 2U);
    run(Undo{});
    run(Undo{});
    EXPECT_EQ(points(editor_)[0], start);
}

TEST_F(PointCommands, nudges_of_other_points_or_after_another_command_are_steps_of_their_own) {
    editor_.change(TellTime{10.0});
    const auto right = [&] { return run(nudge_right(0.25)); };
    run(SelectPoints{.points = {0}});
    EXPECT_TRUE(right());
    run(SelectPoints{.points = {0, 1}});
    EXPECT_TRUE(right());
    EXPECT_EQ(state().history.undo_count(), 2U);
    EXPECT_TRUE(run(SetWeight{.index = 3, .weight = 2.0}));
    EXPECT_TRUE(right());
    EXPECT_EQ(state().history.undo_count(), 4U);
    EXPECT_TRUE(run(nudge_right(0.0))) << "moves nothing and ends the burst";
    EXPECT_TRUE(right());
    EXPECT_EQ(state().history.undo_count(), 5U);
}

TEST_F(PointCommands, nudges_are_replayed_as_the_steps_that_they_were) {
    editor_.change(TellTime{10.0});
    run(SelectPoints{.points = {0}});
    for (const double seconds : {10.1, 10.2, 15.0, 15.1, 15.2}) {
        editor_.change(TellTime{seconds});
        run(nudge_right(0.25));
    }
    run(Undo{});
    Editor replayed;
    open_text(replayed, bezier_text);
    for (const Command& command : editor_.log()) EXPECT_TRUE(command.as<Open>() != nullptr || replayed.run(command));
    EXPECT_EQ(points(replayed)[0], points(editor_)[0]);
    EXPECT_EQ(replayed.state().history.undo_count(), 1U);
    EXPECT_EQ(replayed.state().history.redo_count(), 1U);
}

TEST_F(PointCommands, nudge_by_design_pixels) {
    run(SelectPoints{.points = {0}});
    editor_.change(ZoomCamera{128.0 / state().view.camera.scale, {0.0, 0.0}});
    editor_.change(SetInterfaceScale{2.0});
    EXPECT_TRUE(type("nudge-right-far"));
    EXPECT_EQ(points(editor_)[0], (core::Point{0.5, 0}));
}

TEST_F(PointCommands, select_points_in_order_and_once) {
    EXPECT_TRUE(run(SelectPoints{.points = {3, 1, 3}}));
    EXPECT_EQ(state().selection.points, (std::vector<std::size_t>{1, 3}));
    EXPECT_TRUE(state().selection.contains_point(3));
    EXPECT_FALSE(state().selection.contains_point(2));
    EXPECT_FALSE(run(SelectPoints{.points = {1, 4}}));
    EXPECT_EQ(state().message.text, "there is no control point 4; the last one is 3");
    EXPECT_FALSE(type("select-points -1"));
    EXPECT_EQ(state().selection.points, (std::vector<std::size_t>{1, 3}));
    EXPECT_TRUE(run(SelectKnot{.index = 2}));
    EXPECT_EQ(state().selection, (Selection{{}, 2}));
    EXPECT_FALSE(run(SelectKnot{.index = 8}));
    EXPECT_TRUE(run(SelectKnot{.index = std::nullopt}));
    EXPECT_EQ(state().selection, Selection{});
    EXPECT_TRUE(run(SelectAll{}));
    EXPECT_EQ(state().selection.points, (std::vector<std::size_t>{0, 1, 2, 3}));
    EXPECT_TRUE(run(SelectPoints{.points = {}}));
    EXPECT_EQ(state().selection, Selection{});
}

}  // namespace
}  // namespace batten::editor
