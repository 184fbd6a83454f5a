#include "app/editor/editor.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/command_table.h"
#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/degree_commands.h"
#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/drawing_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/fit_point_commands.h"
#include "app/editor/commands/help_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/view_commands.h"
#include "app/editor/words/reading_text.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

class EditorTest : public ::testing::Test {
  protected:
    EditorTest() { open_text(editor_, bezier_text); }

    const EditorState& state() const { return editor_.state(); }
    bool preview(const Command& command) { return editor_.run(command, Phase::preview); }
    void cancel() { editor_.cancel_preview(); }

    Editor editor_;
};

const MovePoints move_all{.points = {0, 1, 2, 3}, .offset = {3.0, 4.0}};

TEST_F(EditorTest, begins_empty_and_refuses_edits_with_a_sentence) {
    Editor editor;
    EXPECT_EQ(editor.state().active_curve(), nullptr);
    EXPECT_EQ(editor.state().file_name(), "untitled");
    for (const Command& command : std::vector<Command>{InsertKnot{.u = 0.5}, SelectAll{}, Copy{}, Cut{},
                                                       SetParameter{.u = 0.5}, Elevate{.by = 1}, TogglePlay{}}) {
        EXPECT_FALSE(editor.run(command)) << command.spec().name;
        EXPECT_EQ(editor.state().message, (Message{"there is no curve; draw one or open a file", true}))
            << command.spec().name;
    }
    EXPECT_FALSE(editor.state().is_modified());
    EXPECT_TRUE(editor.log().empty());
}

TEST_F(EditorTest, says_that_a_command_is_unknown) {
    EXPECT_FALSE(run_typed(editor_, "insert-not"));
    EXPECT_EQ(state().message, (Message{"there is no command called 'insert-not'", true}));
}

TEST_F(EditorTest, refuses_undo_and_redo_where_there_is_nothing) {
    EXPECT_FALSE(editor_.run(Undo{}));
    EXPECT_EQ(state().message, (Message{"there is nothing to undo", false}));
    EXPECT_FALSE(editor_.run(Redo{}));
    EXPECT_EQ(state().message, (Message{"there is nothing to redo", false}));
}

TEST_F(EditorTest, commits_an_edit_as_one_named_step) {
    EXPECT_TRUE(editor_.run(MovePoints{.points = {1, 2}, .offset = {0.5, -1.0}}));
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{0, 0}, {1.5, 1}, {3.5, 1}, {4, 0}}));
    EXPECT_EQ(state().history.undo_count(), 1U);
    EXPECT_EQ(state().history.undo_label(), "Move 2 points");
    EXPECT_TRUE(state().is_modified());
}

TEST_F(EditorTest, shows_the_old_curve_and_the_deviation_after_a_change_of_shape) {
    const auto before = document(editor_).curves[0].curve;
    editor_.run(move_all);
    ASSERT_TRUE(state().ghost);
    EXPECT_EQ(state().ghost->curve, before);
    // Every point of the curve moves by (3, 4).
    EXPECT_NEAR(state().ghost->deviation, 5.0, 1e-12);
    EXPECT_EQ(reading_text(state().message.text), "Moved 4 points by (3, 4); the curve moved by at most 5");
    editor_.run(InsertKnot{.u = 0.5});
    EXPECT_FALSE(state().ghost);
    EXPECT_EQ(state().message, (Message{"Inserted knot 0.5: multiplicity 1, C² there; the curve is unchanged", false}));
}

TEST_F(EditorTest, tips_of_undo_and_redo_name_the_step) {
    editor_.run(InsertKnot{.u = 0.5});
    EXPECT_EQ(Undo::spec().aim(state()), "Takes back: Insert knot 0.5");
    editor_.run(Undo{});
    EXPECT_EQ(Redo::spec().aim(state()), "Repeats: Insert knot 0.5");
}

TEST_F(EditorTest, a_parameter_beyond_the_domain_says_where_it_was_put) {
    editor_.run(SetParameter{.u = 5.0});
    EXPECT_EQ(state().message, (Message{"u = 5 is outside the domain from 0 to 1; its end 1 is taken", false}));
    editor_.run(SetParameter{.u = 0.25});
    EXPECT_EQ(state().message.text, "");
}

TEST_F(EditorTest, previews_without_touching_the_committed_document) {
    const auto before = document(editor_).curves[0].curve;
    EXPECT_TRUE(preview(SetPoint{.index = 1, .position = {7.0, 7.0}}));
    EXPECT_TRUE(preview(SetPoint{.index = 1, .position = {8.0, 9.0}}));
    ASSERT_TRUE(state().preview);
    EXPECT_EQ(state().active_curve()->control_points()[1], (core::Point{8, 9}));
    EXPECT_EQ(document(editor_).curves[0].curve, before);
    ASSERT_TRUE(state().ghost);
    EXPECT_EQ(state().ghost->curve, before);
    EXPECT_EQ(state().history.undo_count(), 0U);
    EXPECT_TRUE(editor_.run(SetPoint{.index = 1, .position = {8.0, 9.0}}));
    EXPECT_FALSE(state().preview);
    EXPECT_EQ(points(editor_)[1], (core::Point{8, 9}));
    EXPECT_EQ(state().history.undo_count(), 1U);
}

TEST_F(EditorTest, previews_start_from_the_committed_document_each_time) {
    preview(move_all);
    preview(move_all);
    EXPECT_EQ(state().active_curve()->control_points()[0], (core::Point{3, 4}));
}

TEST_F(EditorTest, a_canceled_preview_leaves_no_trace) {
    preview(move_all);
    cancel();
    EXPECT_FALSE(state().preview);
    EXPECT_FALSE(state().ghost);
    EXPECT_FALSE(state().is_modified());
    EXPECT_FALSE(state().history.can_undo());
    EXPECT_EQ(editor_.log().size(), 1U);  // opening the file
}

TEST_F(EditorTest, a_refused_preview_shows_the_committed_document_and_a_sentence) {
    preview(move_all);
    EXPECT_FALSE(preview(SetWeight{.index = 0, .weight = -1.0}));
    EXPECT_FALSE(state().preview);
    EXPECT_TRUE(state().message.is_error);
    EXPECT_TRUE(preview(SetWeight{.index = 0, .weight = 2.0}));
    EXPECT_FALSE(state().message.is_error);
}

TEST_F(EditorTest, the_preview_of_an_act_does_nothing) {
    const double before = state().parameter();
    EXPECT_TRUE(preview(SetParameter{.u = 0.9}));
    EXPECT_EQ(state().parameter(), before);
    EXPECT_FALSE(state().preview);
}

TEST_F(EditorTest, an_act_between_previews_leaves_the_preview_alone) {
    preview(move_all);
    editor_.change(SetHover{HoveredPoint{2}});
    editor_.run(SetParameter{.u = 0.25});
    EXPECT_TRUE(state().preview);
}

TEST_F(EditorTest, a_refused_edit_changes_nothing_but_the_message) {
    editor_.run(SelectPoints{.points = {2}});
    const core::Document before = document(editor_);
    EXPECT_FALSE(editor_.run(SetWeight{.index = 1, .weight = 0.0}));
    EXPECT_EQ(state().message, (Message{"weight 1 is 0; every weight must be above 0", true}));
    EXPECT_EQ(document(editor_).curves[0].curve, before.curves[0].curve);
    EXPECT_EQ(state().selection.points, std::vector<std::size_t>{2});
    EXPECT_FALSE(state().history.can_undo());
}

TEST_F(EditorTest, an_edit_without_effect_makes_no_step) {
    editor_.run(SetWeight{.index = 1, .weight = 3.0});
    editor_.run(Undo{});
    EXPECT_TRUE(editor_.run(SetWeight{.index = 1, .weight = 1.0}));
    EXPECT_TRUE(editor_.run(MovePoints{.points = {1}, .offset = {0.0, 0.0}}));
    EXPECT_EQ(state().history.undo_count(), 0U);
    EXPECT_TRUE(state().history.can_redo());
    EXPECT_FALSE(state().ghost);
    EXPECT_EQ(state().message, (Message{"Nothing had to be changed", false}));
}

TEST_F(EditorTest, leaves_the_deviation_out_of_the_preview_of_a_very_long_change) {
    std::vector<core::Point> places;
    for (int i = 0; i <= 2000; ++i) places.emplace_back(0.1 * i, i % 2);
    ASSERT_TRUE(editor_.run(ThroughPoints{.points = places}));
    const MoveFitPoint move{.index = 1000, .position = {100.0, 5.0}};
    ASSERT_TRUE(editor_.run(move, Phase::preview));
    ASSERT_TRUE(state().preview && state().ghost);
    EXPECT_TRUE(std::isnan(state().ghost->deviation));
    ASSERT_TRUE(editor_.run(move));
    ASSERT_TRUE(state().ghost);
    EXPECT_GE(state().ghost->deviation, 5.0);
    EXPECT_TRUE(std::isfinite(state().ghost->deviation));
}

TEST_F(EditorTest, says_the_distance_of_shapes_where_parameters_make_most_of_the_deviation) {
    // A line whose end gets weight 9 is passed at another speed: a quarter of the way it has 9/12 of its length, not
    // 3/12.
    core::DocumentCurve entry;
    entry.curve = std::make_shared<const core::Curve>(
        core::Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {8, 0}}}).value());
    core::Document document;
    document.curves.push_back(entry);
    Editor line(document);
    ASSERT_TRUE(line.run(SetWeight{.index = 1, .weight = 9.0}));
    const std::string text = line.state().message.text;
    EXPECT_NE(text.find("the curve moved by at most 4 at equal parameters, its shape by at most "), std::string::npos)
        << text;
}

TEST_F(EditorTest, a_far_point_of_tiny_weight_does_not_make_a_change_rounding) {
    // At u = 0 the curve is P₀, which moves by 0.001; elsewhere less moves. The far point adds 1 to the numerator only.
    ASSERT_TRUE(editor_.run(SetWeight{.index = 1, .weight = 1e-15}));
    ASSERT_TRUE(editor_.run(SetPoint{.index = 1, .position = {1e15, -2.5}}));
    ASSERT_TRUE(editor_.run(MovePoints{.points = {0}, .offset = {0.0, 0.001}}));
    EXPECT_NE(state().message.text.find("; the curve moved by at most 0.001"), std::string::npos)
        << state().message.text;
}

TEST_F(EditorTest, undoes_and_redoes_exactly) {
    const auto first = document(editor_).curves[0].curve;
    editor_.run(SetWeight{.index = 1, .weight = 3.0});
    const auto second = document(editor_).curves[0].curve;
    EXPECT_TRUE(editor_.run(Undo{}));
    EXPECT_EQ(document(editor_).curves[0].curve, first);
    EXPECT_EQ(state().message, (Message{"Undid: Set weight of P₁", false}));
    EXPECT_FALSE(state().ghost);
    EXPECT_TRUE(editor_.run(Redo{}));
    EXPECT_EQ(document(editor_).curves[0].curve, second);
    EXPECT_EQ(state().message, (Message{"Redid: Set weight of P₁", false}));
}

TEST_F(EditorTest, drops_what_a_change_of_the_counts_makes_meaningless) {
    editor_.run(SelectPoints{.points = {1, 2}});
    editor_.run(SetWeight{.index = 1, .weight = 3.0});
    EXPECT_EQ(state().selection.points, (std::vector<std::size_t>{1, 2}));
    editor_.change(SetHover{HoveredCell{3, 0}});
    editor_.run(SetLevel{.level = 3});
    run_typed(editor_, "elevate");
    EXPECT_EQ(state().selection, Selection{});
    EXPECT_EQ(state().view.level, 3);
    EXPECT_EQ(state().hover, Hover(HoveredCell{3, 0}));
    editor_.run(SetLevel{.level = 4});
    editor_.change(SetHover{HoveredCell{4, 0}});
    editor_.run(Undo{});
    EXPECT_EQ(state().hover, Hover(HoveredNothing{}));
    EXPECT_EQ(state().view.level, std::nullopt);
}

TEST_F(EditorTest, refuses_edits_of_a_locked_curve) {
    editor_.run(SetCurveLocked{.index = 0, .locked = true});
    EXPECT_EQ(state().history.undo_label(), "Lock curve 'arch'");
    for (const Command& command :
         std::vector<Command>{InsertKnot{.u = 0.5}, move_all, Cut{}, DeleteCurve{.index = 0}, SetDegree{.degree = 2}}) {
        EXPECT_FALSE(editor_.run(command)) << command.spec().name;
        EXPECT_EQ(state().message.text, "curve 'arch' is locked; unlock it in the inspector") << command.spec().name;
    }
    EXPECT_TRUE(editor_.run(SetCurveLocked{.index = 0, .locked = false}));
    EXPECT_TRUE(editor_.run(move_all));
}

TEST_F(EditorTest, escape_gives_up_one_thing_at_a_time) {
    editor_.run(TogglePresenting{});
    editor_.run(SelectAll{});
    editor_.run(SetWeight{.index = 0, .weight = -1.0});
    editor_.run(ToggleKeySheet{});
    editor_.run(SetWeight{.index = 0, .weight = -1.0});
    run_typed(editor_, "escape");
    EXPECT_EQ(state().dialog, Dialog::none);
    editor_.run(SetWeight{.index = 0, .weight = -1.0});
    run_typed(editor_, "escape");
    EXPECT_EQ(state().message, Message{});
    EXPECT_EQ(state().selection.points.size(), 4U);
    preview(move_all);
    run_typed(editor_, "escape");
    EXPECT_FALSE(state().preview);
    EXPECT_EQ(state().selection.points.size(), 4U);
    run_typed(editor_, "escape");
    EXPECT_EQ(state().selection, Selection{});
    EXPECT_TRUE(state().view.is_presenting);
    run_typed(editor_, "escape");
    EXPECT_FALSE(state().view.is_presenting);
    run_typed(editor_, "escape");
    EXPECT_FALSE(state().wants_quit);
}

TEST_F(EditorTest, runs_a_queue_in_order) {
    CommandQueue queue;
    queue.run(SetWeight{.index = 1, .weight = 3.0});
    queue.preview(SetWeight{.index = 1, .weight = 4.0});
    queue.cancel_preview();
    queue.run(Undo{});
    editor_.perform(queue);
    EXPECT_TRUE(queue.is_empty());
    EXPECT_FALSE(state().preview);
    EXPECT_EQ(state().history.redo_count(), 1U);
}

}  // namespace
}  // namespace batten::editor
