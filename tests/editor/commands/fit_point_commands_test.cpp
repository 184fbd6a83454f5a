#include "app/editor/commands/fit_point_commands.h"

#include <gtest/gtest.h>

#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/drawing_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/transform_commands.h"
#include "core/evaluate/evaluate.h"
#include "core/make/through_points.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

class FitPointCommands : public ::testing::Test {
  protected:
    const EditorState& state() const { return editor_.state(); }
    const std::string& message() const { return state().message.text; }
    bool run(const Command& command) { return editor_.run(command); }
    bool type(const std::string& text) { return run_typed(editor_, text); }
    const core::FitPoints* fit() const { return document(editor_).active_curve()->fit.get(); }
    core::Point place(std::size_t i) const { return fit()->points[i].place; }

    void expect_made_of_points() const {
        ASSERT_NE(fit(), nullptr);
        EXPECT_EQ(core::through_points(*fit()).value(), curve(editor_));
    }
    void expect_refused(const std::string& typed, const std::string& sentence) {
        EXPECT_FALSE(type(typed)) << typed;
        EXPECT_EQ(message(), sentence);
    }
    void expect_said(const std::string& typed, const std::string& begin) {
        EXPECT_TRUE(type(typed)) << message();
        EXPECT_EQ(message().substr(0, begin.size()), begin);
    }

    Editor editor_;
};

constexpr const char* zigzag = "through-points 0,0,3,4,3,13,15,18";

TEST_F(FitPointCommands, draw_a_curve_that_keeps_its_points) {
    expect_said(zigzag, "Drew C² curve through points");
    expect_made_of_points();
    EXPECT_EQ(fit()->parameters, (std::vector<double>{0, 5, 14, 27}));
    EXPECT_EQ(curve(editor_).degree(), 3);
    expect_said("through-points 0,0,3,0,3,4 fair uniform yes", "Drew fair curve through points");
    expect_made_of_points();
    EXPECT_TRUE(curve(editor_).is_periodic());
    EXPECT_EQ(fit()->parameters, (std::vector<double>{0, 1, 2, 3}));
    EXPECT_EQ(document(editor_).active_curve()->name, "curve 2");
    run(Undo{});
    run(Undo{});
    EXPECT_TRUE(document(editor_).curves.empty());
    expect_refused("through-points 0,0,1,0,1,0", "point 2 lies on point 1; the two must differ");
}

TEST_F(FitPointCommands, move_put_in_and_take_out_points) {
    type(zigzag);
    const core::Document before = document(editor_);
    expect_said("move-fit-point 1 3 5", "Moved fit point 1 from (3, 4) to (3, 5)");
    EXPECT_EQ(place(1), core::Point(3, 5));
    expect_made_of_points();
    expect_said("insert-fit-point 4 20 18", "Inserted fit point 4 at (20, 18)");
    EXPECT_EQ(fit()->points.size(), 5U);
    EXPECT_EQ(state().selection.fit_point, 4U);
    expect_made_of_points();
    expect_said("delete-fit-point 0", "Deleted fit point 0");
    EXPECT_EQ(place(0), core::Point(3, 5));
    EXPECT_EQ(state().selection, Selection{});
    expect_made_of_points();
    for (int i = 0; i < 3; ++i) run(Undo{});
    EXPECT_EQ(*document(editor_).active_curve()->fit, *before.active_curve()->fit);
    EXPECT_EQ(curve(editor_), *before.active_curve()->curve);
    expect_refused("move-fit-point 4 0 0", "there is no fit point 4; the last one is 3");
    expect_refused("delete-fit-point 7", "there is no fit point 7; the last one is 3");
}

TEST_F(FitPointCommands, set_joints) {
    type(zigzag);
    expect_said("set-fit-joint 1 corner", "Set joint of fit point 1 to 'corner'");
    EXPECT_EQ(curve(editor_).knots().multiplicity(5.0), 3);
    expect_said("set-fit-joint 1 tangent 7 14", "Set handle of fit point 1 to (7, 14)");
    EXPECT_LT(core::length(core::derivatives_at(curve(editor_), 5.0, 1)[1] - core::Vector(3, 6)), 1e-13);
    expect_said("set-fit-joint 1 smooth", "Set joint of fit point 1 to 'smooth'");
    EXPECT_EQ(fit()->points[1].handle, core::Vector(0, 0));
    // The tangent that the curve has keeps its shape.
    const core::Point middle = core::point_at(curve(editor_), 9.0);
    const core::Vector derivative = core::derivatives_at(curve(editor_), 14.0, 1)[1];
    type("set-fit-joint 2 tangent");
    EXPECT_LT(core::length(fit()->points[2].handle - 11.0 / 3.0 * derivative), 1e-13);
    EXPECT_LT(core::distance(core::point_at(curve(editor_), 9.0), middle), 0.3);
    expect_refused("set-fit-joint 1 round",
                   "joint is 'round'; it must be smooth, tangent, corner, straight or corner-straight");
    expect_refused("set-fit-joint 4 corner", "there is no fit point 4; the last one is 3");
    expect_made_of_points();
}

TEST_F(FitPointCommands, change_the_kind) {
    type(zigzag);
    expect_said("set-fit-kind local", "Made the curve through its points anew: local, chordal");
    EXPECT_EQ(fit()->kind, core::FitKind::local);
    type("set-fit-kind fair centripetal yes");
    EXPECT_TRUE(curve(editor_).is_periodic());
    EXPECT_EQ(curve(editor_).degree(), 5);
    EXPECT_DOUBLE_EQ(fit()->parameters[2], std::sqrt(5.0) + 3.0);
    expect_made_of_points();
}

// Of clamped cubics the tangents at the ends are the first and the last leg; at a double knot it is the leg with the
// point.
TEST_F(FitPointCommands, fairing_keeps_given_tangents) {
    for (const char* at : {"0", "3", "2"}) {
        type("through-points 0,0,3,4,6,3,9,5,12,0");
        type(std::string("set-fit-joint ") + at + " tangent 0.3 0.4");
        const core::Curve before = curve(editor_);
        const double u = fit()->parameters[static_cast<std::size_t>(*at - '0')];
        EXPECT_TRUE(type("fair 0.2")) << message();
        EXPECT_NE(curve(editor_), before);
        const auto [old, now] =
            std::pair(core::derivatives_at(before, u, 1), core::derivatives_at(curve(editor_), u, 1));
        EXPECT_LT(core::distance(now.point, old.point), 1e-13);
        EXPECT_LT(core::length(now[1] - old[1]), 1e-13);
        EXPECT_NEAR(now[1].y * 3.0, now[1].x * 4.0, 1e-12);
    }
}

TEST_F(FitPointCommands, only_curves_of_fit_points_have_them) {
    open_text(editor_, bezier_text);
    const std::string sentence =
        "this curve is not made of fit points; 'Curve through points' and the pen make such curves";
    for (const char* typed : {"move-fit-point 0 1 1", "insert-fit-point 0 1 1", "delete-fit-point 0",
                              "set-fit-joint 0 corner", "set-fit-kind local", "make-ordinary", "select-fit-point 0"})
        expect_refused(typed, sentence);
    expect_said("through-points", "Drew C² curve through points");
    EXPECT_EQ(fit()->points.size(), 4U);
}

TEST_F(FitPointCommands, turn_into_an_ordinary_curve) {
    type(zigzag);
    const core::Curve before = curve(editor_);
    expect_said("make-ordinary", "Turned into an ordinary curve");
    EXPECT_EQ(message().find("without fit points"), std::string::npos);
    EXPECT_EQ(fit(), nullptr);
    EXPECT_EQ(curve(editor_), before);
    run(Undo{});
    expect_made_of_points();
}

TEST_F(FitPointCommands, affine_maps_take_the_points_along) {
    type(zigzag);
    type("set-fit-joint 1 tangent 1 2");
    const core::Curve before = curve(editor_);
    expect_said("stretch 2 3 curve 0 0", "Stretched");
    EXPECT_EQ(message().find("ordinary"), std::string::npos);
    EXPECT_EQ(place(3), core::Point(30, 54));
    EXPECT_EQ(fit()->points[1].handle, core::Vector(2, 6));
    EXPECT_EQ(fit()->parameters, (std::vector<double>{0, 5, 14, 27}));
    expect_made_of_points();
    for (const double u : {1.0, 7.0, 20.0}) {
        const core::Point was = core::point_at(before, u);
        EXPECT_LT(core::distance(core::point_at(curve(editor_), u), core::Point(2 * was.x, 3 * was.y)), 1e-12);
    }
    type("rotate 90 all 0 0");
    EXPECT_EQ(place(3), core::Point(-54, 30));
    expect_made_of_points();
    // All points moved are the curve moved, whoever asks.
    run(SelectAll{});
    run(MovePoints{.points = state().selection.points, .offset = {54, 0}});
    EXPECT_EQ(place(3), core::Point(0, 30));
    expect_made_of_points();
    type("duplicate 1");
    EXPECT_EQ(place(3), core::Point(1, 29));
    expect_made_of_points();
    EXPECT_EQ(document(editor_).curves[0].fit->points[3].place, core::Point(0, 30));
}

TEST_F(FitPointCommands, every_other_edit_leaves_an_ordinary_curve_and_says_so) {
    const std::string said = "the curve is an ordinary one now, without fit points";
    for (const char* edit :
         {"insert-knot 3", "set-point 1 0 9", "elevate", "reverse", "project 1,0,0 0,1,0 0.01,0,1"}) {
        type(zigzag);
        EXPECT_TRUE(type(edit)) << edit << ": " << message();
        EXPECT_EQ(fit(), nullptr) << edit;
        EXPECT_NE(message().find(said), std::string::npos) << message();
        run(Undo{});
        expect_made_of_points();
    }
    type("rename hull");
    expect_made_of_points();
}

TEST_F(FitPointCommands, delete_takes_out_the_selected_point) {
    type(zigzag);
    type("select-fit-point 1");
    EXPECT_EQ(state().selection.fit_point, 1U);
    run(Delete{});
    EXPECT_EQ(message().substr(0, 19), "Deleted fit point 1");
    EXPECT_EQ(fit()->points.size(), 3U);
    expect_refused("select-fit-point 3", "there is no fit point 3; the last one is 2");
    type("select-fit-point 2");
    run(SelectNone{});
    EXPECT_EQ(state().selection, Selection{});
}

TEST_F(FitPointCommands, copies_keep_their_points) {
    type(zigzag);
    run(Copy{});
    run(PasteBeside{.text = state().clipboard, .shift = 2.0});
    EXPECT_EQ(document(editor_).curves.size(), 2U);
    EXPECT_EQ(place(0), core::Point(2, -2));
    expect_made_of_points();
}

TEST_F(FitPointCommands, draw_bezier_paths) {
    expect_said("bezier-path 0,0,1,1,2,1,3,0,4,-1,5,-1,6,0", "Drew Bézier path");
    EXPECT_EQ(curve(editor_).knots().kind(), core::KnotKind::piecewise_bezier);
    EXPECT_EQ(core::point_at(curve(editor_), 0.5), core::Point(1.5, 0.75));
    EXPECT_EQ(core::point_at(curve(editor_), 1.0), core::Point(3, 0));
    EXPECT_EQ(fit(), nullptr);
    // (0 + 3 + 6 + 4) / 8 and so on, on the second piece, which leads back.
    expect_said("bezier-path 0,0,1,1,2,1,4,0,3,-3,0,-3 yes", "Drew Bézier path");
    EXPECT_TRUE(curve(editor_).is_periodic());
    EXPECT_EQ(core::point_at(curve(editor_), 0.0), core::Point(0, 0));
    EXPECT_EQ(core::point_at(curve(editor_), 1.0), core::Point(4, 0));
    EXPECT_EQ(core::point_at(curve(editor_), 1.5), core::Point(13.0 / 8.0, -18.0 / 8.0));
    expect_refused(
        "bezier-path 0,0,1,1,2,1,3,0,4,4",
        "these knots need another number of points; Bézier takes degree + 1, piecewise Bézier k · degree + 1");
}

TEST_F(FitPointCommands, thousands_of_points_are_previewed) {
    std::vector<core::Point> places;
    for (int k = 0; k < 7000; ++k) places.emplace_back(0.1 * k, std::sin(0.37 * k));
    for (const core::FitKind kind : {core::FitKind::c2, core::FitKind::local, core::FitKind::fair}) {
        ASSERT_TRUE(run(ThroughPoints{.points = places, .kind = kind}));
        ASSERT_TRUE(editor_.run(MoveFitPoint{.index = 3500, .position = {350.0, 2.0}}, Phase::preview));
        EXPECT_EQ(state().shown().active_curve()->fit->points[3500].place, core::Point(350.0, 2.0));
        editor_.cancel_preview();
        expect_made_of_points();
    }
}

TEST_F(FitPointCommands, arrow_keys_nudge_the_selected_fit_point) {
    ASSERT_TRUE(type(zigzag));
    EXPECT_FALSE(run(Nudge{.offset = {1, 0}}));
    EXPECT_EQ(message(), "no control point is selected");
    ASSERT_TRUE(run(SelectFitPoint{.index = 1}));
    EXPECT_TRUE(run(Nudge{.offset = {0.5, -0.25}}));
    EXPECT_EQ(place(1), core::Point(3.5, 3.75));
    EXPECT_EQ(message().substr(0, message().find(';')), "Nudged fit point 1 by (0.5, -0.25)");
    expect_made_of_points();
    // Nudges that follow each other are one step.
    EXPECT_TRUE(run(NudgeRight{.distance = 0.25, .continues = false}));
    EXPECT_TRUE(run(NudgeRight{.distance = 0.25, .continues = true}));
    EXPECT_EQ(place(1), core::Point(4, 3.75));
    EXPECT_EQ(state().history.undo_label(), "Nudge fit point 1");
    run(Undo{});
    EXPECT_EQ(place(1), core::Point(3.5, 3.75));
    EXPECT_EQ(state().selection.fit_point, 1U);
}

}  // namespace
}  // namespace batten::editor
