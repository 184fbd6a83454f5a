#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/cards/basis_derivatives_card.h"
#include "app/editor/cards/basis_pieces_card.h"
#include "app/editor/cards/basis_values_card.h"
#include "app/editor/cards/recurrence_card.h"
#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/derived/shown_function.h"
#include "app/editor/state/point_hues.h"
#include "tests/editor/card_words.h"
#include "tests/editor/sample_editor.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

constexpr glm::dvec2 card_size{330.0, 200.0};

/// The cubic over 0, 1, ..., 7, whose domain is [3, 4].
EditorState uniform_state(double u) {
    core::CurveDefinition definition;
    definition.degree = 3;
    definition.knots = {0, 1, 2, 3, 4, 5, 6, 7};
    definition.points = {{0, 0}, {1, 2}, {3, 2}, {4, 0}};
    EditorState state = test::scene_state(definition);
    state.view.parameter = u;
    return state;
}

EditorState state_of(int degree, std::vector<double> knots, double u, bool periodic = false) {
    core::CurveDefinition definition;
    definition.degree = degree;
    const std::size_t count = periodic ? knots.size() - 1 : knots.size() - static_cast<std::size_t>(degree) - 1;
    definition.knots = std::move(knots);
    definition.periodic = periodic;
    for (std::size_t i = 0; i < count; ++i)
        definition.points.push_back({static_cast<double>(i), i % 2 == 0 ? 1.0 : 2.0});
    EditorState state = test::scene_state(definition);
    state.view.parameter = u;
    return state;
}

using test::says;

CardDrawing picture_of(const Card& card) {
    for (const CardBlock& block : card.blocks)
        if (const auto* picture = std::get_if<CardPicture>(&block))
            return picture->draw({std::max(card_size.x, picture->least_width), picture->height}, 1.0);
    return {};
}

using MakeCard = Card (*)(const EditorState&);
constexpr MakeCard all_cards[] = {recurrence_card, basis_pieces_card, basis_values_card, rational_basis_card,
                                  basis_derivatives_card};

}  // namespace

TEST(ShownFunction, is_that_of_the_selected_point_or_the_largest) {
    EditorState state = uniform_state(3.25);
    EXPECT_EQ(shown_function(state)->index, 1U) << "23/48 at 1/2; a quarter from the start it is still the larger";
    state.selection.points = {3};
    EXPECT_EQ(shown_function(state)->index, 3U);
    state.selection.points = {9};
    EXPECT_EQ(shown_function(state)->index, 1U);
    EXPECT_FALSE(shown_function(EditorState()).has_value());
}

TEST(ShownFunction, of_a_periodic_curve_acts_at_u_where_it_can) {
    // Unrolled: -2 -1 0 1 2 3 4 5 6; N_0 is N_4 over 2, ..., 5.
    EditorState state = state_of(2, {0, 1, 2, 3, 4}, 3.5, true);
    state.selection.points = {0};
    EXPECT_EQ(shown_function(state)->number, 4U);
    state.view.parameter = 0.5;
    EXPECT_EQ(shown_function(state)->number, 0U);
    state.view.parameter = 1.5;
    EXPECT_EQ(shown_function(state)->number, 4U) << "elsewhere the repetition that begins in the domain";
}

TEST(RecurrenceCard, shows_the_triangle_with_its_numbers) {
    EditorState state = uniform_state(3.5);
    state.selection.points = {0};
    const Card card = recurrence_card(state);
    EXPECT_TRUE(says(card, "N₀,₃(u) at u = 7/2")) << card_text(card);
    // (4 - u)^3 / 6 = 1/48.
    EXPECT_TRUE(says(card, "= 7/6 · 0 + 1/6 · 1/8 = 1/48")) << card_text(card);
    const CardDrawing drawing = picture_of(card);
    ASSERT_EQ(drawing.places.size(), 10U);
    EXPECT_EQ(drawing.places[3].value, "N₃,₀ = 1");
    EXPECT_EQ(drawing.places[9].name, "cell 3 0");
    EXPECT_EQ(drawing.places[9].value, "N₀,₃ = 1/48");
    EXPECT_EQ(drawing.places[9].hover, Hover(HoveredBasisCell{0, 3}));
    EXPECT_TRUE(test::faults_of(drawing.list, {330.0, 178.0}, 2.0).empty());
}

TEST(RecurrenceCard, tells_of_the_cell_that_is_pointed_at) {
    EditorState state = uniform_state(3.5);
    state.selection.points = {0};
    state.hover = HoveredBasisCell{1, 2};
    EXPECT_TRUE(says(recurrence_card(state), "N₁,₂ = (u − u₁)/(u₃ − u₁) N₁,₁\n+ (u₄ − u)/(u₄ − u₂) N₂,₁\n"));
    state.hover = HoveredBasisCell{3, 0};
    EXPECT_TRUE(says(recurrence_card(state), "N₃,₀ = 1, because u = 7/2 is in [u₃, u₄) = [3, 4)"));
    state.hover = HoveredBasisCell{3, 2};
    EXPECT_TRUE(says(recurrence_card(state), "N₀,₃ = ")) << "of another triangle";
}

TEST(RecurrenceCard, says_0_over_0_where_knots_coincide) {
    EditorState state = state_of(2, {0, 0, 0, 1, 1, 1}, 0.25);
    state.selection.points = {0};
    EXPECT_TRUE(says(recurrence_card(state), "u₀ = u₁ = u₂: the first ratio is 0/0, which counts as 0"));
    EXPECT_TRUE(test::has_text(picture_of(recurrence_card(state)).list, "0/0"));
}

TEST(RecurrenceCard, tells_that_of_bernstein_polynomials) {
    EditorState state = state_of(3, {0, 0, 0, 0, 1, 1, 1, 1}, 0.25);
    constexpr std::array formulas{"B₀,₃ = (1 − u) B₀,₂", "B₁,₃ = u B₀,₂ + (1 − u) B₁,₂", "B₂,₃ = u B₁,₂ + (1 − u) B₂,₂",
                                  "B₃,₃ = u B₂,₂"};
    for (std::size_t i = 0; i < formulas.size(); ++i) {
        state.selection.points = {i};
        EXPECT_TRUE(says(recurrence_card(state), formulas[i])) << card_text(recurrence_card(state));
    }
    EXPECT_TRUE(says(recurrence_card(state), "B₃,₃(u) = N₃,₃(u) at u = 1/4"));
    EXPECT_FALSE(says(recurrence_card(uniform_state(3.5)), "B"));
    EXPECT_FALSE(says(recurrence_card(state_of(1, {0, 0, 2, 2}, 1.0)), "u B")) << "the domain is not [0, 1]";
}

TEST(RecurrenceCard, has_as_many_blocks_whatever_is_pointed_at) {
    EditorState state = state_of(2, {0, 0, 0, 1, 1, 1}, 0.25);
    const std::size_t count = recurrence_card(state).blocks.size();
    for (const HoveredBasisCell cell : {HoveredBasisCell{0, 0}, HoveredBasisCell{1, 1}, HoveredBasisCell{0, 2}}) {
        state.hover = cell;
        EXPECT_EQ(recurrence_card(state).blocks.size(), count);
    }
}

TEST(BasisPiecesCard, writes_the_polynomials_in_u_and_in_t) {
    EditorState state = uniform_state(3.5);
    state.selection.points = {1};
    const Card card = basis_pieces_card(state);
    EXPECT_TRUE(says(card, "N₁,₃ on [u₂, u₃) = [2, 3)")) << card_text(card);
    EXPECT_TRUE(says(card, "= (−3u³ + 21u² − 45u + 31)/6")) << card_text(card);
    EXPECT_TRUE(says(card, "= (−3t³ + 3t² + 3t + 1)/6"));
    EXPECT_TRUE(says(card, "with t = u − 2"));
    EXPECT_TRUE(says(card, "each Nᵢ,₃(u) is N₀,₃(u − i), the first one shifted") ||
                says(card, "each N(i,3)(u) is N₀,₃(u − i), the first one shifted"))
        << card_text(card);
    state.view.notation.parameter = ParameterLetter::t;
    EXPECT_TRUE(says(basis_pieces_card(state), "= (−3s³ + 3s² + 3s + 1)/6"));
    state.hover = HoveredBasisCell{1, 1};
    EXPECT_TRUE(says(basis_pieces_card(state), "N₁,₁ on [u₁, u₂) = [1, 2)"));
    EXPECT_FALSE(says(basis_pieces_card(state), "³"));
}

TEST(BasisPiecesCard, names_all_six_functions_of_a_clamped_cubic) {
    EditorState state = state_of(3, {0, 0, 0, 0, 1, 2, 3, 3, 3, 3}, 1.5);
    state.selection.points = {5};
    const Card card = basis_pieces_card(state);
    const auto* names = std::get_if<CardButtons>(&card.blocks.front());
    ASSERT_NE(names, nullptr);
    ASSERT_EQ(names->buttons.size(), 6U);
    EXPECT_EQ(names->buttons[0].text, "N_{0,3}");
    EXPECT_FALSE(names->buttons[0].is_active);
    EXPECT_EQ(names->buttons[5].text, "N_{5,3}");
    EXPECT_TRUE(names->buttons[5].is_active);
    ASSERT_NE(names->buttons[4].command.as<SelectPoints>(), nullptr);
    EXPECT_EQ(names->buttons[4].command.as<SelectPoints>()->points, std::vector<std::size_t>{4});
    EXPECT_TRUE(says(card, "N₅,₃ on [u₅, u₆) = [2, 3)\n= u³ − 6u² + 12u − 8")) << card_text(card);
}

TEST(BasisPiecesCard, takes_knots_of_any_sort) {
    EditorState state = state_of(2, {-1, -1, -1, 1, 3, 3, 3}, 0.0);
    state.selection.points = {1};
    EXPECT_TRUE(says(basis_pieces_card(state), "with t = (u + 1)/2")) << card_text(basis_pieces_card(state));
    EXPECT_TRUE(says(basis_pieces_card(state), "with t = (u − 1)/2"));
    EXPECT_FALSE(says(basis_pieces_card(state), "equally spaced"));
    state.hover = HoveredBasisCell{0, 1};
    EXPECT_TRUE(says(basis_pieces_card(state), "All its knots are one: it is 0 everywhere."));
}

TEST(BasisPiecesCard, tells_short_spans_and_far_ones_apart) {
    EditorState state = state_of(2, {1e6, 1e6, 1e6, 1e6 + 0.25, 1e6 + 1, 1e6 + 1, 1e6 + 1}, 1e6);
    state.selection.points = {1};
    EXPECT_TRUE(says(basis_pieces_card(state), "N₁,₂ on [u₂, u₃) = [1000000, 1000000.25)"))
        << card_text(basis_pieces_card(state));
    EXPECT_TRUE(says(basis_pieces_card(state), "with t = 4 (u − 1000000)"));
    EXPECT_TRUE(says(basis_pieces_card(state), "with t = 4/3 (u − 1000000.25)"));
}

TEST(BasisValuesCard, has_decimals_once) {
    EditorState state = uniform_state(3.5);
    EXPECT_NE(card_text(basis_values_card(state)).find("| 1/48 | 0.0208"), std::string::npos);
    state.view.notation.numbers = NumberStyle::decimals;
    const std::string text = card_text(basis_values_card(state));
    EXPECT_NE(text.find("| 0.02083\n"), std::string::npos) << text;
    EXPECT_EQ(text.find("decimal"), std::string::npos) << text;
}

TEST(BasisValuesCard, has_the_values_and_their_sum) {
    const Card card = basis_values_card(uniform_state(3.5));
    for (const char* row : {"N₀,₃ | 1/48 | 0.0208", "N₁,₃ | 23/48 | 0.4792", "N₂,₃ | 23/48 | 0.4792",
                            "N₃,₃ | 1/48 | 0.0208", "sum | 1 | 1.0000"})
        EXPECT_TRUE(says(card, row)) << row << "\n" << card_text(card);
}

TEST(BasisValuesCard, has_one_form_for_all_of_a_sum) {
    // (3/5)^3, 3 (3/5)^2 2/5, ...
    const Card card = basis_values_card(state_of(3, {0, 0, 0, 0, 1, 1, 1, 1}, 0.4));
    for (const char* row : {"B₀,₃ | 0.216", "B₁,₃ | 0.432", "B₂,₃ | 0.288", "B₃,₃ | 0.064"})
        EXPECT_TRUE(says(card, row)) << row << "\n" << card_text(card);
    const Card lecture = basis_values_card(state_of(3, {0, 0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1}, 0.4));
    for (const char* row : {"N₁,₃ | 2/125", "N₂,₃ | 307/750", "N₃,₃ | 202/375", "N₄,₃ | 9/250"})
        EXPECT_TRUE(says(lecture, row)) << row << "\n" << card_text(lecture);
    EXPECT_FALSE(says(rational_basis_card(state_of(2, {0, 0, 0, 1, 1, 1}, 0.5)), "N"));
}

TEST(BasisValuesCard, shows_how_rational_ones_come_about) {
    EditorState state = state_of(2, {0, 0, 0, 1, 1, 1}, 0.5);
    EXPECT_TRUE(says(rational_basis_card(state), "All weights are equal"));
    core::CurveDefinition definition;
    definition.degree = 2;
    definition.knots = {0, 0, 0, 1, 1, 1};
    definition.points = {{0, 0}, {1, 2}, {3, 2}};
    definition.weights = {1, 3, 1};
    state = test::scene_state(definition);
    state.view.parameter = 0.5;
    const Card card = rational_basis_card(state);
    EXPECT_TRUE(says(card, "At u = 1/2, w(u) = 2")) << card_text(card);
    for (const char* row :
         {"0 | 1/4 | 1 | 1/4 | 1/8", "1 | 1/2 | 3 | 3/2 | 3/4", "2 | 1/4 | 1 | 1/4 | 1/8", "sum | 1 |  | 2 | 1"})
        EXPECT_TRUE(says(card, row)) << row << "\n" << card_text(card);
}

TEST(BasisValuesCard, writes_weights_of_circles_as_roots) {
    core::CurveDefinition definition;
    definition.degree = 2;
    definition.knots = {0, 0, 0, 1, 1, 1};
    definition.points = {{1, 0}, {1, 1}, {0, 1}};
    definition.weights = {1, std::sqrt(0.5), 1};
    EditorState state = test::scene_state(definition);
    state.view.parameter = 0.5;
    EXPECT_TRUE(says(rational_basis_card(state), "1 | 1/2 | √2/2 | 0.3536")) << card_text(rational_basis_card(state));
    EXPECT_TRUE(says(rational_basis_card(state), "i | B | w | B w | R = B w / w(u)"));
}

TEST(BasisDerivativesCard, has_values_and_the_formula) {
    EditorState state = uniform_state(3.5);
    state.selection.points = {1};
    const Card card = basis_derivatives_card(state);
    EXPECT_TRUE(says(card, "N′₁,₃ = 3/(u₄ − u₁) N₁,₂ − 3/(u₅ − u₂) N₂,₂")) << card_text(card);
    EXPECT_TRUE(says(card, "= 1 N₁,₂ − 1 N₂,₂"));
    for (const char* row :
         {"0 | 1/48 | −1/8 | 1/2", "1 | 23/48 | −5/8 | −1/2", "2 | 23/48 | 5/8 | −1/2", "3 | 1/48 | 1/8 | 1/2"})
        EXPECT_TRUE(says(card, row)) << row << "\n" << card_text(card);
}

TEST(BasisDerivativesCard, has_no_rounding_for_zero) {
    const Card card = basis_derivatives_card(state_of(3, {0, 0, 0, 0, 0.1, 0.4, 0.7, 1, 1, 1, 1}, 0.4));
    EXPECT_FALSE(says(card, "e−")) << card_text(card);
}

TEST(BasisDerivativesCard, writes_those_of_bernstein_polynomials_by_lower_ones) {
    EditorState state = state_of(3, {0, 0, 0, 0, 1, 1, 1, 1}, 0.5);
    state.selection.points = {1};
    EXPECT_TRUE(says(basis_derivatives_card(state), "B′₁,₃ = 3/(u₄ − u₁) B₀,₂ − 3/(u₅ − u₂) B₁,₂\n= 3 B₀,₂ − 3 B₁,₂"))
        << card_text(basis_derivatives_card(state));
    state.selection.points = {0};
    EXPECT_TRUE(says(basis_derivatives_card(state), "B′₀,₃ = −3/(u₄ − u₁) B₀,₂\n= −3 B₀,₂"));
    state.selection.points = {3};
    EXPECT_TRUE(says(basis_derivatives_card(state), "B′₃,₃ = 3/(u₆ − u₃) B₂,₂\n= 3 B₂,₂"));
    EXPECT_TRUE(says(basis_derivatives_card(state), "i | B | B′ | B″"));
}

TEST(BasisDerivativesCard, draws_the_derivatives_over_whole_supports) {
    const EditorState state = uniform_state(3.5);
    const render::DrawList list = picture_of(basis_derivatives_card(state)).list;
    const Theme theme = theme_of(ThemeName::dark);
    // From 44 to 322 for 0 to 7; the scale is 1, since N' is at most 2/3; a run for each of the four spans.
    const auto x = [](double u) { return 44.0 + u / 7.0 * 278.0; };
    const auto y = [](double value) { return 75.0 - value * 67.0; };
    const auto lines = test::lines_of(list, theme.point(1), 2.0F);
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_LT(test::distance_to(lines, {x(1.5), y(0.125)}), 0.3);
    EXPECT_LT(test::distance_to(lines, {x(2.0), y(0.5)}), 0.3);
    EXPECT_LT(test::distance_to(lines, {x(3.0), y(0.0)}), 0.3);
    EXPECT_LT(test::distance_to(lines, {x(4.0), y(-0.5)}), 0.3);
    for (const char* text : {"1", "0", "−1"}) EXPECT_TRUE(test::has_text(list, text)) << text;
}

TEST(BasisCards, have_the_colors_of_points_that_others_came_between) {
    Editor editor;
    open_text(editor, sample_text);
    ASSERT_TRUE(editor.run(InsertKnot{.u = 0.3}));
    ASSERT_TRUE(editor.run(SetParameter{.u = 0.6}));
    const EditorState& state = editor.state();
    const Theme theme = theme_of(state.view.theme);
    std::size_t moved = 0;
    for (const MakeCard make : {basis_values_card, rational_basis_card, basis_derivatives_card}) {
        const Card card = make(state);
        for (const CardBlock& block : card.blocks) {
            const auto* table = std::get_if<CardTable>(&block);
            if (table == nullptr) continue;
            for (const std::vector<CardText>& row : table->rows) {
                const auto* basis = std::get_if<HoveredBasis>(&row.front().hover);
                if (basis == nullptr) continue;
                const std::size_t hue = point_hue(*state.shown().active_curve(), basis->index);
                EXPECT_EQ(row.front().color, theme.point_text(hue));
                moved += hue != basis->index % hue_count ? 1 : 0;
            }
        }
    }
    EXPECT_GT(moved, 0U);
}

TEST(BasisCards, take_every_sort_of_curve) {
    std::vector<double> long_knots;
    for (int k = 0; k < 60; ++k) long_knots.push_back(k);
    std::vector<double> many{0, 0, 0};
    for (int k = 0; k <= 10000; ++k) many.push_back(k);
    many.insert(many.end(), {10000, 10000, 10000});
    for (const EditorState& state :
         {EditorState(), uniform_state(3.5), state_of(25, long_knots, 30.5), state_of(1, {0, 0, 1, 2, 2}, 1.0),
          state_of(2, {0, 1, 2}, 0.5, true), state_of(3, many, 5000.5),
          state_of(2, {1e6, 1e6, 1e6, 1e6 + 1, 1e6 + 1, 1e6 + 1}, 1e6 + 0.3),
          state_of(2, {0, 0, 0, 1e-300, 1, 1, 1}, 0.3), state_of(3, {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2}, 1.0)})
        for (const MakeCard make : all_cards) {
            const Card card = make(state);
            EXPECT_FALSE(says(card, "nan")) << card_text(card);
            for (const CardBlock& block : card.blocks) {
                const auto* picture = std::get_if<CardPicture>(&block);
                if (picture == nullptr) continue;
                const glm::dvec2 size{std::max(card_size.x, picture->least_width), picture->height};
                const auto faults = test::faults_of(picture->draw(size, 1.0).list, size, 70.0);
                EXPECT_TRUE(faults.empty()) << faults.front();
            }
        }
}

}  // namespace batten::editor
