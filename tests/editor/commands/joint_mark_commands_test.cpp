#include "app/editor/commands/joint_mark_commands.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "app/editor/commands/closing_commands.h"
#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/drawing_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/fairing_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/piece_commands.h"
#include "app/editor/commands/pin_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/shape_commands.h"
#include "app/editor/commands/symmetry_commands.h"
#include "app/editor/commands/trim_commands.h"
#include "app/editor/state/kept_joints.h"
#include "app/editor/state/same_document.h"
#include "core/evaluate/evaluate.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

using core::JointMark;

/// Three cubic Bézier pieces, smooth at u = 1, with a corner at u = 2.
const char* pieces_text = R"({ "format": "batten", "version": 1, "curves": [
  { "name": "pieces", "degree": 3, "knots": [0,0,0,0,1,1,1,2,2,2,3,3,3,3],
    "points": [[-6,0],[-5,3],[-1,0],[0,0],[2,0],[5,3],[6,0],[8,0],[9,-3],[12,-3]] } ] })";

/// An S of two curves that meet at (0, 0), the second of which runs toward it.
const char* two_text = R"({ "format": "batten", "version": 1, "curves": [
  { "name": "first", "degree": 3, "knots": [0,0,0,0,1,1,1,1], "points": [[-6,0],[-5,3],[-1,1],[0,0]] },
  { "name": "second", "degree": 3, "knots": [0,0,0,0,2,2,2,2], "points": [[6,0],[5,-3],[1,1],[0,0]] } ] })";

class MarkedJoints : public testing::Test {
  protected:
    template <class C>
    bool run(const C& command) {
        return editor.run(command);
    }
    const EditorState& state() const { return editor.state(); }
    const std::string& message() const { return state().message.text; }
    const core::DocumentCurve& entry(std::size_t i = 0) const { return document(editor).curves[i]; }
    core::Point point(std::size_t i, std::size_t of = 0) const { return entry(of).curve->control_points()[i]; }

    double turn(double u, std::size_t of = 0) const {
        const core::Vector before = core::derivatives_at(*entry(of).curve, u, 1, core::Side::left)[1];
        const core::Vector after = core::derivatives_at(*entry(of).curve, u, 1, core::Side::right)[1];
        EXPECT_GT(core::dot(before, after), 0.0);
        return core::cross(before, after) / (core::length(before) * core::length(after));
    }
    void expect_kept(std::size_t of = 0) const {
        for (const core::KnotMark& mark : entry(of).joints.knots) {
            if (mark.mark == JointMark::corner) continue;
            EXPECT_NEAR(turn(mark.u, of), 0.0, 1e-12);
            if (mark.mark != JointMark::curvature) continue;
            const double left = core::curvature_at(*entry(of).curve, mark.u, core::Side::left).value();
            const double right = core::curvature_at(*entry(of).curve, mark.u, core::Side::right).value();
            EXPECT_NEAR(left, right, 1e-9 * std::max({std::abs(left), std::abs(right), 0.1}));
        }
    }

    Editor editor;
};

TEST_F(MarkedJoints, a_smooth_one_stays_smooth_while_its_neighbor_is_dragged) {
    open_text(editor, pieces_text);
    const core::Curve before = curve(editor);
    ASSERT_TRUE(run(MarkJoint{.mark = JointMark::smooth, .u = 1}));
    EXPECT_EQ(message(), "Marked the joint at u = 1 smooth (G1); the curve is unchanged");
    // It is smooth already.
    EXPECT_EQ(curve(editor), before);
    EXPECT_EQ(mark_at(state(), 1), JointMark::smooth);
    ASSERT_TRUE(run(SetPoint{.index = 4, .position = {0, 3}}));
    EXPECT_EQ(point(4), core::Point(0, 3));
    EXPECT_NEAR(point(2).x, 0.0, 1e-13);
    EXPECT_NEAR(point(2).y, -1.0, 1e-13);
    for (const std::size_t i : {0U, 1U, 3U, 5U, 6U, 7U, 8U, 9U}) EXPECT_EQ(point(i), before.control_points()[i]);
    EXPECT_NEAR(turn(1), 0.0, 1e-12);
    run(Undo{});
    EXPECT_EQ(curve(editor), before);
    run(Undo{});
    EXPECT_TRUE(entry().joints.is_empty());
}

TEST_F(MarkedJoints, a_preview_keeps_it_too) {
    open_text(editor, pieces_text);
    run(MarkJoint{.mark = JointMark::smooth, .u = 1});
    editor.run(SetPoint{.index = 4, .position = {0, 3}}, Phase::preview);
    EXPECT_NEAR(state().shown().active_curve()->curve->control_points()[2].y, -1.0, 1e-13);
    EXPECT_EQ(point(2), core::Point(-1, 0));
}

TEST_F(MarkedJoints, a_corner_becomes_smooth_and_then_free) {
    open_text(editor, pieces_text);
    ASSERT_TRUE(run(MarkJoint{.mark = JointMark::curvature, .u = 2}));
    expect_kept();
    EXPECT_EQ(point(6), core::Point(6, 0));
    ASSERT_TRUE(run(UnmarkJoint{.u = 2}));
    EXPECT_EQ(message(), "Unmarked the joint at u = 2");
    ASSERT_TRUE(run(SetPoint{.index = 5, .position = {6, 4}}));
    EXPECT_GT(std::abs(turn(2)), 0.01);
    EXPECT_FALSE(run(UnmarkJoint{.u = 2}));
    EXPECT_EQ(message(), "the joint at u = 2 has no mark");
}

TEST_F(MarkedJoints, what_is_no_joint_is_refused) {
    open_text(editor, pieces_text);
    EXPECT_FALSE(run(MarkJoint{.mark = JointMark::smooth, .u = 0.5}));
    EXPECT_EQ(message(), "u = 0.5 is no knot; insert one there first");
    EXPECT_FALSE(run(MarkJoint{.mark = JointMark::smooth, .u = 0}));
    EXPECT_EQ(message(), "no other end meets this one; join or match them first");
    EXPECT_FALSE(run(MarkAs<JointMark::smooth>{}));
    EXPECT_EQ(message(), "no knot is selected");
    // Nothing that could turn.
    run(PinPoints{.points = {5, 6, 7}});
    EXPECT_FALSE(run(MarkJoint{.mark = JointMark::smooth, .u = 2}));
    EXPECT_EQ(message(), "the curve cannot be made smooth (G1) at u = 2");
    EXPECT_TRUE(entry().joints.is_empty());
}

TEST_F(MarkedJoints, the_selected_knot_is_meant) {
    open_text(editor, pieces_text);
    run(SelectKnot{.index = 5});
    ASSERT_TRUE(run(MarkAs<JointMark::curvature>{}));
    EXPECT_EQ(mark_at(state(), 1), JointMark::curvature);
    EXPECT_TRUE(MarkAs<JointMark::curvature>::spec().is_checked(state()));
    ASSERT_TRUE(run(MarkAs<JointMark::corner>{}));
    EXPECT_EQ(entry().joints.knots.size(), 1U);
    ASSERT_TRUE(run(SetPoint{.index = 4, .position = {1, 5}}));
    EXPECT_GT(std::abs(turn(1)), 0.1);
}

TEST_F(MarkedJoints, what_cannot_be_kept_is_done_and_told) {
    open_text(editor, pieces_text);
    run(MarkJoint{.mark = JointMark::smooth, .u = 1});
    run(PinPoints{.points = {2}});
    // Onto its neighbor, where the curve has no direction.
    ASSERT_TRUE(run(SetPoint{.index = 3, .position = {-1, 0}}));
    EXPECT_TRUE(entry().joints.is_empty()) << message();
    EXPECT_NE(message().find("the joint at u = 1 could not be kept smooth (G1), and its mark is gone"),
              std::string::npos)
        << message();
}

TEST_F(MarkedJoints, marks_follow_their_knots) {
    open_text(editor, pieces_text);
    run(MarkJoint{.mark = JointMark::smooth, .u = 1});
    run(MarkJoint{.mark = JointMark::corner, .u = 2});
    ASSERT_TRUE(run(Reverse{}));
    EXPECT_EQ(entry().joints.knots, (std::vector<core::KnotMark>{{1, JointMark::corner}, {2, JointMark::smooth}}));
    ASSERT_TRUE(run(SetKnots{.knots = {0, 0, 0, 0, 2, 2, 2, 5, 5, 5, 6, 6, 6, 6}}));
    EXPECT_EQ(entry().joints.knots, (std::vector<core::KnotMark>{{2, JointMark::corner}, {5, JointMark::smooth}}));
    expect_kept();
    ASSERT_TRUE(run(InsertKnot{.u = 3}));
    EXPECT_EQ(entry().joints.knots.size(), 2U);
    ASSERT_TRUE(run(Split{.u = 3}));
    EXPECT_EQ(entry(0).joints.knots, (std::vector<core::KnotMark>{{2, JointMark::corner}}));
    EXPECT_EQ(entry(1).joints.knots, (std::vector<core::KnotMark>{{5, JointMark::smooth}}));
}

TEST_F(MarkedJoints, ends_of_two_curves_stay_together) {
    open_text(editor, two_text);
    ASSERT_TRUE(run(MarkJoint{.mark = JointMark::smooth, .u = 1})) << message();
    // (-1,1) (0,0) (1,1): both turn by 45 degrees.
    EXPECT_NEAR(point(2).y, 0.0, 1e-13);
    EXPECT_NEAR(point(2, 1).y, 0.0, 1e-13);
    EXPECT_EQ(partner_of(document(editor), {0, core::CurveEnd::end}), (DocumentEnd{1, core::CurveEnd::end}));
    ASSERT_TRUE(run(SetPoint{.index = 3, .position = {0.1, 0.2}}));
    EXPECT_EQ(point(3, 1), core::Point(0.1, 0.2));
    EXPECT_EQ(point(0, 1), core::Point(6, 0));
    EXPECT_EQ(point(1, 1), core::Point(5, -3));
    const core::Vector leg = point(3) - point(2);
    EXPECT_NEAR(core::cross(leg, point(2, 1) - point(3, 1)), 0.0, 1e-12);
    // From the other side, too.
    run(ActivateCurve{.index = 1});
    ASSERT_TRUE(run(SetPoint{.index = 2, .position = {0.1, 3}}));
    EXPECT_NEAR(point(2).x, 0.1, 1e-12);
    EXPECT_LT(point(2).y, 0.2);
    ASSERT_TRUE(run(UnmarkJoint{.u = 2}));
    EXPECT_TRUE(entry(0).joints.is_empty() && entry(1).joints.is_empty());
}

TEST_F(MarkedJoints, a_deleted_curve_takes_its_joint_along_and_a_copy_has_none) {
    open_text(editor, two_text);
    run(MarkJoint{.mark = JointMark::corner, .u = 1});
    ASSERT_TRUE(run(DuplicateCurve{.index = 1, .shift = 0.5}));
    EXPECT_TRUE(entry(2).joints.is_empty());
    ASSERT_TRUE(run(DeleteCurve{.index = 1}));
    EXPECT_TRUE(entry(0).joints.is_empty());
    run(Undo{});
    EXPECT_EQ(entry(0).joints.ends.size(), 1U);
}

TEST_F(MarkedJoints, joining_curves_keeps_the_marks_of_both) {
    open_text(editor, R"({ "format": "batten", "version": 1, "curves": [
  { "name": "first", "degree": 3, "knots": [0,0,0,0,1,1,1,2,2,2,2], "joints": [{"u": 1, "mark": "smooth"}, {"end": "end", "joint": 3, "mark": "smooth"}],
    "points": [[-9,0],[-8,1],[-7,0],[-6,0],[-5,0],[-1,0],[0,0]] },
  { "name": "second", "degree": 3, "knots": [0,0,0,0,3,3,3,4,4,4,4], "joints": [{"u": 3, "mark": "smooth"}, {"end": "end", "joint": 3, "mark": "smooth"}],
    "points": [[9,0],[8,1],[7,0],[6,0],[4,0],[1,0],[0,0]] } ] })");
    ASSERT_TRUE(run(Join{.other = "second", .continuity = core::JoinContinuity::g1})) << message();
    ASSERT_EQ(document(editor).curves.size(), 1U);
    const auto& marks = entry().joints.knots;
    ASSERT_EQ(marks.size(), 3U) << message();
    EXPECT_EQ(marks[0], (core::KnotMark{1, JointMark::smooth}));
    // The ends that were marked are a knot now, and the other curve runs the other way.
    EXPECT_EQ(marks[1], (core::KnotMark{2, JointMark::smooth}));
    EXPECT_NEAR(core::distance(core::point_at(curve(editor), marks[2].u), {6, 0}), 0.0, 1e-9);
    expect_kept();
    EXPECT_TRUE(entry().joints.ends.empty());
}

TEST_F(MarkedJoints, images_of_a_joined_curve_have_each_mark_once) {
    open_text(editor, R"({ "format": "batten", "version": 1, "curves": [
  { "name": "first", "degree": 3, "knots": [0,0,0,0,2,2,2,2], "points": [[-6,0],[-5,0],[-1,0],[0,0]] },
  { "name": "second", "degree": 3, "knots": [0,0,0,0,3,3,3,4,4,4,4], "joints": [{"u": 3, "mark": "corner"}],
    "points": [[9,0],[8,1],[7,0],[6,0],[5,2],[1,0],[0,0]] } ] })");
    ASSERT_TRUE(run(LinkMirror{.center = {0, -8}, .angle = 0, .is_smooth = false}));
    ASSERT_TRUE(run(MarkJoint{.mark = JointMark::corner, .u = 2})) << message();
    ASSERT_TRUE(run(Join{.other = "second", .continuity = core::JoinContinuity::g2})) << message();
    ASSERT_EQ(document(editor).curves.size(), 2U);
    for (const std::size_t i : {0U, 1U}) {
        const auto& marks = entry(i).joints.knots;
        ASSERT_EQ(marks.size(), 2U);
        EXPECT_EQ(marks[0].u, 2.0);
        EXPECT_NEAR(core::distance(core::point_at(*entry(i).curve, marks[1].u), {6, i == 0 ? 0.0 : -16.0}), 0.0, 1e-9);
    }
}

TEST_F(MarkedJoints, knots_that_become_one_keep_the_mark_that_asks_for_least) {
    open_text(editor, R"({ "format": "batten", "version": 1, "curves": [
  { "name": "bow", "degree": 3, "knots": [0,0,0,0,1,2,4,4,4,4], "points": [[0,0],[1,3],[3,4],[5,4],[7,3],[8,0]],
    "joints": [{"u": 1, "mark": "curvature"}, {"u": 2, "mark": "smooth"}] } ] })");
    ASSERT_TRUE(run(MoveKnot{.index = 4, .u = 2.0, .mode = core::KnotMove::snap, .snap_distance = 0.1})) << message();
    EXPECT_EQ(entry().joints.knots, (std::vector<core::KnotMark>{{2, JointMark::smooth}}));
    EXPECT_NE(message().find("; marked knots that became one keep the mark that asks for least"), std::string::npos)
        << message();
}

TEST_F(MarkedJoints, images_have_the_marks_of_each_other) {
    open_text(editor, pieces_text);
    run(MarkJoint{.mark = JointMark::smooth, .u = 1});
    ASSERT_TRUE(run(LinkMirror{.center = {0, -8}, .angle = 0, .is_smooth = false}));
    EXPECT_EQ(entry(1).joints.knots, entry(0).joints.knots);
    ASSERT_TRUE(run(SetPoint{.index = 4, .position = {0, 3}}));
    expect_kept(0);
    expect_kept(1);
}

TEST_F(MarkedJoints, fairing_and_reducing_keep_them) {
    open_text(editor, pieces_text);
    run(MarkJoint{.mark = JointMark::curvature, .u = 1});
    run(MarkJoint{.mark = JointMark::smooth, .u = 2});
    for (const Command& command :
         {Command(Fair{.distance = 0.2}), Command(FairPart{.from = 0.2, .to = 1.8, .distance = 0.3}),
          Command(MoveCurvePoint{.u = 1.2, .position = {1.5, 1.0}}),
          Command(SetTangent{.u = 1.0, .derivative = {4.0, 2.0}}), Command(SetWeight{.index = 4, .weight = 2.0})}) {
        ASSERT_TRUE(editor.run(command)) << message();
        EXPECT_EQ(entry().joints.knots.size(), 2U) << message();
        expect_kept();
    }
}

TEST_F(MarkedJoints, two_hundred_random_edits_keep_all_and_are_undone_bit_by_bit) {
    open_text(editor, pieces_text);
    run(MarkJoint{.mark = JointMark::curvature, .u = 1});
    run(MarkJoint{.mark = JointMark::smooth, .u = 2});
    ASSERT_EQ(entry().joints.knots.size(), 2U);
    const core::Document start = document(editor);
    const std::size_t first = state().history.undo_count();
    std::mt19937 random(11);
    const auto between = [&](double lower, double upper) {
        return std::uniform_real_distribution(lower, upper)(random);
    };
    for (int k = 0; k < 200; ++k) {
        const std::size_t i = std::uniform_int_distribution<std::size_t>(0, 9)(random);
        const core::Vector offset(between(-0.4, 0.4), between(-0.4, 0.4));
        const core::Point home = start.curves[0].curve->control_points()[i];
        switch (k % 4) {
            case 0:
                run(MoveCurvePoint{.u = between(0, 3), .position = core::point_at(curve(editor), between(0, 3))});
                run(Undo{});
                run(MoveCurvePoint{.u = 0.3 + 0.8 * (k % 3),
                                   .position = core::point_at(curve(editor), 0.3 + 0.8 * (k % 3)) + offset});
                break;
            case 1:
                run(SoftMove{.center = home, .offset = offset, .radius = 3.0});
                break;
            default:
                // Near its home, so that the shape does not degenerate.
                run(SetPoint{.index = i, .position = home + offset});
        }
        ASSERT_EQ(entry().joints.knots.size(), 2U) << k << ": " << message();
        expect_kept();
    }
    while (state().history.undo_count() > first) run(Undo{});
    EXPECT_TRUE(is_same_document(document(editor), start));
}

/// An S of two curves, of which the second begins where the first ends, smoothly.
const char* row_text = R"({ "format": "batten", "version": 1, "curves": [
  { "name": "first", "degree": 3, "knots": [0,0,0,0,1,1,1,1], "points": [[0,0],[1,2],[2,2],[3,0]],
    "joints": [{"end": "end", "joint": 0, "mark": "smooth"}] },
  { "name": "second", "degree": 3, "knots": [0,0,0,0,1,1,1,1], "points": [[3,0],[4,-2],[5,-2],[6,0]],
    "joints": [{"end": "start", "joint": 0, "mark": "smooth"}] } ] })";

TEST_F(MarkedJoints, the_end_of_a_curve_that_is_split_is_that_of_its_last_part) {
    open_text(editor, row_text);
    const core::Curve second = *entry(1).curve;
    ASSERT_TRUE(run(Split{.u = 0.5}));
    ASSERT_EQ(document(editor).curves.size(), 3U);
    EXPECT_TRUE(entry(0).joints.is_empty());
    EXPECT_EQ(entry(1).joints.ends, (std::vector<core::EndMark>{{core::CurveEnd::end, 0, JointMark::smooth}}));
    EXPECT_EQ(entry(2).joints.ends, (std::vector<core::EndMark>{{core::CurveEnd::start, 0, JointMark::smooth}}));
    // De Casteljau's algorithm in halves, bit by bit.
    EXPECT_EQ(point(0, 1), core::Point(1.5, 1.5));
    EXPECT_EQ(point(1, 1), core::Point(2, 1.5));
    EXPECT_EQ(point(2, 1), core::Point(2.5, 1));
    EXPECT_EQ(point(3, 1), core::Point(3, 0));
    EXPECT_EQ(*entry(2).curve, second);
}

TEST_F(MarkedJoints, what_is_cut_off_leaves_the_other_curve_alone) {
    open_text(editor, row_text);
    const core::Curve second = *entry(1).curve;
    ASSERT_TRUE(run(SubCurve{.begin = 0, .end = 0.5}));
    EXPECT_TRUE(entry(0).joints.is_empty() && entry(1).joints.is_empty());
    EXPECT_EQ(*entry(1).curve, second);
    EXPECT_NE(message().find("the marked joints of 'first' are marked no more"), std::string::npos) << message();
    run(Undo{});
    ASSERT_TRUE(run(SubCurve{.begin = 0.5, .end = 1}));
    EXPECT_EQ(entry(0).joints.ends.size(), 1U);
    EXPECT_EQ(entry(1).joints.ends.size(), 1U);
    EXPECT_EQ(*entry(1).curve, second);
}

TEST_F(MarkedJoints, the_far_end_of_a_curve_that_is_joined_keeps_its_joint) {
    open_text(editor, R"({ "format": "batten", "version": 1, "curves": [
  { "name": "first", "degree": 1, "knots": [0,0,1,1], "points": [[0,0],[1,0]] },
  { "name": "second", "degree": 1, "knots": [0,0,1,1], "points": [[1,0],[2,0]],
    "joints": [{"end": "end", "joint": 4, "mark": "corner"}] },
  { "name": "third", "degree": 1, "knots": [0,0,1,1], "points": [[2,0],[2,3]],
    "joints": [{"end": "start", "joint": 4, "mark": "corner"}] } ] })");
    ASSERT_TRUE(run(Join{.other = "second", .continuity = core::JoinContinuity::c0})) << message();
    ASSERT_EQ(document(editor).curves.size(), 2U);
    EXPECT_EQ(entry(0).joints.ends, (std::vector<core::EndMark>{{core::CurveEnd::end, 4, JointMark::corner}}));
    EXPECT_EQ(entry(1).joints.ends, (std::vector<core::EndMark>{{core::CurveEnd::start, 4, JointMark::corner}}));
}

TEST_F(MarkedJoints, marks_of_a_periodic_curve_follow_its_seam_and_its_direction) {
    open_text(editor, R"({ "format": "batten", "version": 1, "curves": [
  { "name": "ring", "degree": 3, "periodic": true, "knots": [0,1,1,2,4,4,6],
    "points": [[0,0],[3,0],[4,2],[3,4],[0,4],[-1,2]],
    "joints": [{"u": 1, "mark": "smooth"}, {"u": 4, "mark": "corner"}] } ] })");
    const core::Point smooth = core::point_at(curve(editor), 1);
    const core::Point corner = core::point_at(curve(editor), 4);
    const auto expect_at_places = [&] {
        ASSERT_EQ(entry().joints.knots.size(), 2U) << message();
        for (const core::KnotMark& mark : entry().joints.knots) {
            const core::Point there = core::point_at(curve(editor), mark.u);
            EXPECT_NEAR(core::distance(there, mark.mark == JointMark::smooth ? smooth : corner), 0.0, 1e-12) << mark.u;
        }
    };
    ASSERT_TRUE(run(Reverse{}));
    expect_at_places();
    EXPECT_EQ(entry().joints.knots[0], (core::KnotMark{2, JointMark::corner}));
    EXPECT_EQ(entry().joints.knots[1], (core::KnotMark{5, JointMark::smooth}));
    run(Undo{});
    for (const double u : {1.0, 2.0, 3.0}) {
        ASSERT_TRUE(run(MoveSeam{.u = u, .tolerance = 1e-6}));
        expect_at_places();
        run(Undo{});
    }
}

// A square of four pieces, cut by a level line through its middle: the lower half goes on over the seam at (0, 0).
TEST_F(MarkedJoints, of_what_is_left_of_a_closed_curve_follow_over_its_seam) {
    constexpr const char* square_text = R"({ "format": "batten", "version": 1, "curves": [
      { "name": "square", "degree": 2, "knots": [0,0,0,1,1,2,2,3,3,4,4,4],
        "points": [[0,0],[2,0],[4,0],[4,2],[4,4],[2,4],[0,4],[0,2],[0,0]] },
      { "name": "level", "degree": 1, "knots": [0,0,1,1], "points": [[-1,2],[5,2]] } ] })";
    open_text(editor, square_text);
    for (const double u : {1.0, 2.0, 0.0}) ASSERT_TRUE(run(MarkJoint{.mark = JointMark::corner, .u = u})) << message();
    ASSERT_TRUE(run(Trim{.u = 2.5}));
    EXPECT_EQ(message(),
              "Trimmed the part from u = 1.5 to 3.5; u = 2 is no knot inside a curve any more, and its mark is gone");
    const std::vector<core::KnotMark>& marks = entry().joints.knots;
    ASSERT_EQ(marks.size(), 2U);
    EXPECT_EQ(marks[0].u, 4.0);
    EXPECT_EQ(marks[1].u, 5.0);
    EXPECT_EQ(core::point_at(*entry().curve, 4.0), core::Point(0, 0));
    EXPECT_EQ(core::point_at(*entry().curve, 5.0), core::Point(4, 0));
    EXPECT_TRUE(core::parse_document(core::format_document(document(editor))));
    // Both halves have the marks of the whole, and none is lost.
    ASSERT_TRUE(run(Undo{}));
    ASSERT_TRUE(run(SplitAtCrossings{.scope = SplitScope::active}));
    EXPECT_EQ(message(), "Split at crossings: there is one curve more; the curve is unchanged");
    ASSERT_EQ(entry(0).joints.knots.size(), 2U);
    EXPECT_EQ(entry(0).joints.knots[0].u, 4.0);
    EXPECT_EQ(entry(0).joints.knots[1].u, 5.0);
    ASSERT_EQ(entry(1).joints.knots.size(), 1U);
    EXPECT_EQ(entry(1).joints.knots[0].u, 2.0);
}

TEST_F(MarkedJoints, ends_of_a_curve_that_is_closed_are_its_seam) {
    open_text(editor, R"({ "format": "batten", "version": 1, "curves": [
  { "name": "loop", "degree": 3, "knots": [0,0,0,0,1,1,1,1], "points": [[0,0],[2,2],[-2,2],[0,0]],
    "joints": [{"end": "start", "joint": 3, "mark": "corner"}, {"end": "end", "joint": 3, "mark": "corner"}] } ] })");
    ASSERT_TRUE(run(CloseOrOpen{})) << message();
    EXPECT_TRUE(entry().joints.ends.empty());
    EXPECT_EQ(entry().joints.knots, (std::vector<core::KnotMark>{{0, JointMark::corner}}));
}

TEST_F(MarkedJoints, a_curve_that_is_closed_leaves_no_other_end_marked) {
    open_text(editor, row_text);
    ASSERT_TRUE(run(CloseOrOpen{})) << message();
    EXPECT_TRUE(entry(0).joints.is_empty() && entry(1).joints.is_empty());
    EXPECT_NE(message().find("the marked joints of 'first' are marked no more"), std::string::npos) << message();
}

TEST_F(MarkedJoints, a_curve_beside_an_image_follows_it) {
    open_text(editor, R"({ "format": "batten", "version": 1, "curves": [
  { "name": "right", "degree": 3, "knots": [0,0,0,0,1,1,1,1], "points": [[1,0],[2,2],[3,2],[4,0]],
    "symmetry": {"group": 0, "place": 0, "center": [0,0], "mirror": 90} },
  { "name": "left", "degree": 3, "knots": [0,0,0,0,1,1,1,1], "points": [[-1,0],[-2,2],[-3,2],[-4,0]],
    "symmetry": {"group": 0, "place": 1, "center": [0,0], "mirror": 90},
    "joints": [{"end": "end", "joint": 0, "mark": "smooth"}] },
  { "name": "tail", "degree": 3, "knots": [0,0,0,0,1,1,1,1], "points": [[-4,0],[-5,-2],[-6,-2],[-7,0]],
    "joints": [{"end": "start", "joint": 0, "mark": "smooth"}] } ] })");
    ASSERT_TRUE(run(SetPoint{.index = 3, .position = {5, 1}}));
    EXPECT_EQ(point(3, 1), core::Point(-5, 1));
    EXPECT_EQ(point(3, 1), point(0, 2));
    ASSERT_TRUE(run(SetPoint{.index = 2, .position = {4, 4}}));
    EXPECT_EQ(point(2, 1), core::Point(-4, 4));
    const core::Vector leg = point(1, 2) - point(0, 2);
    EXPECT_NEAR(core::cross(leg, core::Vector(-1, -3)) / core::length(leg), 0.0, 1e-12);
    EXPECT_EQ(entry(2).joints.ends.size(), 1U);
    // Backwards, the image has its joint at the other end.
    ASSERT_TRUE(run(Reverse{}));
    EXPECT_EQ(entry(1).joints.ends, (std::vector<core::EndMark>{{core::CurveEnd::start, 0, JointMark::smooth}}));
    EXPECT_EQ(point(0, 1), point(0, 2));
    // What is locked cannot follow.
    run(SetCurveLocked{.index = 2, .locked = true});
    ASSERT_TRUE(run(SetPoint{.index = 0, .position = {7, 7}}));
    EXPECT_EQ(point(0, 1), core::Point(-7, 7));
    EXPECT_TRUE(entry(1).joints.is_empty() && entry(2).joints.is_empty());
    EXPECT_NE(message().find("could not be kept"), std::string::npos) << message();
}

TEST_F(MarkedJoints, are_written_and_read) {
    open_text(editor, two_text);
    run(MarkJoint{.mark = JointMark::smooth, .u = 1});
    const core::Document written = document(editor);
    EXPECT_EQ(core::parse_document(core::format_document(written))->curves[1].joints, written.curves[1].joints);
    EXPECT_EQ(written.curves[1].joints.ends, (std::vector<core::EndMark>{{core::CurveEnd::end, 0, JointMark::smooth}}));
}

TEST_F(MarkedJoints, of_a_bezier_path_are_those_that_were_drawn_smooth) {
    // Smooth at (3, 2); a corner at (6, -1); a cusp at (9, 0); no handles at (12, 0), on a straight line.
    const std::vector<core::Point> points{{0, 0}, {1, 2}, {2, 2}, {3, 2},  {5, 2},  {6, 0},  {6, -1}, {7, -1},
                                          {8, 0}, {9, 0}, {8, 0}, {12, 0}, {12, 0}, {12, 0}, {16, 0}, {16, 0}};
    ASSERT_TRUE(run(BezierPath{.points = points}));
    const std::size_t path = document(editor).active;
    EXPECT_EQ(entry(path).joints.knots, (std::vector<core::KnotMark>{{1.0, JointMark::smooth}}));
    ASSERT_TRUE(run(MovePoints{.points = {4}, .offset = {0, 1}}));
    EXPECT_EQ(point(4, path), core::Point(5, 3));
    EXPECT_LT(core::distance(point(2, path), {3 - 2 / std::sqrt(5), 2 - 1 / std::sqrt(5)}), 1e-12)
        << "the other handle is opposite, as long as it was";
}

TEST_F(MarkedJoints, of_a_closed_bezier_path_may_lie_at_its_seam) {
    ASSERT_TRUE(run(BezierPath{.points = {{0, 0}, {0, 1}, {1, 2}, {2, 2}, {2, 1}, {0, -1}}, .closed = true}));
    EXPECT_EQ(entry(document(editor).active).joints.knots, (std::vector<core::KnotMark>{{0.0, JointMark::smooth}}));
}

}  // namespace
}  // namespace batten::editor
