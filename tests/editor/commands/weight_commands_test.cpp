#include "app/editor/commands/weight_commands.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/commands/edit_commands.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

constexpr const char* conic_text = R"({ "format": "batten", "version": 1, "curves": [
  { "name": "arc", "degree": 2, "knots": [0,0,0,1,1,1], "points": [[3,0],[3,3],[0,3]], "weights": [1,2,1] } ] })";

class WeightCommands : public ::testing::Test {
  protected:
    WeightCommands() { open_text(editor_, conic_text); }

    const EditorState& state() const { return editor_.state(); }
    std::vector<double> weights() const {
        const auto all = curve(editor_).weights();
        return {all.begin(), all.end()};
    }

    Editor editor_;
};

TEST_F(WeightCommands, move_a_farin_point_by_the_weights_behind_it) {
    EXPECT_TRUE(editor_.run(MoveFarinPoint{.leg = 0, .share = 0.75}));
    EXPECT_EQ(weights(), (std::vector<double>{1, 3, 1.5}));
    EXPECT_EQ(state().history.undo_label(), "Move Farin point between P₀ and P₁");
    EXPECT_EQ(
        state().message.text.find("Moved the Farin point between P₀ and P₁: the weight of P₁ is 3 times that of P₀"),
        0U)
        << state().message.text;
    EXPECT_TRUE(editor_.run(Undo{}));
    EXPECT_EQ(weights(), (std::vector<double>{1, 2, 1}));
}

TEST_F(WeightCommands, refuse_a_farin_point_where_none_can_be) {
    EXPECT_FALSE(editor_.run(MoveFarinPoint{.leg = 0, .share = 1.0}));
    EXPECT_EQ(state().message.text, "the share of the leg is 1; it must be above 0 and below 1");
    EXPECT_FALSE(editor_.run(MoveFarinPoint{.leg = 2, .share = 0.5}));
    EXPECT_EQ(weights(), (std::vector<double>{1, 2, 1}));
    EXPECT_FALSE(run_typed(editor_, "move-farin-point 0 1.5"));
    EXPECT_TRUE(run_typed(editor_, "move-farin-point 1 0.5"));
    EXPECT_EQ(weights(), (std::vector<double>{1, 2, 2}));
}

TEST_F(WeightCommands, make_the_piece_at_the_parameter_circular) {
    EXPECT_TRUE(run_typed(editor_, "make-circular"));
    EXPECT_DOUBLE_EQ(weights()[1], std::sqrt(0.5));
    EXPECT_EQ(state().history.undo_label(), "Make piece circular");
    EXPECT_TRUE(run_typed(editor_, "set-point 0 4 0"));
    EXPECT_FALSE(run_typed(editor_, "make-circular"));
    EXPECT_EQ(state().message.text.find("the legs of the piece are"), 0U) << state().message.text;
}

}  // namespace
}  // namespace batten::editor
