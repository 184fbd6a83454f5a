#include "app/editor/commands/shape_commands.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/nearest.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

class ShapeCommands : public ::testing::Test {
  protected:
    ShapeCommands() { open_text(editor_, sample_text); }
    const EditorState& state() const { return editor_.state(); }
    const std::string& message() const { return state().message.text; }
    bool run(const Command& command) { return editor_.run(command); }
    bool type(const std::string& text) { return run_typed(editor_, text); }

    Editor editor_;
};

TEST_F(ShapeCommands, move_curve_point_reaches_its_target) {
    const core::Curve before = curve(editor_);
    EXPECT_TRUE(run(MoveCurvePoint{.u = 0.6, .position = {1.0, 2.0}}));
    EXPECT_LT(core::distance(core::point_at(curve(editor_), 0.6), core::Point(1, 2)), 1e-14);
    EXPECT_EQ(curve(editor_).knots(), before.knots());
    EXPECT_EQ(points(editor_)[0], before.control_points()[0]);
    EXPECT_EQ(message().rfind("Moved C(0.6) to (1, 2); the curve moved by at most 4.54", 0), 0U) << message();
    EXPECT_TRUE(state().ghost.has_value());
    EXPECT_EQ(state().history.undo_label(), "Move curve point");
    EXPECT_TRUE(run(Undo{}));
    EXPECT_EQ(curve(editor_), before);
}

TEST_F(ShapeCommands, move_curve_point_takes_the_current_parameter) {
    run(SetParameter{.u = 0.3});
    EXPECT_TRUE(type("move-curve-point -2 2"));
    EXPECT_LT(core::distance(core::point_at(curve(editor_), 0.3), core::Point(-2, 2)), 1e-14);
    EXPECT_FALSE(run(MoveCurvePoint{.u = 3.0, .position = {-2.0, 2.0}}));
    EXPECT_EQ(message(), "the parameter 3 is outside the domain; it must be from 0 to 1");
}

TEST_F(ShapeCommands, say_what_smoothness_was_lost_and_where) {
    open_text(editor_, R"({ "format": "batten", "version": 1, "curves": [
      { "name": "straight", "degree": 1, "knots": [0,0,1,2,2], "points": [[0,0],[1,0],[2,0]] } ] })");
    EXPECT_TRUE(run(MoveCurvePoint{.u = 1.0, .position = {1.0, 1.0}}));
    EXPECT_NE(message().find("; the curve now has a corner of 90° at u = 1"), std::string::npos) << message();
}

// In the middle of a parabola the derivative is the vector from its first point to its last.
TEST_F(ShapeCommands, say_that_ends_no_longer_meet) {
    open_text(editor_, R"({ "format": "batten", "version": 1, "curves": [
      { "name": "flat", "degree": 2, "knots": [0,0,0,1,1,1], "points": [[0,0],[1,2],[0,0]] } ] })");
    EXPECT_TRUE(run(SetTangent{.u = 0.5, .derivative = {0.5, 0.0}}));
    EXPECT_NE(message().find("; its ends, which met, are now 0.5 apart"), std::string::npos) << message();
}

TEST_F(ShapeCommands, set_tangent_keeps_the_point) {
    const core::Point before = core::point_at(curve(editor_), 0.4);
    EXPECT_TRUE(run(SetTangent{.u = 0.4, .derivative = {3.0, -8.0}}));
    const auto found = core::derivatives_at(curve(editor_), 0.4, 1);
    EXPECT_LT(core::distance(found.point, before), 1e-13);
    EXPECT_LT(core::length(found[1] - core::Vector(3, -8)), 1e-12);
    EXPECT_TRUE(run(MovePointAndTangent{.u = 0.4, .position = {1.0, 1.0}, .derivative = {5.0, 0.0}}));
    const auto moved = core::derivatives_at(curve(editor_), 0.4, 1);
    EXPECT_LT(core::distance(moved.point, core::Point(1, 1)), 1e-13);
    EXPECT_LT(core::length(moved[1] - core::Vector(5, 0)), 1e-12);
}

TEST_F(ShapeCommands, fair_stays_within_the_distance) {
    const core::Curve before = curve(editor_);
    EXPECT_TRUE(run(Fair{.distance = 0.25}));
    ASSERT_TRUE(state().ghost.has_value());
    EXPECT_LE(state().ghost->deviation, 0.25);
    EXPECT_GT(state().ghost->deviation, 0.2);
    EXPECT_EQ(points(editor_).front(), before.control_points().front());
    EXPECT_EQ(points(editor_).back(), before.control_points().back());
    EXPECT_FALSE(run(Fair{.distance = -1.0}));
    EXPECT_EQ(message(), "the tolerance is -1; it must be above 0 and finite");
    EXPECT_TRUE(type("fair"));
}

TEST_F(ShapeCommands, offset_adds_a_curve_beside) {
    const core::Curve before = curve(editor_);
    EXPECT_TRUE(run(Offset{.distance = -0.2, .tolerance = 1e-5}));
    EXPECT_EQ(document(editor_).curves.size(), 4U);
    EXPECT_EQ(document(editor_).active_curve()->name, "offset of wave");
    EXPECT_EQ(*document(editor_).curves[0].curve, before);
    EXPECT_EQ(message().rfind("Added offset by -0.2; error at most ", 0), 0U) << message();
    for (const double u : {0.1, 0.5, 0.9}) {
        const auto at = core::derivatives_at(before, u, 1);
        const core::Vector right = core::Vector(at[1].y, -at[1].x) / core::length(at[1]);
        EXPECT_LT(core::distance(core::point_at(curve(editor_), u), at.point + 0.2 * right), 1e-5);
    }
}

TEST_F(ShapeCommands, offset_says_why_there_is_none) {
    EXPECT_FALSE(run(Offset{.distance = 5.0, .tolerance = 1e-5}));
    EXPECT_EQ(message().substr(0, 49), "the distance is 5, but the radius of curvature at") << message();
    EXPECT_EQ(document(editor_).curves.size(), 3U);
}

TEST_F(ShapeCommands, locked_curves_are_not_moved) {
    run(ActivateCurve{.index = 2});
    for (const Command& command : std::vector<Command>{MoveCurvePoint{.u = 0.5, .position = {1.0, 1.0}},
                                                       SetTangent{.u = 0.5, .derivative = {1.0, 1.0}}}) {
        EXPECT_FALSE(run(command));
        EXPECT_EQ(message(), "curve 'line' is locked; unlock it in the inspector");
    }
    EXPECT_FALSE(type("fair"));
    EXPECT_TRUE(type("offset"));
}

}  // namespace
}  // namespace batten::editor
