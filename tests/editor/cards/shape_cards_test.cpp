// What the cards about the curve's shape say, and its handles and commands.

#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/cards/card_texts.h"
#include "app/editor/cards/cards.h"
#include "app/editor/cards/curvature_card.h"
#include "app/editor/cards/parts_card.h"
#include "app/editor/cards/support_card.h"
#include "app/editor/cards/variation_card.h"
#include "app/editor/commands/shape_view_commands.h"
#include "app/editor/pointer/comb_tooth.h"
#include "app/editor/pointer/view_handle.h"
#include "tests/editor/canvas_fixture.h"
#include "tests/editor/card_words.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

using test::committed;
using test::px;

using test::says;

class ShapeCards : public test::CanvasFixture {
  protected:
    void show(Overlay overlay) {
        ASSERT_TRUE(run_typed(editor, std::string(overlay_command(overlay))));
        ASSERT_TRUE(state().view.overlays.is_shown(overlay));
    }
    static const char* overlay_command(Overlay overlay) {
        return overlay == Overlay::variation ? "toggle-variation" : "toggle-comb";
    }
};

TEST(PositionText, tells_places_apart_however_far_from_zero) {
    const Notation fractions;
    EXPECT_EQ(position_text(fractions, 4.0, {0.5, 2.0}), "(1/2, 2)");
    EXPECT_EQ(position_text(fractions, 6.0, {1000001.4687, 0.8298123}), "(1000001.469, 0.8298)");
    EXPECT_EQ(position_text(fractions, 6.0, {1000002.0, 2.0}), "(1000002, 2)");
    // The center of a circle of radius 1 is rounding.
    EXPECT_EQ(position_text(fractions, 2.0, {3.3e-16, -1e-15}), "(0, 0)");
    EXPECT_EQ(position_text(fractions, 2e-7, {3.3e-9, 1e-7}), "(3.3e−9, 1e−7)");
}

TEST_F(ShapeCards, variation_counts_polygon_and_curve) {
    show(Overlay::variation);
    const Card level = variation_card(state());
    EXPECT_TRUE(says(level, "crossings with the polygon | 4")) << card_text(level);
    EXPECT_TRUE(says(level, "crossings with the curve | 4"));
    EXPECT_TRUE(says(level, "4 ≤ 4"));
    ASSERT_TRUE(editor.run(PutLine{{0, 1}, {1, 1}}));
    EXPECT_TRUE(says(variation_card(state()), "crossings with the curve | 0"));
    EXPECT_TRUE(says(variation_card(state()), "0 ≤ 4"));
    ASSERT_TRUE(editor.run(LevelLine{}));
    EXPECT_TRUE(says(variation_card(state()), "4 ≤ 4"));
    EXPECT_FALSE(editor.run(PutLine{{1, 1}, {1, 1}}));
    EXPECT_EQ(state().message.text, "a line needs two different points");
}

TEST_F(ShapeCards, line_is_dragged_by_its_ends_and_as_a_whole) {
    show(Overlay::variation);
    const ProbeLine begin = shown_probe_line(state()).value();
    EXPECT_EQ(begin.first, core::Point(-3.2, 0));
    EXPECT_EQ(begin.second, core::Point(3.2, 0));
    pointer.drag(px(3.2, 0), px(3.2, 1));
    EXPECT_EQ(state().view.shape.line->first, begin.first);
    EXPECT_NEAR(state().view.shape.line->second.y, 1.0, 1e-12);
    EXPECT_NEAR(state().view.shape.line->second.x, 3.2, 1e-12);
    // Half of the way it is 1/2 high: there it is taken as a whole.
    pointer.drag(px(0, 0.5), px(0, -0.5));
    EXPECT_NEAR(state().view.shape.line->first.y, -1.0, 1e-12);
    EXPECT_NEAR(state().view.shape.line->second.y, 0.0, 1e-12);
    EXPECT_EQ(steps(), 0U) << "nothing to be undone";
    EXPECT_EQ(committed(editor), *first_curve);
}

TEST_F(ShapeCards, escape_puts_the_line_back) {
    show(Overlay::variation);
    pointer.press(px(-3.2, 0));
    EXPECT_TRUE(is_in<DraggingHandle>());
    pointer.move(px(-3.2, 2));
    EXPECT_NEAR(state().view.shape.line->first.y, 2.0, 1e-12);
    pointer.escape(px(-3.2, 2));
    EXPECT_EQ(state().view.shape.line->first, core::Point(-3.2, 0));
    EXPECT_TRUE(is_in<CanvasIdle>());
}

TEST_F(ShapeCards, line_stays_where_it_is_while_the_curve_changes) {
    show(Overlay::variation);
    pointer.drag(px(-2, 2), px(-2, 3));
    EXPECT_EQ(point(1), core::Point(-2, 3));
    EXPECT_EQ(shown_probe_line(state())->first.y, 0.0) << "the middle of the points is at 1/2 now";
}

TEST_F(ShapeCards, comb_is_dragged_by_its_handle) {
    show(Overlay::curvature_comb);
    // Elsewhere than below C(3/2), where the tip is at a control point, which comes first.
    editor.run(SetParameter{.u = 0.5});
    const auto handle = comb_handle(state(), 1.0).value();
    const glm::dvec2 arm = handle.place_px - handle.foot_px;
    pointer.drag(handle.place_px, handle.foot_px + 2.0 * arm);
    EXPECT_NEAR(state().view.shape.comb_factor, 2.0, 1e-9);
    ASSERT_TRUE(run_typed(editor, "set-comb-scale 0.5"));
    EXPECT_EQ(state().view.shape.comb_factor, 0.5);
    EXPECT_FALSE(run_typed(editor, "set-comb-scale 1000"));
}

TEST_F(ShapeCards, parts_are_counted_and_measured) {
    ASSERT_TRUE(editor.run(SetPartCount{6}));
    EXPECT_TRUE(state().view.overlays.is_shown(Overlay::equal_lengths));
    EXPECT_TRUE(says(equal_steps_card(state()), "6 steps of Δu = 1/2")) << card_text(equal_steps_card(state()));
    EXPECT_TRUE(says(equal_lengths_card(state()), "= 6 × ")) << card_text(equal_lengths_card(state()));
    ASSERT_TRUE(run_typed(editor, "line 0 0 30 0"));
    ASSERT_TRUE(run_typed(editor, "set-units mm 10"));
    EXPECT_TRUE(says(equal_lengths_card(state()), "length 3 mm = 6 × 0.5 mm"))
        << card_text(equal_lengths_card(state()));
    EXPECT_FALSE(run_typed(editor, "set-part-count 0"));
    EXPECT_FALSE(run_typed(editor, "set-part-count 201"));
}

TEST_F(ShapeCards, support_names_knots_and_pieces) {
    EXPECT_TRUE(says(support_card(state()), "Select a control point"));
    ASSERT_TRUE(run_typed(editor, "select-points 1"));
    const Card card = support_card(state());
    EXPECT_TRUE(says(card, "P₁ acts on [u₁, u₄] = [0, 2]")) << card_text(card);
    EXPECT_TRUE(says(card, "It moves 2 of 3 pieces of the curve, the rest stays."));
    EXPECT_TRUE(says(span_hulls_card(state()), "[u₃, u₄]: in the hull of P₁, ..., P₃"))
        << card_text(span_hulls_card(state()));
}

// At u = 3/2 the middle piece of the zigzag, (-1,0) (0,-2) (1,0), is at its lowest: C' = (2, 0), C'' = (0, 8).
TEST_F(ShapeCards, osculating_circle_has_its_numbers_put_in) {
    const Card card = osculating_circle_card(state());
    for (const char* text : {"C′ = (2, 0)", "C″ = (0, 8)", "κ(1.500) = 16 / 2³", "κ(1.500) = 2", "ρ = 1/|κ| = 1/2",
                             "M = (0, −1/2)", "turns left"})
        EXPECT_TRUE(says(card, text)) << text << "\n" << card_text(card);
    const Card frame = tangent_normal_card(state());
    EXPECT_TRUE(says(frame, "T = C′/|C′| = (1, 0)")) << card_text(frame);
    EXPECT_TRUE(says(frame, "N = (0, 1)"));
}

TEST_F(ShapeCards, bends_are_listed) {
    const Card card = curvature_marks_card(state());
    EXPECT_TRUE(says(card, "2 inflections")) << card_text(card);
    EXPECT_TRUE(says(card, "inflection | jumps"));
}

TEST_F(ShapeCards, say_what_is_missing_without_a_curve) {
    const EditorState empty;
    for (const CardSource& source : card_sources()) {
        const Card card = source.make(empty);
        EXPECT_FALSE(card.blocks.empty()) << core::name_of(source.overlay);
    }
    EXPECT_TRUE(says(variation_card(empty), "There is no visible active curve."));
}

}  // namespace
}  // namespace batten::editor
