#include "app/editor/commands/closing_commands.h"

#include <gtest/gtest.h>

#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/curve_ends.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "core/curve/knot_analysis.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/closing.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

constexpr const char* uniform_text = R"({ "format": "batten", "version": 1, "curves": [
  { "name": "coons", "degree": 3, "knots": [-3,-2,-1,0,1,2,3,4,5], "kind": "uniform",
    "points": [[0,0],[6,18],[24,18],[30,-6],[42,12]] } ] })";

class ClosingCommands : public ::testing::Test {
  protected:
    const EditorState& state() const { return editor_.state(); }
    bool run(const Command& command) { return editor_.run(command); }
    bool type(const std::string& text) { return run_typed(editor_, text); }
    core::Closing closing() const { return core::closing_of(curve(editor_)).closing; }

    Editor editor_;
};

TEST_F(ClosingCommands, close_a_curve_whose_ends_meet_without_moving_it) {
    EXPECT_TRUE(type("circle 1 2 3"));
    EXPECT_TRUE(run(CloseOrOpen{}));
    EXPECT_EQ(state().message.text, "Closed curve; the curve is unchanged");
    EXPECT_TRUE(curve(editor_).is_periodic());
    EXPECT_EQ(points(editor_).size(), 8U);
    for (int k = 0; k < 20; ++k)
        EXPECT_NEAR(core::distance(core::point_at(curve(editor_), k / 20.0), {1, 2}), 3.0, 1e-14);
    EXPECT_TRUE(type("polyline 0,0,4,0,0,3,0,0"));
    EXPECT_TRUE(run(CloseOrOpen{}));
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{0, 0}, {4, 0}, {0, 3}}));
    EXPECT_TRUE(run(CloseOrOpen{}));
    EXPECT_FALSE(curve(editor_).is_periodic());
    EXPECT_EQ(state().history.undo_label(), "Open curve");
    // Where the ends are apart the control points close.
    EXPECT_TRUE(type("polyline 0,0,4,0,0,3,1,1"));
    EXPECT_TRUE(run(CloseOrOpen{}));
    EXPECT_TRUE(curve(editor_).is_periodic());
    EXPECT_EQ(points(editor_).size(), 4U);
    EXPECT_EQ(state().history.undo_label(), "Close curve");
}

TEST_F(ClosingCommands, convert_between_the_three_kinds) {
    open_text(editor_, sample_text);
    run(ActivateCurve{.index = 1});
    EXPECT_TRUE(run(ToClamped{})) << state().message.text;
    EXPECT_EQ(closing(), core::Closing::ends_meet);
    EXPECT_EQ(points(editor_).size(), 7U);
    EXPECT_TRUE(type("to-periodic")) << state().message.text;
    EXPECT_EQ(closing(), core::Closing::periodic);
    EXPECT_EQ(points(editor_).size(), 5U);
    EXPECT_TRUE(type("to-wrapped")) << state().message.text;
    EXPECT_EQ(closing(), core::Closing::wrapped);
    EXPECT_EQ(points(editor_).size(), 7U);
    EXPECT_TRUE(type("to-periodic"));
    EXPECT_EQ(points(editor_).size(), 5U);
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 1, 2, 3, 4, 5}));
}

TEST_F(ClosingCommands, refuse_a_curve_whose_ends_are_apart) {
    open_text(editor_, bezier_text);
    EXPECT_FALSE(run(ToPeriodic{.tolerance = 0.5}));
    EXPECT_EQ(state().message.text, "the ends of the curve are 4 apart; at most 0.5 counts as meeting");
    EXPECT_FALSE(run(ToPeriodic{.tolerance = 0.0}));
    EXPECT_EQ(state().message.text, "the tolerance is 0; it must be above 0 and finite");
    EXPECT_FALSE(type("move-seam 0.5"));
}

TEST_F(ClosingCommands, move_the_seam_to_the_parameter) {
    open_text(editor_, sample_text);
    run(ActivateCurve{.index = 1});
    run(SetParameter{.u = 2.0});
    const core::Point there = core::point_at(curve(editor_), 2.0);
    EXPECT_TRUE(type("move-seam"));
    EXPECT_EQ(knots(editor_), (std::vector<double>{2, 3, 4, 5, 6, 7}));
    EXPECT_EQ(core::point_at(curve(editor_), 2.0), there);
    EXPECT_EQ(state().history.undo_label(), "Move seam to 2");
}

TEST_F(ClosingCommands, add_end_vertices) {
    open_text(editor_, uniform_text);
    EXPECT_TRUE(type("phantom-end"));
    EXPECT_EQ(points(editor_).front(), (core::Point{-6, -18}));
    EXPECT_EQ(points(editor_).back(), (core::Point{54, 30}));
    EXPECT_EQ(state().history.undo_label(), "Add phantom end vertices");
    EXPECT_EQ(state().message.text,
              "Added phantom end vertices (both); the old part of the curve stays and new spans lead to its ends");
    EXPECT_FALSE(state().ghost) << "nothing has moved";
    run(Undo{});
    EXPECT_TRUE(run(TripleEnd{.end = CurveEnds::start}));
    EXPECT_EQ(points(editor_).size(), 7U);
    EXPECT_EQ(core::point_at(curve(editor_), curve(editor_).domain().lower), (core::Point{0, 0}));
    run(Undo{});
    EXPECT_TRUE(run(DoubleEnd{.end = CurveEnds::end}));
    EXPECT_EQ(points(editor_).size(), 6U);
    EXPECT_FALSE(type("double-end middle"));
    EXPECT_EQ(state().message.text, "end is 'middle'; it must be start, end or both");
}

TEST_F(ClosingCommands, refuse_end_vertices_of_other_curves) {
    open_text(editor_, bezier_text);
    EXPECT_FALSE(type("double-end"));
    EXPECT_EQ(state().message.text,
              "the curve is not a uniform cubic; it must have degree 3 and equally spaced knots, without clamped ends");
}

constexpr const char* two_uniform_text = R"({"format": "batten", "version": 1, "curves": [
    {"name": "left", "degree": 3, "knots": [0, 1, 2, 3, 4, 5, 6, 7], "points": [[0, 0], [1, 3], [4, 3], [5, -1]]},
    {"name": "right", "degree": 3, "knots": [0, 1, 2, 3, 4, 5, 6, 7, 8],
     "points": [[9, 0], [9, 3], [9, 6], [12, 3], [15, 0]]},
    {"name": "arch", "degree": 2, "knots": [0, 0, 0, 1, 1, 1], "points": [[0, 0], [1, 3], [4, 3]]}]})";

TEST_F(ClosingCommands, share_three_vertices_with_another_curve) {
    open_text(editor_, two_uniform_text);
    run(ActivateCurve{.index = 1});
    EXPECT_TRUE(run(ShareVertices{.other = "left", .end = core::CurveEnd::start})) << state().message.text;
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{1, 3}, {4, 3}, {5, -1}, {12, 3}, {15, 0}}));
    EXPECT_EQ(state().history.undo_label(), "Share three vertices with 'left' (start)");
    run(Undo{});
    EXPECT_TRUE(type("share-vertices left end"));
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{9, 0}, {9, 3}, {0, 0}, {1, 3}, {4, 3}}));
    EXPECT_FALSE(type("share-vertices arch start"));
    EXPECT_EQ(state().message.text,
              "'arch' has no end vertices to share; it must be a uniform cubic, open and with equal weights");
    run(ActivateCurve{.index = 2});
    EXPECT_FALSE(type("share-vertices left start"));
    EXPECT_EQ(state().message.text,
              "the curve is not a uniform cubic; it must have degree 3 and equally spaced knots, without clamped ends");
    Editor alone;
    open_text(alone, uniform_text);
    EXPECT_FALSE(run_typed(alone, "share-vertices coons start"));
    EXPECT_EQ(alone.state().message.text, "there is no other curve to join; a second one is needed");
}

TEST_F(ClosingCommands, straighten_between_points) {
    open_text(editor_, bezier_text);
    EXPECT_FALSE(type("straighten"));
    run(SelectPoints{.points = {0, 3}});
    EXPECT_TRUE(type("straighten"));
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{0, 0}, {1, 0}, {3, 0}, {4, 0}}));
    EXPECT_EQ(state().history.undo_label(), "Straighten from P₀ to P₃");
    EXPECT_FALSE(run(Straighten{.from = 0, .to = 9}));
    EXPECT_EQ(state().message.text, "there is no control point 9; the last one is 3");
}

}  // namespace
}  // namespace batten::editor
