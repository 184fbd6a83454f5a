#include <gtest/gtest.h>

#include <algorithm>

#include "app/editor/cards/blossoms_card.h"
#include "app/editor/cards/by_insertion_card.h"
#include "app/editor/cards/cards.h"
#include "app/editor/cards/halves_card.h"
#include "app/editor/cards/triangle_card.h"
#include "app/editor/commands/overlay_commands.h"
#include "app/editor/commands/view_commands.h"
#include "tests/editor/card_words.h"
#include "tests/editor/pointer_driver.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

EditorState state_at(const core::CurveDefinition& definition, double u) {
    EditorState state = test::scene_state(definition);
    state.view.parameter = u;
    return state;
}

core::CurveDefinition bezier() {
    return {.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{0, 0}, {1, 2}, {3, 2}, {4, 0}}};
}

core::CurveDefinition of_degree_25() {
    core::CurveDefinition definition{.degree = 25, .knots = std::vector<double>(52, 0.0), .points = {}};
    std::fill(definition.knots.begin() + 26, definition.knots.end(), 1.0);
    for (int i = 0; i < 26; ++i) definition.points.push_back({0.1 * i, i % 2 == 0 ? 0.0 : 1.0});
    return definition;
}

core::CurveDefinition rational_cubic() {
    core::CurveDefinition definition = test::cubic();
    definition.weights = {1, 1, 1, 2, 1, 1, 1};
    return definition;
}

using test::says;

/// All pictures of a card at the usual width.
std::vector<CardDrawing> drawings_of(const Card& card) {
    std::vector<CardDrawing> drawings;
    for (const CardBlock& block : card.blocks)
        if (const auto* picture = std::get_if<CardPicture>(&block))
            drawings.push_back(picture->draw({std::max(320.0, picture->least_width), picture->height}, 1.0));
    return drawings;
}

const CardPlace* place_named(const CardDrawing& drawing, const std::string& name) {
    const auto found = std::find_if(drawing.places.begin(), drawing.places.end(),
                                    [&](const CardPlace& place) { return place.name == name; });
    return found == drawing.places.end() ? nullptr : &*found;
}

TEST(TriangleCard, prints_the_lines_of_the_lecture) {
    const EditorState state = state_at(test::cubic(), 0.4);
    const Card card = triangle_card(state);
    for (const char* line :
         {"De Boor at u = 2/5 in the span [1/4, 1/2)", "P₂¹ = 1/5 P₁ + 4/5 P₂", "P₃¹ = 7/15 P₂ + 8/15 P₃",
          "P₄¹ = 4/5 P₃ + 1/5 P₄", "P₃² = 1/5 P₂¹ + 4/5 P₃¹", "P₄² = 7/10 P₃¹ + 3/10 P₄¹", "C(u) = 2/5 P₃² + 3/5 P₄²",
          "α₄³ = (u − u₄)/(u₅ − u₄)", "= (2/5 − 1/4)/(1/2 − 1/4) = 3/5"})
        EXPECT_TRUE(says(card, line)) << line << " not in\n" << card_text(card);
}

TEST(TriangleCard, lights_points_from_its_lines_and_tells_of_the_hovered_one) {
    EditorState state = state_at(test::cubic(), 0.4);
    bool has_hover = false;
    for (const CardBlock& block : triangle_card(state).blocks)
        if (const auto* line = std::get_if<CardLine>(&block))
            has_hover = has_hover ||
                        (line->text.text.starts_with("P_{3}^{1} =") && line->text.hover == Hover(HoveredCell{1, 1}));
    EXPECT_TRUE(has_hover);
    state.hover = HoveredCell{1, 1};
    EXPECT_TRUE(says(triangle_card(state), "How P₃¹ is made"));
    EXPECT_TRUE(says(triangle_card(state), "= (2/5 − 0)/(3/4 − 0) = 8/15"));
    const std::size_t lines = triangle_card(state).blocks.size();
    for (const Hover& hover : {Hover(HoveredCell{0, 1}), Hover(HoveredNothing{}), Hover(HoveredCell{3, 0})}) {
        state.hover = hover;
        EXPECT_EQ(triangle_card(state).blocks.size(), lines) << "nothing jumps";
    }
}

TEST(TriangleCard, tells_no_more_than_the_levels_that_are_shown) {
    EditorState state = state_at(test::cubic(), 0.4);
    state.view.level = 1;
    EXPECT_TRUE(says(triangle_card(state), "How P₄¹ is made"));
    EXPECT_TRUE(says(triangle_card(state), "= (2/5 − 1/4)/(1 − 1/4) = 1/5"));
    EXPECT_FALSE(says(triangle_card(state), "α₄³"));
    EXPECT_FALSE(says(triangle_card(state), "C(u) ="));
    state.view.level = 2;
    EXPECT_TRUE(says(triangle_card(state), "How P₄² is made"));
    state.view.level = 0;
    EXPECT_FALSE(says(triangle_card(state), "is made")) << "the points of level 0 are given";
    state.hover = HoveredCell{1, 0};
    EXPECT_TRUE(says(triangle_card(state), "How P₂¹ is made"));
    state.hover = HoveredNothing{};
    state.view.level = 3;
    EXPECT_TRUE(says(triangle_card(state), "How C(u) is made"));
    state.view.level.reset();
    EXPECT_TRUE(says(triangle_card(state), "How C(u) is made"));
}

TEST(TriangleCard, of_a_bezier_curve_is_de_casteljau) {
    const EditorState state = state_at(bezier(), 0.25);
    const Card card = triangle_card(state);
    EXPECT_TRUE(says(card, "De Casteljau at u = 1/4"));
    EXPECT_TRUE(says(card, "Every ratio α is u"));
    EXPECT_TRUE(says(card, "P₁¹ = 3/4 P₀ + 1/4 P₁"));
    EditorState first = state;
    first.view.notation.triangles = CellNumbering::first;
    EXPECT_TRUE(says(triangle_card(first), "P₀¹ = 3/4 P₀ + 1/4 P₁"));
}

TEST(TriangleCard, of_a_rational_curve_has_both_forms_with_the_weights_between) {
    EditorState state = state_at(rational_cubic(), 0.4);
    state.hover = HoveredCell{1, 1};
    const Card card = triangle_card(state);
    // w = 7/15 + 16/15 = 23/15, and the shares (7/15)/(23/15) and (16/15)/(23/15).
    for (const char* line :
         {"w₃¹ P₃¹ = 7/15 w₂ P₂ + 8/15 w₃ P₃", "w₃¹ = 7/15 w₂ + 8/15 w₃", "= 7/15 · 1 + 8/15 · 2 = 23/15",
          "P₃¹ = (7/15 w₂ P₂ + 8/15 w₃ P₃) / w₃¹", "P₃¹ = 7/23 P₂ + 16/23 P₃"})
        EXPECT_TRUE(says(card, line)) << line << " not in\n" << card_text(card);
}

TEST(TriangleCard, picture_has_a_place_for_each_cell_in_the_picture) {
    const EditorState state = state_at(test::cubic(), 0.4);
    const auto drawings = drawings_of(triangle_card(state));
    ASSERT_EQ(drawings.size(), 1U);
    EXPECT_EQ(drawings[0].places.size(), 10U);
    const CardPlace* cell = place_named(drawings[0], "cell 1 1");
    ASSERT_NE(cell, nullptr);
    EXPECT_EQ(cell->hover, Hover(HoveredCell{1, 1}));
    EXPECT_EQ(cell->value, "P₃¹");
    for (const CardPlace& place : drawings[0].places) {
        EXPECT_GE(place.box.lower_px.x, 0.0);
        EXPECT_LE(place.box.upper_px.x, 320.0);
    }
    EXPECT_TRUE(test::has_text(drawings[0].list, "α 8/15"));
    EXPECT_EQ(test::overlapping_labels(drawings[0].list), std::vector<std::string>{});
}

TEST(TriangleCard, of_a_high_degree_has_the_lines_of_one_level) {
    EditorState state = state_at(of_degree_25(), 0.5);
    state.view.level = 24;
    const Card card = triangle_card(state);
    EXPECT_TRUE(says(card, "The lines of level 24;"));
    EXPECT_TRUE(says(card, "P₂₅²⁴ = 1/2 P₂₄²³ + 1/2 P₂₅²³"));
    EXPECT_FALSE(says(card, "P₁¹ ="));
    EXPECT_TRUE(says(card, "A triangle of 351 points is too large here"));
    EXPECT_TRUE(drawings_of(card).empty());
}

TEST(TriangleCard, without_a_curve_offers_an_example) {
    const EditorState empty;
    EXPECT_TRUE(says(triangle_card(empty), "Open an example"));
    EXPECT_TRUE(says(halves_card(empty), "Open an example"));
    EXPECT_TRUE(says(by_insertion_card(empty), "Open an example"));
    EXPECT_TRUE(says(blossoms_card(empty), "Open an example"));
}

TEST(HalvesCard, names_the_sides_of_the_triangle) {
    const Card card = halves_card(state_at(test::cubic(), 0.4));
    for (const char* line : {"Before u, over [0, 2/5]: 5 control points", "P₀, P₁, P₂¹, P₃², C(u)",
                             "After u, over [2/5, 1]: 6 control points", "C(u), P₄², P₄¹, P₄, P₅, P₆", "Split here"})
        EXPECT_TRUE(says(card, line)) << line << " not in\n" << card_text(card);
}

TEST(HalvesCard, gives_each_part_its_own_points_at_a_tear) {
    const Card card = halves_card(state_at({.degree = 2,
                                            .knots = {0, 0, 0, 1, 1, 1, 2, 2, 2},
                                            .points = {{0, 0}, {1, 2}, {2, 0}, {3, 0}, {4, 2}, {5, 0}},
                                            .tears = core::Tears::allow},
                                           1.0));
    for (const char* line : {"Before u, over [0, 1]: 3 control points", "P₀, P₁, P₂",
                             "After u, over [1, 2]: 3 control points", "P₃, P₄, P₅", "The curve is torn at u"})
        EXPECT_TRUE(says(card, line)) << line << " not in\n" << card_text(card);
    EXPECT_FALSE(says(card, "meet in C(u)"));
}

TEST(HalvesCard, shortens_long_lists_and_says_where_nothing_is_split) {
    core::CurveDefinition long_one{.degree = 2, .knots = {0, 0}, .points = {}};
    for (int i = 0; i <= 1000; ++i) long_one.points.push_back({0.01 * i, i % 2 == 0 ? 0.0 : 1.0});
    for (int i = 0; i <= 999; ++i) long_one.knots.push_back(i);
    long_one.knots.insert(long_one.knots.end(), {999, 999});
    const Card card = halves_card(state_at(long_one, 500.5));
    EXPECT_TRUE(says(card, "P₀, P₁, P₂, P₃, …, P₄₉₉, P₅₀₀, P₅₀₁¹, C(u)")) << card_text(card);
    EXPECT_TRUE(says(card, "C(u), P₅₀₂¹, P₅₀₂, P₅₀₃, …, P₉₉₇, P₉₉₈, P₉₉₉, P₁₀₀₀")) << card_text(card);
    EXPECT_TRUE(says(halves_card(state_at(test::cubic(), 0.0)), "nothing to split"));
    EXPECT_TRUE(says(halves_card(state_at(test::closed_cubic(), 0.5)), "opened at u into one curve"));
}

TEST(ByInsertionCard, shows_the_polygons_side_by_side_and_says_what_the_last_point_is) {
    const EditorState state = state_at(test::cubic(), 0.4);
    const Card card = by_insertion_card(state);
    EXPECT_TRUE(says(card, "u inserted once: P₂¹, P₃¹, P₄¹ take the place of P₂, P₃"));
    EXPECT_TRUE(says(card, "u inserted 3 times: the new point is C(u)"));
    const auto drawings = drawings_of(card);
    ASSERT_EQ(drawings.size(), 1U);
    ASSERT_EQ(drawings[0].places.size(), 3U);
    EXPECT_EQ(drawings[0].places[0].box.lower_px.y, drawings[0].places[2].box.lower_px.y);
    EXPECT_LT(drawings[0].places[0].box.upper_px.x, drawings[0].places[1].box.lower_px.x);
    EXPECT_EQ(test::faults_of(drawings[0].list, {320.0, 118.0}, 1.0), std::vector<std::string>{});
    EXPECT_TRUE(test::has_text(drawings[0].list, "3× u: C(u)"));
    EXPECT_TRUE(drawings_of(by_insertion_card(state_at(test::cubic(), 0.0))).empty());
    EXPECT_EQ(drawings_of(by_insertion_card(state_at(of_degree_25(), 0.5)))[0].places.back().name, "inserted 25");
}

TEST(BlossomsCard, names_points_by_index_or_by_value) {
    EditorState state = state_at(test::cubic(), 0.4);
    const auto by_index = drawings_of(blossoms_card(state));
    for (const CardPlace& place : by_index[0].places) EXPECT_LE(place.box.upper_px.x, 320.0) << place.name;
    EXPECT_EQ(place_named(by_index[0], "cell 0 1")->value, "f(u₃, u₄, u₅)");
    EXPECT_EQ(place_named(by_index[0], "cell 1 1")->value, "f(u₄, u₅, u)");
    EXPECT_TRUE(says(blossoms_card(state), "f(u, u, u)\n= 2/5 f(u₄, u, u)\n+ 3/5 f(u₅, u, u)"));
    state.view.blossom_values = true;
    state.view.notation.parameter = ParameterLetter::t;
    const auto by_value = drawings_of(blossoms_card(state));
    EXPECT_EQ(place_named(by_value[0], "cell 0 0")->value, "f(0, 0, 1/4)");
    EXPECT_EQ(place_named(by_value[0], "cell 1 1")->value, "f(1/4, 1/2, t)");
    EXPECT_TRUE(says(blossoms_card(state_at(of_degree_25(), 0.5)), "f(u, …, u)"));
}

TEST(ShownCards, a_triangle_that_stands_in_comes_last) {
    Editor editor = test::zigzag_editor();
    editor.run(ToggleOverlay<Overlay::halves>{});
    editor.run(TogglePresenting{});
    const std::vector<CardSource> stood_in = shown_cards(editor.state());
    ASSERT_EQ(stood_in.size(), 2U);
    EXPECT_EQ(stood_in[0].overlay, Overlay::halves);
    EXPECT_EQ(stood_in[1].overlay, Overlay::triangle);
    editor.run(ToggleOverlay<Overlay::triangle>{});
    EXPECT_EQ(shown_cards(editor.state())[0].overlay, Overlay::triangle) << "asked for";
}

}  // namespace
}  // namespace batten::editor
