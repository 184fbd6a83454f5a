#include "app/editor/commands/tear_commands.h"

#include <gtest/gtest.h>

#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/refinement_commands.h"
#include "core/evaluate/evaluate.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

// A parabola of three pieces with a stack of two knots.
const char* parabola_text = R"({ "format": "batten", "version": 1, "curves": [
  { "name": "bow", "degree": 2, "knots": [0,0,0,1,1,2,3,3,3],
    "points": [[0,0],[1,2],[2,0],[3,2],[4,0],[5,2]] } ] })";

class TearCommands : public ::testing::Test {
  protected:
    bool run(const Command& command) { return editor_.run(command); }
    const std::string& message() const { return editor_.state().message.text; }
    bool may_tear() const { return tears_of_active(editor_.state()) == core::Tears::allow; }

    Editor editor_;
};

TEST_F(TearCommands, switch_lets_a_dragged_knot_tear_the_curve_and_undo_mends_it) {
    open_text(editor_, parabola_text);
    const MoveKnot onto_the_stack{.index = 5, .u = 1.0, .mode = core::KnotMove::snap};
    EXPECT_TRUE(run(onto_the_stack));
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 1, 1, 1.015, 3, 3, 3}));
    EXPECT_EQ(
        message().substr(0, 103),
        "Moved knot 2 to 1.015, up to a full stack, which it joins where 'Allow tears' lets the curve come apart");
    run(Undo{});
    EXPECT_TRUE(run(AllowTears{}));
    EXPECT_EQ(message(), "Allowed tears");
    EXPECT_TRUE(run(onto_the_stack));
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 1, 1, 1, 3, 3, 3}));
    EXPECT_EQ(message().substr(0, 12), "Moved knot 2");
    EXPECT_EQ(core::point_at(curve(editor_), 1.0, core::Side::left), core::Point(2, 0));
    EXPECT_EQ(core::point_at(curve(editor_), 1.0, core::Side::right), core::Point(3, 2));
    run(Undo{});
    EXPECT_FALSE(curve(editor_).is_torn());
    EXPECT_TRUE(may_tear());
    run(Undo{});
    EXPECT_FALSE(may_tear());
}

TEST_F(TearCommands, inserted_knots_tear_and_the_parts_come_apart) {
    open_text(editor_, bezier_text);
    ASSERT_TRUE(run(InsertKnots{.knots = {0.5, 0.5, 0.5}}));
    const std::string refusal =
        "knot 0.5 may occur 3 times, or once more where 'Allow tears' lets the curve come apart";
    EXPECT_FALSE(run(InsertKnot{.u = 0.5}));
    EXPECT_EQ(message(), refusal);
    EXPECT_FALSE(run(RaiseKnot{.index = 5}));
    EXPECT_EQ(message(), refusal);
    EXPECT_FALSE(run(InsertKnots{.knots = {0.5}}));
    EXPECT_EQ(message(), refusal);
    run(AllowTears{});
    EXPECT_TRUE(run(RaiseKnot{.index = 5}));
    EXPECT_EQ(points(editor_)[3], core::Point(2, 1.5));
    EXPECT_EQ(points(editor_)[4], core::Point(2, 1.5));
    ASSERT_TRUE(run(SetPoint{.index = 4, .position = {2, 5}}));
    EXPECT_EQ(core::point_at(curve(editor_), 0.5, core::Side::left), core::Point(2, 1.5));
    EXPECT_EQ(core::point_at(curve(editor_), 0.5, core::Side::right), core::Point(2, 5));
    EXPECT_FALSE(run(RaiseKnot{.index = 5}));
    EXPECT_EQ(message(), "knot 0.5 cannot be inserted that many times; at most 4 equal knots are allowed there");
}

TEST_F(TearCommands, typed_knots_tear_where_it_is_allowed) {
    open_text(editor_, parabola_text);
    EXPECT_FALSE(run(SetKnot{.index = 5, .u = 1.0}));
    EXPECT_EQ(
        message(),
        "knot number 3 is the first of 3 equal ones; 2 are allowed, or one more where 'Allow tears' lets the curve "
        "come apart");
    EXPECT_FALSE(run(SetKnots{.knots = {0, 0, 0, 1, 1, 1, 3, 3, 3}}));
    EXPECT_FALSE(run(SetKnots{.knots = {0, 0, 1, 1, 1, 1, 3, 3, 3}}));
    EXPECT_EQ(message(), "knot 2 occurs 4 times; at most 3 equal knots are allowed there");
    run(AllowTears{});
    EXPECT_TRUE(run(SetKnot{.index = 5, .u = 1.0}));
    EXPECT_TRUE(curve(editor_).is_torn());
}

TEST_F(TearCommands, say_why_they_cannot_be_run) {
    open_text(editor_, bezier_text);
    EXPECT_FALSE(run(ForbidTears{}));
    EXPECT_EQ(message(), "tears are not allowed as it is");
    run(AllowTears{});
    EXPECT_FALSE(run(AllowTears{}));
    EXPECT_EQ(message(), "tears are allowed already");
    run(InsertKnots{.knots = {0.5, 0.5, 0.5, 0.5}});
    EXPECT_FALSE(run(ForbidTears{}));
    EXPECT_EQ(message(), "the curve is torn; take a knot away where it is, or undo");
    run(Undo{});
    EXPECT_TRUE(run(ForbidTears{}));
    EXPECT_FALSE(may_tear());
    run(ToggleClosed{});
    EXPECT_FALSE(run(AllowTears{}));
    EXPECT_EQ(message(), "a closed curve cannot tear; open it first");
}

TEST_F(TearCommands, switch_is_kept_in_the_file) {
    open_text(editor_, bezier_text);
    EXPECT_EQ(core::format_document(document(editor_)).find("tears"), std::string::npos);
    run(AllowTears{});
    const std::string text = core::format_document(document(editor_));
    EXPECT_NE(text.find("\"tears\": true"), std::string::npos);
    open_text(editor_, text);
    EXPECT_TRUE(may_tear());
}

}  // namespace
}  // namespace batten::editor
