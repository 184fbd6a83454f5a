#include <gtest/gtest.h>

#include "app/editor/cards/bezier_points_card.h"
#include "app/editor/cards/corner_cutting_card.h"
#include "app/editor/cards/polygon_distance_card.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/refinement_commands.h"
#include "tests/editor/lecture_insertion.h"

namespace batten::editor {
namespace {

class InsertionCards : public ::testing::Test {
  protected:
    void SetUp() override { test::open_lecture_insertion(editor_); }
    const EditorState& state() const { return editor_.state(); }

    Editor editor_;
};

bool has(const Card& card, const std::string& text) {
    return card_text(card).find(text) != std::string::npos;
}

TEST_F(InsertionCards, corner_cutting_has_the_lines_of_the_lecture) {
    const Card card = corner_cutting_card(state());
    for (const char* text :
         {"Inserting u = 1/2 puts 3 new points in the place of 2.", "Its multiplicity becomes 1: C² there.",
          "Q₃ = 1/6 P₂ + 5/6 P₃", "α₃ = (u − u₃)/(u₆ − u₃)\n= (1/2 − 0)/(3/5 − 0) = 5/6", "Q₄ = 1/2 P₃ + 1/2 P₄",
          "α₄ = (u − u₄)/(u₇ − u₄)\n= (1/2 − 1/5)/(4/5 − 1/5) = 1/2", "Q₅ = 5/6 P₄ + 1/6 P₅",
          "α₅ = (u − u₅)/(u₈ − u₅)\n= (1/2 − 2/5)/(1 − 2/5) = 1/6"})
        EXPECT_TRUE(has(card, text)) << text << " in\n" << card_text(card);
}

TEST_F(InsertionCards, corner_cutting_stays_after_the_insertion) {
    ASSERT_TRUE(editor_.run(InsertKnot{.u = 0.5}));
    const Card card = corner_cutting_card(state());
    EXPECT_TRUE(has(card, "Knot 1/2 came in: 3 new points took the place of 2.")) << card_text(card);
    EXPECT_TRUE(has(card, "Q₃ = 1/6 P₂ + 5/6 P₃"));
    EXPECT_TRUE(has(card, "Take it out again"));
    EXPECT_FALSE(has(card, "Points were moved since"));
    ASSERT_TRUE(editor_.run(SetPoint{.index = 4, .position = {9, 3}}));
    EXPECT_TRUE(has(corner_cutting_card(state()), "Points were moved since"))
        << card_text(corner_cutting_card(state()));
}

TEST_F(InsertionCards, corner_cutting_has_weights_in_its_formulas) {
    ASSERT_TRUE(editor_.run(SetWeight{.index = 3, .weight = 2.0}));
    const Card card = corner_cutting_card(state());
    // w = 1/6 + 5/6 2 = 11/6; on the leg at 5/6 2 / (11/6) = 10/11.
    EXPECT_TRUE(has(card, "= 1/6 w₂ P₂ + 5/6 w₃ P₃")) << card_text(card);
    EXPECT_TRUE(has(card, "1/6 · 1 + 5/6 · 2 = 11/6")) << card_text(card);
    EXPECT_TRUE(has(card, "Q₃ is at 10/11 of its leg")) << card_text(card);
}

TEST_F(InsertionCards, corner_cutting_says_why_there_is_nothing_to_cut) {
    ASSERT_TRUE(editor_.run(SetParameter{.u = 0.0}));
    EXPECT_TRUE(has(corner_cutting_card(state()), "Nothing to cut: 0 has multiplicity 4 already."));
    EXPECT_TRUE(has(corner_cutting_card(Editor().state()), "Nothing to cut: there is no curve."));
}

TEST_F(InsertionCards, polygon_distance_is_quartered) {
    Editor editor;
    open_text(editor, R"({ "format": "batten", "version": 1, "curves": [
        { "name": "arch", "degree": 2, "knots": [0,0,0,1,1,1], "points": [[0,0],[1,2],[2,0]] } ] })");
    const Card card = polygon_distance_card(editor.state());
    EXPECT_TRUE(has(card, "at most 1 from the curve")) << card_text(card);
    EXPECT_TRUE(has(card, "now | 3 | 1 | ")) << card_text(card);
    EXPECT_TRUE(has(card, "1 | 4 | 0.25 | 0.25")) << card_text(card);
    EXPECT_TRUE(has(card, "2 | 6 | 0.0625 | 0.25")) << card_text(card);
    // 1/64 = 0.015625, and a bound is never rounded down.
    EXPECT_TRUE(has(card, "3 | 10 | 0.01563 | 0.25")) << card_text(card);
}

TEST_F(InsertionCards, polygon_distance_says_where_it_does_not_apply) {
    EXPECT_TRUE(has(polygon_distance_card(Editor().state()), "There is no curve."));
    Editor editor;
    open_text(editor, R"({ "format": "batten", "version": 1, "curves": [
        { "name": "line", "degree": 1, "knots": [0,0,1,1], "points": [[0,0],[1,2]] } ] })");
    EXPECT_TRUE(has(polygon_distance_card(editor.state()), "A curve of degree 1 is its control polygon."));
}

TEST_F(InsertionCards, bezier_points_have_numbers_blossoms_and_places) {
    // The middle piece is the third one of five: from b_6 on. Its blossoms over [0.4, 0.6] by hand: f(2/5, 2/5, 3/5) is
    // midway between P_3 = f(1/5, 2/5, 3/5) and P_4 = f(2/5, 3/5, 4/5) by a third: (8, 0).
    const Card card = bezier_points_card(state());
    EXPECT_TRUE(has(card, "The piece over [2/5, 3/5]")) << card_text(card);
    EXPECT_TRUE(has(card, "b₇ | f(2/5, 2/5, 3/5) | (8, 0)")) << card_text(card);
    EXPECT_TRUE(has(card, "b₈ | f(2/5, 3/5, 3/5) | (10, 0)")) << card_text(card);
    EXPECT_TRUE(has(card, "Insert the knots at both ends")) << card_text(card);
    ASSERT_TRUE(editor_.run(ToBezier{}));
    const Card after = bezier_points_card(state());
    EXPECT_TRUE(has(after, "b₇ | f(2/5, 2/5, 3/5) | (8, 0)")) << card_text(after);
    EXPECT_TRUE(has(after, "control points of the curve")) << card_text(after);
    EXPECT_LT(core::distance(points(editor_)[7], {8, 0}), 1e-13);
}

}  // namespace
}  // namespace batten::editor
