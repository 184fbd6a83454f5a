#include "app/editor/commands/piece_commands.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "core/evaluate/evaluate.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

// y = x^2 over [0, 2] as one Bézier piece; and a line that does not meet its end, (2, 4).
constexpr const char* pieces_text = R"({ "format": "batten", "version": 1, "curves": [
  { "name": "parabola", "degree": 2, "knots": [0,0,0,1,1,1], "points": [[0,0],[1,0],[2,4]], "color": "#e69f00" },
  { "name": "line", "degree": 1, "knots": [0,0,1,1], "points": [[3,5],[4,9]] },
  { "name": "fixed", "degree": 1, "knots": [0,0,1,1], "points": [[4,9],[5,9]], "locked": true } ] })";

class PieceCommands : public ::testing::Test {
  protected:
    void SetUp() override { open_text(editor_, pieces_text); }
    bool run(const Command& command) { return editor_.run(command); }
    bool type(const std::string& text) { return run_typed(editor_, text); }
    const EditorState& state() const { return editor_.state(); }
    std::vector<std::string> names() const {
        std::vector<std::string> found;
        for (const core::DocumentCurve& entry : document(editor_).curves) found.push_back(entry.name);
        return found;
    }
    const core::Curve& curve_at(std::size_t i) const { return *document(editor_).curves[i].curve; }

    Editor editor_;
};

TEST_F(PieceCommands, split_leaves_two_curves_side_by_side) {
    ASSERT_TRUE(run(Split{.u = 0.25})) << state().message.text;
    EXPECT_EQ(names(), (std::vector<std::string>{"parabola", "parabola 2", "line", "fixed"}));
    EXPECT_EQ(document(editor_).active, 0U);
    EXPECT_EQ(curve_at(0).domain(), (core::Interval{0.0, 0.25}));
    EXPECT_EQ(curve_at(1).domain(), (core::Interval{0.25, 1.0}));
    // x = 2u, y = x^2: the parts meet at (0.5, 0.25), and the tangents there meet the axis at x = 0.25.
    EXPECT_EQ(curve_at(0).control_points()[1], core::Point(0.25, 0.0));
    EXPECT_EQ(curve_at(0).control_points()[2], core::Point(0.5, 0.25));
    EXPECT_EQ(curve_at(1).control_points()[0], core::Point(0.5, 0.25));
    EXPECT_EQ(document(editor_).curves[1].color, document(editor_).curves[0].color);
    EXPECT_EQ(state().message.text, "Split at 0.25; the curve is unchanged");
    ASSERT_TRUE(run(Undo{}));
    EXPECT_EQ(names().size(), 3U);
}

TEST_F(PieceCommands, split_refuses_an_end) {
    EXPECT_FALSE(run(Split{.u = 1.0}));
    EXPECT_FALSE(run(Split{.u = 2.0}));
    EXPECT_EQ(names().size(), 3U);
}

TEST_F(PieceCommands, sub_curve_keeps_the_part) {
    ASSERT_TRUE(run(SubCurve{.begin = 0.25, .end = 0.5})) << state().message.text;
    EXPECT_EQ(curve_at(0).control_points().front(), core::Point(0.5, 0.25));
    EXPECT_EQ(curve_at(0).control_points().back(), core::Point(1.0, 1.0));
    EXPECT_EQ(state().message.text, "Kept part from 0.25 to 0.5");
    EXPECT_FALSE(run(SubCurve{.begin = 0.5, .end = 0.25}));
}

TEST_F(PieceCommands, bezier_pieces_and_back) {
    ASSERT_TRUE(run(InsertKnot{.u = 0.5}));
    ASSERT_TRUE(run(BezierPieces{})) << state().message.text;
    EXPECT_EQ(names(), (std::vector<std::string>{"parabola", "parabola 2", "line", "fixed"}));
    ASSERT_TRUE(run(SetCurveLocked{.index = 3, .locked = false}));
    ASSERT_TRUE(run(DeleteCurve{.index = 3}));
    ASSERT_TRUE(run(DeleteCurve{.index = 2}));
    ASSERT_TRUE(run(ActivateCurve{.index = 0}));
    ASSERT_TRUE(type("join-pieces")) << state().message.text;
    EXPECT_EQ(names(), (std::vector<std::string>{"parabola"}));
    ASSERT_EQ(curve_at(0).control_points().size(), 3U);
    EXPECT_NEAR(curve_at(0).control_points()[1].x, 1.0, 1e-15);
    EXPECT_NEAR(curve_at(0).control_points()[1].y, 0.0, 1e-15);
}

TEST_F(PieceCommands, join_turns_and_changes_only_a_short_part_of_the_other) {
    ASSERT_TRUE(run(Join{.other = "line", .continuity = core::JoinContinuity::c0})) << state().message.text;
    EXPECT_EQ(names(), (std::vector<std::string>{"parabola", "fixed"}));
    EXPECT_EQ(core::point_at(curve_at(0), 0.5), core::Point(1.0, 1.0));
    EXPECT_EQ(curve_at(0).control_points().back(), core::Point(4.0, 9.0));
    // The line's beginning was moved from (3, 5) to (2, 4); it is sqrt(17) long, less than three times that.
    EXPECT_EQ(core::point_at(curve_at(0), 1.0), core::Point(2.0, 4.0));
    const std::string said = state().message.text;
    EXPECT_NE(said.find("; the joint had a gap of 1.4142135623731, a turn of 0°"), std::string::npos) << said;
    EXPECT_NE(said.find("; it has a gap of 0, a turn of "), std::string::npos) << said;
    EXPECT_NE(said.find("; 'line' changed from u = 1 to 2; the degree rose from 2 to 3"), std::string::npos) << said;
}

TEST_F(PieceCommands, join_says_what_was_turned_and_that_nothing_moved) {
    open_text(editor_, R"({ "format": "batten", "version": 1, "curves": [
      { "name": "a", "degree": 1, "knots": [0,0,1,1], "points": [[0,0],[1,0]] },
      { "name": "b", "degree": 1, "knots": [0,0,1,1], "points": [[2,0],[1,0]] } ] })");
    ASSERT_TRUE(run(Join{.other = "b", .continuity = core::JoinContinuity::c0})) << state().message.text;
    EXPECT_EQ(state().message.text,
              "Joined with 'b' C0; 'b' was turned; the joint had a gap of 0, a turn of 0° and the curvatures 0 and 0; "
              "nothing had to be moved");
    EXPECT_EQ(curve_at(0).control_points().size(), 3U);
}

TEST_F(PieceCommands, join_tells_a_curvature_below_its_error_as_0) {
    // A straight cubic, whose curvature is rounding, and a parabola with y'' = 2, x' = 1 and y' = 0 at its start.
    open_text(editor_, R"({ "format": "batten", "version": 1, "curves": [
      { "name": "straight", "degree": 3, "knots": [0,0,0,0,1,1,1,1],
        "points": [[-0.3,-0.1],[-0.2,-0.06666666666666667],[-0.1,-0.03333333333333333],[0,0]] },
      { "name": "bow", "degree": 2, "knots": [0,0,0,1,1,1], "points": [[0,0],[0.5,0],[1,1]] },
      { "name": "stop", "degree": 2, "knots": [0,0,0,1,1,1], "points": [[1,1],[1,1],[2,1]] } ] })");
    ASSERT_TRUE(run(Join{.other = "bow", .continuity = core::JoinContinuity::c0})) << state().message.text;
    EXPECT_NE(state().message.text.find(" and the curvatures 0 and 2; "), std::string::npos) << state().message.text;
    ASSERT_TRUE(run(Join{.other = "stop", .continuity = core::JoinContinuity::c0})) << state().message.text;
    EXPECT_NE(state().message.text.find(" before it and no curvature behind it; "), std::string::npos)
        << state().message.text;
}

TEST_F(PieceCommands, join_tells_the_active_side_first_whichever_goes_before) {
    // The start of the bow, which bends to the right where it is run through backwards, meets the end of the line.
    open_text(editor_, R"({ "format": "batten", "version": 1, "curves": [
      { "name": "bow", "degree": 2, "knots": [0,0,0,1,1,1], "points": [[0,0],[0.5,0],[1,1]] },
      { "name": "line", "degree": 1, "knots": [0,0,1,1], "points": [[-1,0],[0,0]] } ] })");
    ASSERT_TRUE(run(Join{.other = "line", .continuity = core::JoinContinuity::c0})) << state().message.text;
    EXPECT_NE(state().message.text.find("'line' goes before; the joint had a gap of 0, a turn of 0° and the "
                                        "curvatures -2 and 0; "),
              std::string::npos)
        << state().message.text;
}

TEST_F(PieceCommands, join_names_the_closed_curve) {
    open_text(editor_, R"({ "format": "batten", "version": 1, "curves": [
      { "name": "a", "degree": 1, "knots": [0,0,1,1], "points": [[0,0],[1,0]] },
      { "name": "b", "degree": 1, "knots": [0,0,1,2,3,3], "points": [[2,0],[1,0],[2,1],[2,0]] } ] })");
    EXPECT_FALSE(run(Join{.other = "b", .continuity = core::JoinContinuity::c0}));
    EXPECT_EQ(state().message.text, "'b' is closed and has no end to join; an open curve is needed");
}

TEST_F(PieceCommands, join_gives_the_continuity_asked_for) {
    ASSERT_TRUE(run(Join{.other = "line", .continuity = core::JoinContinuity::c1})) << state().message.text;
    const double joint = 1.0;
    const auto before = core::derivatives_at(curve_at(0), joint, 1, core::Side::left);
    const auto after = core::derivatives_at(curve_at(0), joint, 1, core::Side::right);
    EXPECT_NEAR(before[1].x, 2.0, 1e-13);
    EXPECT_NEAR(before[1].y, 8.0, 1e-13);
    EXPECT_NEAR(after[1].x, 2.0, 1e-13);
    EXPECT_NEAR(after[1].y, 8.0, 1e-13);
}

TEST_F(PieceCommands, join_refuses_what_it_cannot_take) {
    EXPECT_FALSE(run(Join{.other = "nobody", .continuity = core::JoinContinuity::c0}));
    EXPECT_EQ(state().message.text,
              "there is no curve 'nobody'; there are 'parabola', 'line', 'fixed', with the numbers 0 to 2");
    EXPECT_FALSE(run(Join{.other = "parabola", .continuity = core::JoinContinuity::c0}));
    EXPECT_FALSE(run(Join{.other = "fixed", .continuity = core::JoinContinuity::c0}));
    EXPECT_FALSE(type("join line C3"));
    EXPECT_EQ(state().message.text, "continuity is 'C3'; it must be C0, C1, C2, G1, G2 or G3");
    EXPECT_EQ(names().size(), 3U);
}

TEST_F(PieceCommands, reverse_twice_is_the_same) {
    const core::Curve before = curve_at(0);
    ASSERT_TRUE(run(Reverse{}));
    EXPECT_EQ(curve_at(0).control_points().front(), core::Point(2.0, 4.0));
    EXPECT_EQ(state().message.text, "Reversed direction; the curve is unchanged");
    ASSERT_TRUE(run(Reverse{}));
    EXPECT_EQ(curve_at(0), before);
}

TEST_F(PieceCommands, extend_goes_on_at_the_end_asked_for) {
    ASSERT_TRUE(run(ExtendParameter{.by = 0.5, .end = core::CurveEnd::end})) << state().message.text;
    EXPECT_EQ(curve_at(0).control_points().back(), core::Point(3.0, 9.0));
    ASSERT_TRUE(run(Undo{}));
    ASSERT_TRUE(run(ExtendParameter{.by = 0.5, .end = core::CurveEnd::start})) << state().message.text;
    EXPECT_EQ(curve_at(0).control_points().front(), core::Point(-1.0, 1.0));
    ASSERT_TRUE(run(ActivateCurve{.index = 1}));
    ASSERT_TRUE(run(ExtendStraight{.length = std::sqrt(17.0), .end = core::CurveEnd::end})) << state().message.text;
    EXPECT_NEAR(curve_at(1).control_points().back().x, 5.0, 1e-14);
    EXPECT_NEAR(curve_at(1).control_points().back().y, 13.0, 1e-14);
    EXPECT_FALSE(type("extend 1 both"));
    EXPECT_EQ(state().message.text, "end is 'both'; it must be start or end");
}

}  // namespace
}  // namespace batten::editor
