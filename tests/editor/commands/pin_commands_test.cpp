#include "app/editor/commands/pin_commands.h"

#include <gtest/gtest.h>

#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/shape_commands.h"
#include "core/evaluate/evaluate.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

using Indices = std::vector<std::size_t>;

class PinCommands : public ::testing::Test {
  protected:
    PinCommands() { open_text(editor_, sample_text); }
    const std::string& message() const { return editor_.state().message.text; }
    const Indices& pinned() const { return document(editor_).active_curve()->pinned; }
    bool run(const Command& command) { return editor_.run(command); }
    bool type(const std::string& text) { return run_typed(editor_, text); }

    Editor editor_;
};

TEST_F(PinCommands, pin_what_is_selected_and_let_it_go_again) {
    run(SelectPoints{.points = {4, 1}});
    EXPECT_TRUE(type("pin-points"));
    EXPECT_EQ(pinned(), (Indices{1, 4}));
    EXPECT_EQ(message(), "Pinned 2 points");
    EXPECT_TRUE(run(PinPoints{.points = {3, 4}}));
    EXPECT_EQ(pinned(), (Indices{1, 3, 4}));
    EXPECT_EQ(message(), "Pinned 2 points");
    EXPECT_TRUE(run(UnpinPoints{.points = {4, 0}}));
    EXPECT_EQ(pinned(), (Indices{1, 3}));
    EXPECT_TRUE(run(Undo{}));
    EXPECT_EQ(pinned(), (Indices{1, 3, 4}));
    EXPECT_FALSE(run(PinPoints{.points = {7}}));
    EXPECT_EQ(message(), "there is no control point 7; the last one is 6");
}

TEST_F(PinCommands, a_pinned_point_is_not_moved_by_itself_and_stays_when_others_go) {
    run(PinPoints{.points = {1}});
    const core::Curve before = curve(editor_);
    EXPECT_FALSE(run(SetPoint{.index = 1, .position = {0.0, 0.0}}));
    EXPECT_EQ(message(), "P₁ is pinned; unpin it first");
    EXPECT_FALSE(run(MovePoints{.points = {1}, .offset = {1.0, 0.0}}));
    EXPECT_EQ(curve(editor_), before);
    EXPECT_TRUE(run(MovePoints{.points = {1, 2}, .offset = {1.0, 0.0}}));
    EXPECT_EQ(points(editor_)[1], before.control_points()[1]);
    EXPECT_EQ(points(editor_)[2], before.control_points()[2] + core::Vector(1, 0));
    run(SelectPoints{.points = {1}});
    EXPECT_FALSE(run(Nudge{.offset = {0.5, 0.0}}));
    run(PinPoints{.points = {2}});
    EXPECT_FALSE(run(MovePoints{.points = {1, 2}, .offset = {1.0, 0.0}}));
    EXPECT_EQ(message(), "2 points are pinned; unpin them first");
}

TEST_F(PinCommands, drags_of_the_curve_and_fairing_go_around_pinned_points) {
    run(PinPoints{.points = {2, 3}});
    const core::Curve before = curve(editor_);
    EXPECT_TRUE(run(MoveCurvePoint{.u = 0.4, .position = {0.0, 2.0}}));
    EXPECT_LT(core::distance(core::point_at(curve(editor_), 0.4), core::Point(0, 2)), 1e-13);
    EXPECT_TRUE(run(SetTangent{.u = 0.4, .derivative = {3.0, -8.0}}));
    EXPECT_TRUE(run(Fair{.distance = 0.25}));
    EXPECT_TRUE(run(SoftMove{.center = {-1.0, 0.0}, .offset = {1.0, 1.0}, .radius = 30.0}));
    for (const std::size_t i : {2U, 3U}) EXPECT_EQ(points(editor_)[i], before.control_points()[i]);
    EXPECT_NE(points(editor_)[0], before.control_points()[0]);
    run(PinPoints{.points = {0, 1}});
    EXPECT_FALSE(run(MoveCurvePoint{.u = 0.1, .position = {0.0, 2.0}}));
    EXPECT_EQ(message(), "all control points that act at 0.1 are pinned; unpin one of them first");
}

TEST_F(PinCommands, pins_stay_with_their_points_while_knots_come_and_points_go) {
    run(PinPoints{.points = {0, 5, 6}});
    EXPECT_TRUE(run(InsertKnot{.u = 0.1}));
    EXPECT_EQ(pinned(), (Indices{0, 6, 7}));
    EXPECT_TRUE(run(DeletePoints{.points = {1}}));
    EXPECT_EQ(pinned(), (Indices{0, 5, 6}));
    EXPECT_TRUE(run(DeletePoints{.points = {6}}));
    EXPECT_EQ(pinned().front(), 0U);
    EXPECT_EQ(pinned().back(), 5U);
}

TEST_F(PinCommands, soft_moves_fall_off) {
    const core::Curve before = curve(editor_);
    EXPECT_TRUE(run(SoftMove{.center = before.control_points()[3], .offset = {0.0, 1.0}, .radius = 1.0}));
    EXPECT_EQ(points(editor_)[3], before.control_points()[3] + core::Vector(0, 1));
    EXPECT_EQ(points(editor_)[2], before.control_points()[2]);
    EXPECT_EQ(message().rfind("Moved points around (-0.4, -2.6) by up to (0, 1); the curve moved by at most ", 0), 0U)
        << message();
    EXPECT_FALSE(run(SoftMove{.center = {0.0, 0.0}, .offset = {0.0, 1.0}, .radius = 0.0}));
}

}  // namespace
}  // namespace batten::editor
