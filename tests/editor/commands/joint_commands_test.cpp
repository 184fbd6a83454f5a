#include "app/editor/commands/joint_commands.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/commands/corner_commands.h"
#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/piece_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/trim_commands.h"
#include "core/document/native_file.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/continuity.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

// A quarter of the unit circle from (1, 0) to (0, 1), a line that goes on beyond a gap, a corner, and a locked line.
constexpr const char* joints_text = R"({ "format": "batten", "version": 1, "curves": [
  { "name": "line", "degree": 1, "knots": [0,0,1,1], "points": [[-0.5,1],[-4,1.5]] },
  { "name": "arc", "degree": 2, "knots": [0,0,0,1,1,1], "points": [[1,0],[1,1],[0,1]],
    "weights": [1,0.70710678118654752,1], "locked": true },
  { "name": "corner", "degree": 1, "knots": [0,0,1,2,2], "points": [[2,0],[6,0],[6,3]] },
  { "name": "bar", "degree": 1, "knots": [0,0,1,1], "points": [[3,-1],[3,1]] } ] })";

class JointCommands : public ::testing::Test {
  protected:
    void SetUp() override { open_text(editor_, joints_text); }
    bool run(const Command& command) { return editor_.run(command); }
    bool type(const std::string& text) { return run_typed(editor_, text); }
    const EditorState& state() const { return editor_.state(); }
    const std::string& said() const { return state().message.text; }
    const core::Curve& curve_at(std::size_t i) const { return *document(editor_).curves[i].curve; }
    std::vector<std::string> names() const {
        std::vector<std::string> found;
        for (const core::DocumentCurve& entry : document(editor_).curves) found.push_back(entry.name);
        return found;
    }

    Editor editor_;
};

TEST_F(JointCommands, parts_between_crossings_have_nothing_that_was_of_the_whole) {
    open_text(editor_, R"({ "format": "batten", "version": 1, "curves": [
  { "name": "line", "degree": 1, "knots": [0,0,1,2,3,3], "points": [[0,0],[2,0],[4,0],[6,0]], "pinned": [2, 3] },
  { "name": "bar", "degree": 1, "knots": [0,0,1,1], "points": [[1,-1],[1,1]] } ] })");
    ASSERT_TRUE(type("split-at-crossings active")) << said();
    ASSERT_EQ(names(), (std::vector<std::string>{"line", "line 2", "bar"}));
    EXPECT_TRUE(document(editor_).curves[0].pinned.empty());
    EXPECT_TRUE(document(editor_).curves[1].pinned.empty());
    // What is written can be read.
    EXPECT_TRUE(core::parse_document(core::format_document(document(editor_))));
}

TEST_F(JointCommands, parts_between_crossings_are_not_made_of_fit_points) {
    open_text(editor_, R"({ "format": "batten", "version": 1, "curves": [
  { "name": "bar", "degree": 1, "knots": [0,0,1,1], "points": [[1,-1],[1,1]] } ] })");
    ASSERT_TRUE(type("through-points 0,0,2,0.5,4,0,6,1")) << said();
    ASSERT_NE(document(editor_).curves[1].fit, nullptr);
    ASSERT_TRUE(type("split-at-crossings active")) << said();
    ASSERT_EQ(names().size(), 3U);
    EXPECT_EQ(document(editor_).curves[1].fit, nullptr);
    EXPECT_EQ(document(editor_).curves[2].fit, nullptr);
}

TEST_F(JointCommands, match_meets_a_curve_that_keeps_every_bit) {
    const auto arc = document(editor_).curves[1].curve;
    ASSERT_TRUE(type("match arc G3")) << said();
    EXPECT_EQ(document(editor_).curves[1].curve, arc);
    EXPECT_EQ(names().size(), 4U);
    const core::Curve& line = curve_at(0);
    EXPECT_EQ(line.control_points().front(), core::Point(0, 1));
    EXPECT_EQ(line.control_points().back(), core::Point(-4, 1.5));
    // Counterclockwise, as the arc runs.
    EXPECT_NEAR(core::curvature_at(line, 0.0).value(), 1.0, 1e-9);
    EXPECT_LE(core::length(core::derivatives_at(line, 0.0, 1)[1] / core::length(core::derivatives_at(line, 0.0, 1)[1]) -
                           core::Vector(-1, 0)),
              1e-14);
    EXPECT_NE(said().find("Matched to 'arc' G3"), std::string::npos) << said();
    EXPECT_NE(said().find("the joint had a gap of 0.5, a turn of"), std::string::npos) << said();
    EXPECT_NE(said().find("; it has a gap of 0, a turn of 0° and the curvatures "), std::string::npos) << said();
    EXPECT_NE(said().find("per length the curvature changed by 0 and 0 there, now by 0 and"), std::string::npos)
        << said();
    EXPECT_NE(said().find("; 'line' changed from u = 0 to "), std::string::npos) << said();
    EXPECT_NE(said().find("; the degree rose from 1 to 4"), std::string::npos) << said();
    ASSERT_TRUE(run(Undo{}));
    EXPECT_EQ(curve_at(0).degree(), 1);
}

TEST_F(JointCommands, match_takes_the_end_and_the_place_asked_for) {
    // The far end of the line to the middle of the arc.
    ASSERT_TRUE(type("match arc G1 end 0.5")) << said();
    EXPECT_EQ(curve_at(0).control_points().front(), core::Point(-0.5, 1));
    const core::Point tip = curve_at(0).control_points().back();
    EXPECT_NEAR(tip.x, std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(tip.y, std::sqrt(0.5), 1e-15);
}

TEST_F(JointCommands, match_refuses_what_cannot_be_matched) {
    EXPECT_FALSE(type("match line G1"));
    EXPECT_EQ(said(), "'line' is the active curve; name another one");
    EXPECT_FALSE(type("match nobody G1"));
    EXPECT_EQ(said(), "there is no curve 'nobody'; there are 'line', 'arc', 'corner', 'bar', with the numbers 0 to 3");
    ASSERT_TRUE(run(ActivateCurve{.index = 1}));
    EXPECT_FALSE(type("match line G1"));
    EXPECT_EQ(said(), "curve 'arc' is locked; unlock it in the inspector");
}

TEST_F(JointCommands, blend_adds_a_curve_and_leaves_both) {
    const auto before = document(editor_).curves;
    ASSERT_TRUE(type("blend arc G2 G3")) << said();
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(document(editor_).curves[i].curve, before[i].curve);
    ASSERT_EQ(names().back(), "line to arc");
    EXPECT_EQ(document(editor_).active, 4U);
    EXPECT_EQ(curve(editor_).degree(), 6);
    EXPECT_EQ(curve(editor_).control_points().front(), core::Point(-0.5, 1));
    EXPECT_EQ(curve(editor_).control_points().back(), core::Point(0, 1));
    EXPECT_EQ(said().find("Made a blend to 'arc' of degree 6, 0.5"), 0U) << said();
    ASSERT_TRUE(run(Undo{}));
    // Other ends, a gentler start.
    ASSERT_TRUE(type("blend arc G1 G1 end start 0.5 2")) << said();
    EXPECT_EQ(curve(editor_).control_points().front(), core::Point(-4, 1.5));
    EXPECT_EQ(curve(editor_).control_points().back(), core::Point(1, 0));
    EXPECT_FALSE(type("blend arc G1 G1 end start 0 2"));
}

TEST_F(JointCommands, join_takes_the_ends_asked_for) {
    ASSERT_TRUE(run(ActivateCurve{.index = 2}));
    ASSERT_TRUE(type("join bar C0 start end")) << said();
    EXPECT_EQ(names(), (std::vector<std::string>{"line", "arc", "corner"}));
    EXPECT_EQ(curve(editor_).control_points().front(), core::Point(3, -1));
    EXPECT_EQ(curve(editor_).control_points().back(), core::Point(6, 3));
    ASSERT_TRUE(run(Undo{}));
    ASSERT_TRUE(type("join bar G3")) << said();
}

TEST_F(JointCommands, fillet_rounds_the_nearest_corner_of_the_active_curve) {
    ASSERT_TRUE(run(ActivateCurve{.index = 2}));
    ASSERT_TRUE(type("fillet 2 0.9")) << said();
    EXPECT_EQ(said().find("Rounded a corner with radius 2"), 0U) << said();
    EXPECT_EQ(names().size(), 4U);
    for (const core::JointContinuity& joint : core::joint_continuity(curve(editor_))) EXPECT_EQ(joint.geometric, 1);
    double nearest = 1e9;
    for (int k = 0; k <= 1000; ++k) {
        const core::Interval domain = curve(editor_).domain();
        const core::Point place = core::point_at(curve(editor_), domain.lower + domain.length() * k / 1000.0);
        nearest = std::min(nearest, core::distance(place, {6, 0}));
    }
    EXPECT_NEAR(nearest, 2 * std::sqrt(2.0) - 2, 1e-4);
    ASSERT_TRUE(run(Undo{}));
    EXPECT_FALSE(type("fillet 3.5 0.9"));
    EXPECT_EQ(said(), "the radius 3.5 is too large for an arc that touches both sides here; 2.999 is the most");
    EXPECT_FALSE(type("fillet 0 0.9"));
}

TEST_F(JointCommands, fillet_between_two_curves_joins_them_or_leaves_them_apart) {
    ASSERT_TRUE(run(ActivateCurve{.index = 2}));
    // The upper right of the four quadrants at (3, 0).
    ASSERT_TRUE(type("fillet 0.5 0.4 bar 0.9 no")) << said();
    ASSERT_EQ(names(), (std::vector<std::string>{"line", "arc", "corner", "bar", "fillet"}));
    EXPECT_LE(core::distance(curve_at(2).control_points().front(), {3.5, 0}), 1e-14);
    EXPECT_EQ(curve_at(2).control_points().back(), core::Point(6, 3));
    EXPECT_LE(core::distance(curve_at(3).control_points().front(), {3, 0.5}), 1e-14);
    EXPECT_EQ(curve_at(3).control_points().back(), core::Point(3, 1));
    EXPECT_LE(core::distance(curve_at(4).control_points().front(), curve_at(2).control_points().front()), 1e-14);
    ASSERT_TRUE(run(Undo{}));
    ASSERT_TRUE(type("fillet 0.5 0.4 bar 0.9")) << said();
    EXPECT_EQ(names(), (std::vector<std::string>{"line", "arc", "corner"}));
    EXPECT_EQ(curve(editor_).control_points().back(), core::Point(6, 3));
    EXPECT_EQ(curve(editor_).control_points().front(), core::Point(3, 1));
}

TEST_F(JointCommands, chamfer_cuts_a_corner_off) {
    ASSERT_TRUE(run(ActivateCurve{.index = 2}));
    ASSERT_TRUE(type("chamfer 1 2 1")) << said();
    EXPECT_EQ(said().find("Cut a corner off, 1 by 2"), 0U) << said();
    const auto cut = points(editor_);
    ASSERT_EQ(cut.size(), 4U);
    EXPECT_LE(core::distance(cut[1], {5, 0}), 1e-14);
    EXPECT_LE(core::distance(cut[2], {6, 2}), 1e-14);
    ASSERT_TRUE(run(Undo{}));
    EXPECT_FALSE(type("chamfer 1 3.5 1"));
    EXPECT_EQ(said(), "the distance from the corner is 3.5; the side is only 3 long");
}

TEST_F(JointCommands, trim_removes_the_part_that_was_pointed_at) {
    ASSERT_TRUE(run(ActivateCurve{.index = 2}));
    ASSERT_TRUE(type("trim 0.1")) << said();
    EXPECT_EQ(said().find("Trimmed the part from u = 0 to 0.2"), 0U) << said();
    ASSERT_EQ(points(editor_).size(), 3U);
    EXPECT_LE(core::distance(points(editor_).front(), {3, 0}), 1e-13);
    EXPECT_EQ(points(editor_).back(), core::Point(6, 3));
    EXPECT_FALSE(type("trim 0.5"));
    EXPECT_EQ(said(),
              "nothing crosses the curve here; what goes must be bounded by a crossing with another curve or with "
              "itself");
}

TEST_F(JointCommands, extend_to_meets_the_other_curve) {
    ASSERT_TRUE(run(ActivateCurve{.index = 3}));
    ASSERT_TRUE(type("split-at-crossings all")) << said();
    EXPECT_EQ(said().find("Split at crossings: there are 2 curves more"), 0U) << said();
    EXPECT_EQ(names(), (std::vector<std::string>{"line", "arc", "corner", "corner 2", "bar", "bar 2"}));
    EXPECT_EQ(document(editor_).active, 4U);
    ASSERT_TRUE(run(Undo{}));
    ASSERT_TRUE(run(ActivateCurve{.index = 0}));
    EXPECT_FALSE(type("split-at-crossings"));
    EXPECT_EQ(said(), "nothing crosses 'line'");
    EXPECT_FALSE(type("extend-to bar end straight"));
    EXPECT_EQ(said(), "the curve does not reach the other one, however far it is extended");
    // Down by 1 on a way of 7.
    ASSERT_TRUE(type("extend-to bar start straight")) << said();
    EXPECT_LE(core::distance(points(editor_).front(), {3, 0.5}), 1e-13);
    EXPECT_EQ(points(editor_).back(), core::Point(-4, 1.5));
    ASSERT_TRUE(run(Undo{}));
    ASSERT_TRUE(run(ActivateCurve{.index = 3}));
    EXPECT_FALSE(type("extend-to line end"));
    ASSERT_TRUE(run(NewCurve{.points = {{2.5, 5}, {8, 5}}, .degree = 1}));
    ASSERT_TRUE(run(ActivateCurve{.index = 3}));
    ASSERT_TRUE(type("extend-to 4 end")) << said();
    EXPECT_EQ(said().find("Extended to 'curve'"), 0U) << said();
    EXPECT_LE(core::distance(points(editor_).back(), {3, 5}), 1e-13);
    EXPECT_EQ(points(editor_).front(), core::Point(3, -1));
}

TEST_F(JointCommands, check_joints_lists_and_marks_them) {
    ASSERT_TRUE(type("check-joints 0.6")) << said();
    ASSERT_TRUE(state().findings);
    EXPECT_EQ(state().findings->summary, "2 joints: gaps 1, G⁰ 1, G¹ 0, G² 0, G³ 0");
    const auto& rows = state().findings->rows;
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].label, "start of 'line' to end of 'arc'");
    EXPECT_EQ(rows[0].note, "gap");
    EXPECT_EQ(rows[0].point, core::Point(-0.5, 1));
    EXPECT_EQ(rows[0].numbers[1].name, "gap");
    EXPECT_EQ(rows[0].numbers[1].value, 0.5);
    EXPECT_EQ(rows[1].label, "u = 1 of 'corner'");
    EXPECT_EQ(rows[1].note, "G⁰");
    EXPECT_EQ(rows[1].point, core::Point(6, 0));
    ASSERT_TRUE(run(Match{.other = "arc", .continuity = core::GeometricContinuity::g3}));
    ASSERT_TRUE(type("check-joints")) << said();
    EXPECT_EQ(state().findings->rows[0].note, "G³");
}

}  // namespace
}  // namespace batten::editor
