#include "app/editor/commands/shape_commands.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/area.h"
#include "core/measure/geometric_distance.h"
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
    EXPECT_EQ(state().ghost->deviation, core::geometric_distance(before, curve(editor_)));
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

TEST_F(ShapeCommands, offset_to_a_side_has_few_points) {
    const core::Curve before = curve(editor_);
    EXPECT_TRUE(run(Offset{.distance = -0.2, .tolerance = 1e-5, .side = core::OffsetSide::left}));
    EXPECT_EQ(document(editor_).curves.size(), 4U);
    EXPECT_EQ(document(editor_).active_curve()->name, "offset of wave");
    EXPECT_EQ(*document(editor_).curves[0].curve, before);
    EXPECT_EQ(message().rfind("Added offset by -0.2; error at most ", 0), 0U) << message();
    const core::Curve& offset = curve(editor_);
    for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0}) {
        const core::Point place = core::point_at(offset, offset.domain().lower + share * offset.domain().length());
        const core::CurveSample near = core::nearest_point(before, place);
        EXPECT_NEAR(core::distance(near.point, place), 0.2, 1e-5);
        EXPECT_LT(core::cross(core::derivatives_at(before, near.u, 1)[1], place - near.point), 0.0);
    }
}

// A rectangle of 4 x 2: the inner offset, both of them, and an arc around each corner outside.
TEST_F(ShapeCommands, offset_has_sides_and_corners) {
    open_text(editor_, R"({ "format": "batten", "version": 1, "curves": [ { "name": "r", "degree": 1,
      "knots": [0,0,1,2,3,4,4], "points": [[0,0],[4,0],[4,2],[0,2],[0,0]] } ] })");
    EXPECT_TRUE(type("offset 0.5 1e-6 left"));
    EXPECT_NEAR(core::enclosed_area(curve(editor_))->signed_area, 3.0, 1e-14);
    EXPECT_TRUE(run(Undo{}));
    EXPECT_TRUE(type("offset 0.5 1e-6 both round"));
    ASSERT_EQ(document(editor_).curves.size(), 3U);
    EXPECT_EQ(document(editor_).active, 1U);
    EXPECT_EQ(document(editor_).curves[2].name, "offset of r 2");
    EXPECT_NEAR(core::enclosed_area(*document(editor_).curves[2].curve)->signed_area, 14.0 + 0.25 * std::acos(-1.0),
                1e-12);
    EXPECT_EQ(message().rfind("Added offset by 0.5; it consists of 2 curves", 0), 0U) << message();
}

TEST_F(ShapeCommands, offset_of_an_open_curve_has_caps) {
    run(ActivateCurve{.index = 2});
    EXPECT_TRUE(run(
        Offset{.distance = 0.5, .tolerance = 1e-6, .side = core::OffsetSide::both, .caps = core::OffsetCaps::flat}));
    EXPECT_EQ(document(editor_).curves.size(), 4U);
    EXPECT_TRUE(core::enclosed_area(curve(editor_)).has_value());
}

TEST_F(ShapeCommands, offset_says_why_nothing_is_left) {
    EXPECT_FALSE(run(Offset{.distance = 0.1, .tolerance = 0.0, .side = core::OffsetSide::both}));
    EXPECT_EQ(message(), "the tolerance is 0; it must be above 0 and finite");
    open_text(editor_, R"({ "format": "batten", "version": 1, "curves": [ { "name": "r", "degree": 1,
      "knots": [0,0,1,2,3,4,4], "points": [[0,0],[4,0],[4,2],[0,2],[0,0]] } ] })");
    EXPECT_FALSE(run(Offset{.distance = 1.25, .tolerance = 1e-5, .side = core::OffsetSide::left}));
    EXPECT_EQ(message(), "nothing is left at the distance 1.25; it must be less than half of the width of the shape");
    EXPECT_EQ(document(editor_).curves.size(), 1U);
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
