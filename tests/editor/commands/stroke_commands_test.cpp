#include "app/editor/commands/stroke_commands.h"

#include <gtest/gtest.h>

#include "app/editor/commands/edit_commands.h"
#include "core/evaluate/evaluate.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

class StrokeCommands : public ::testing::Test {
  protected:
    const EditorState& state() const { return editor_.state(); }
    const std::string& message() const { return state().message.text; }

    Editor editor_;
};

TEST_F(StrokeCommands, fit_a_stroke_that_is_typed) {
    EXPECT_TRUE(run_typed(editor_, "fit-stroke 0,0,10,1,20,-1,30,1,40,0,50,1,60,0"));
    EXPECT_EQ(message(), "Drew a curve with 4 control points");
    EXPECT_LT(std::abs(core::point_at(curve(editor_), 0.5).y), 1.0);
    EXPECT_TRUE(run_typed(editor_, "refit-stroke 0"));
    EXPECT_EQ(message().rfind("Fitted the stroke with smoothness 0: ", 0), 0U) << message();
    EXPECT_EQ(state().history.undo_count(), 1U);
    EXPECT_EQ(state().history.undo_label(), "Draw stroke");
}

TEST_F(StrokeCommands, a_smoothness_that_changes_nothing_is_kept) {
    ASSERT_TRUE(editor_.run(FitStroke{.points = {{0, 0}, {9, 9}}, .smoothness = 4, .pixel = 0.01}));
    const core::Curve line = curve(editor_);
    ASSERT_TRUE(editor_.run(RefitStroke{.smoothness = 7}));
    EXPECT_EQ(curve(editor_), line);
    ASSERT_TRUE(state().stroke);
    EXPECT_EQ(state().stroke->smoothness, 7);
    EXPECT_EQ(state().view.smoothness, 7);
    EXPECT_EQ(state().history.undo_count(), 1U);
}

TEST_F(StrokeCommands, say_what_a_stroke_lacks) {
    EXPECT_FALSE(editor_.run(FitStroke{.points = {{0, 0}, {1, 1}}, .smoothness = 4, .pixel = 1.0}));
    EXPECT_EQ(message(), "the stroke is too short: it extends over 1 px and must extend over at least 2");
    EXPECT_TRUE(editor_.run(FitStroke{.points = {{0, 0}, {1, 1}}, .smoothness = 4, .pixel = 0.01}));
    EXPECT_FALSE(editor_.run(FitStroke{.points = {{0, 0}, {9, 9}}, .smoothness = 4, .pixel = 0.0}));
    EXPECT_FALSE(editor_.run(FitStroke{.points = {{0, 0}, {9, 9}}, .smoothness = 11, .pixel = 1.0}));
    EXPECT_NE(message().find("11"), std::string::npos) << message();
    EXPECT_FALSE(editor_.run(FitStroke{.points = {{0, 0}, {9, 9}}, .smoothness = -1, .pixel = 1.0}));
}

TEST_F(StrokeCommands, a_pin_stays_at_its_point_while_a_redrawn_part_is_fitted_anew) {
    open_text(editor_, sample_text);
    const core::Curve before = curve(editor_);
    ASSERT_TRUE(run_typed(editor_, "pin-points 6"));
    std::vector<core::Point> points;
    for (int k = 0; k <= 300; ++k) {
        const double t = k / 300.0;
        points.push_back(core::point_at(before, 0.1 + 0.5 * t) +
                         core::Vector{0.0, 0.3 * std::sin(40.0 * t) * t * (1 - t)});
    }
    ASSERT_TRUE(editor_.run(Redraw{.points = points, .smoothness = 0, .pixel = 0.01})) << message();
    const std::size_t many = curve(editor_).control_points().size();
    ASSERT_TRUE(editor_.run(RefitStroke{.smoothness = 10})) << message();
    const core::DocumentCurve& entry = *document(editor_).active_curve();
    ASSERT_LT(entry.curve->control_points().size(), many);
    ASSERT_EQ(entry.pinned, std::vector{entry.curve->control_points().size() - 1});
    EXPECT_EQ(entry.curve->control_points()[entry.pinned.front()], core::Point(6.2, 2.8));
    EXPECT_TRUE(core::parse_document(core::format_document(document(editor_))));
}

TEST_F(StrokeCommands, redraw_a_part_and_fit_it_anew) {
    open_text(editor_, sample_text);
    const core::Curve before = curve(editor_);
    const core::Point from = core::point_at(before, 0.3);
    const core::Point to = core::point_at(before, 0.6);
    std::vector<core::Point> points;
    for (int k = 0; k <= 60; ++k) {
        const double t = k / 60.0;
        points.push_back(from + t * (to - from) + core::Vector{0.0, t * (1.0 - t)});
    }
    EXPECT_TRUE(editor_.run(Redraw{.points = points, .smoothness = 4, .pixel = 0.01}));
    EXPECT_EQ(message().rfind("Redrew a part", 0), 0U) << message();
    const core::Curve redrawn = curve(editor_);
    EXPECT_NE(redrawn, before);
    EXPECT_LT(core::distance(core::point_at(redrawn, 0.1), core::point_at(before, 0.1)), 1e-9);
    EXPECT_TRUE(editor_.run(RefitStroke{.smoothness = 8}));
    EXPECT_TRUE(editor_.run(RefitStroke{.smoothness = 4}));
    EXPECT_EQ(curve(editor_), redrawn);
    EXPECT_TRUE(editor_.run(Undo{}));
    EXPECT_EQ(curve(editor_), before);
    EXPECT_FALSE(editor_.run(Redraw{.points = {{50, 50}, {60, 60}}, .smoothness = 4, .pixel = 0.01}));
}

}  // namespace
}  // namespace batten::editor
