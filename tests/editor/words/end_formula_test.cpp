#include "app/editor/words/end_formula.h"

#include <gtest/gtest.h>

#include "app/editor/cards/end_derivatives_card.h"
#include "app/editor/editor.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

using Lines = std::vector<std::string>;

core::CurveDefinition clamped_cubic() {
    core::CurveDefinition definition;
    definition.knots = {0, 0, 0, 0, 1, 3, 4, 4, 4, 4};
    definition.points = {{0, 0}, {1, 2}, {4, 5}, {7, 2}, {9, 1}, {9, 0}};
    return definition;
}

core::EndDerivatives at(const core::CurveDefinition& definition, core::CurveEnd end) {
    return core::end_derivatives(core::Curve::make(definition).value(), end).value();
}

TEST(EndFormula, has_the_numbers_put_in) {
    const auto start = at(clamped_cubic(), core::CurveEnd::start);
    const EndFormula first = first_end_formula(start, {});
    EXPECT_EQ(first.symbols, "C′(0) = p (P_{1} − P_{0})/(u_{4} − u_{3})");
    EXPECT_EQ(first.numbers, (Lines{"= 3 · ((1, 2) − (0, 0))/(1 − 0)", "= (3, 6)"}));
    const EndFormula second = second_end_formula(start, {});
    EXPECT_EQ(second.symbols, "C″(0) = p (p − 1)/h ((P_{2} − P_{1})/k − (P_{1} − P_{0})/h)");
    EXPECT_EQ(second.numbers, (Lines{"h = u_{4} − u_{3} = 1, k = u_{5} − u_{3} = 3",
                                     "= 3 · 2/1 · ((3, 3)/3 − (1, 2)/1)", "= (0, −6)"}));
}

TEST(EndFormula, has_fractions_of_fractions_in_parentheses) {
    core::CurveDefinition definition;
    definition.degree = 2;
    definition.knots = {0, 0, 0, 1, 1, 1};
    definition.points = {{0, 0}, {1, 2}, {3, 2}};
    definition.weights = {0.5, 0.75, 1};
    const EndFormula first = first_end_formula(at(definition, core::CurveEnd::start), {});
    EXPECT_EQ(first.numbers, (Lines{"= 2 · (3/4)/(1/2) · ((1, 2) − (0, 0))/(1 − 0)", "= (3, 6)"}));
}

TEST(EndFormula, at_the_end_runs_toward_it) {
    const auto end = at(clamped_cubic(), core::CurveEnd::end);
    EXPECT_EQ(first_end_formula(end, {}).symbols, "C′(4) = p (P_{5} − P_{4})/(u_{6} − u_{5})");
    EXPECT_EQ(first_end_formula(end, {}).numbers, (Lines{"= 3 · ((9, 0) − (9, 1))/(4 − 3)", "= (0, −3)"}));
    const EndFormula second = second_end_formula(end, {});
    EXPECT_EQ(second.symbols, "C″(4) = p (p − 1)/h ((P_{5} − P_{4})/h − (P_{4} − P_{3})/k)");
    EXPECT_EQ(second.numbers, (Lines{"h = u_{6} − u_{5} = 1, k = u_{6} − u_{4} = 3",
                                     "= 3 · 2/1 · ((0, −1)/1 − (2, −1)/3)", "= (−4, −4)"}));
}

TEST(EndFormula, with_weights_has_its_factors) {
    core::CurveDefinition arc;
    arc.degree = 2;
    arc.knots = {0, 0, 0, 1, 1, 1};
    arc.points = {{1, 0}, {1, 1}, {0, 1}};
    arc.weights = {1, 1, 2};
    const auto end = at(arc, core::CurveEnd::end);
    EXPECT_EQ(first_end_formula(end, {}).symbols, "C′(1) = p w_{1}/w_{2} (P_{2} − P_{1})/(u_{3} − u_{2})");
    EXPECT_EQ(first_end_formula(end, {}).numbers, (Lines{"= 2 · 1/2 · ((0, 1) − (1, 1))/(1 − 0)", "= (−1, 0)"}));
    const EndFormula second = second_end_formula(end, {});
    EXPECT_EQ(second.symbols, "C″(1) = a (P_{0} − P_{2}) − b (P_{1} − P_{2})");
    EXPECT_EQ(second.numbers,
              (Lines{"h = u_{3} − u_{2} = 1, k = u_{3} − u_{1} = 1", "a = p (p − 1)/(h k) w_{0}/w_{2}", "= 1",
                     "b = p (p − 1)/h (1/h + 1/k) w_{1}/w_{2} + 2 p^{2}/h^{2} (w_{1} − w_{2}) w_{1}/w_{2}^{2}", "= 0",
                     "= 1 · ((1, 0) − (0, 1)) − 0 · ((1, 1) − (0, 1))", "= (1, −1)"}));
}

TEST(EndFormula, subtracts_negative_knots_in_parentheses_and_tells_near_ones_apart) {
    core::CurveDefinition definition = clamped_cubic();
    for (double& knot : definition.knots) knot = 1e-5 * knot - 0.5;
    EXPECT_EQ(first_end_formula(at(definition, core::CurveEnd::start), {}).numbers.front(),
              "= 3 · ((1, 2) − (0, 0))/((−0.49999) − (−1/2))");
    EXPECT_EQ(second_end_formula(at(definition, core::CurveEnd::start), {}).numbers.front(),
              "h = u_{4} − u_{3} = 1e−5, k = u_{5} − u_{3} = 3e−5");
    const Notation decimals{.numbers = NumberStyle::decimals};
    definition = clamped_cubic();
    for (double& knot : definition.knots) knot /= 3.0;
    EXPECT_EQ(first_end_formula(at(definition, core::CurveEnd::start), {}).numbers.front(),
              "= 3 · ((1, 2) − (0, 0))/(1/3 − 0)");
    EXPECT_EQ(second_end_formula(at(definition, core::CurveEnd::start), {}).numbers[1],
              "= 3 · 2/(1/3) · ((3, 3)/1 − (1, 2)/(1/3))");
    EXPECT_EQ(first_end_formula(at(definition, core::CurveEnd::start), decimals).numbers.front(),
              "= 3 · ((1, 2) − (0, 0))/(0.3333 − 0)");
}

TEST(EndFormula, tells_points_apart_that_are_far_from_the_origin) {
    core::CurveDefinition definition = clamped_cubic();
    for (core::Point& point : definition.points) point += core::Vector{1e6, -1e6};
    EXPECT_EQ(first_end_formula(at(definition, core::CurveEnd::start), {}).numbers,
              (Lines{"= 3 · ((1000001, −999998) − (1000000, −1000000))/(1 − 0)", "= (3, 6)"}));
}

TEST(EndDerivativesCard, has_both_ends) {
    const std::string text = card_text(end_derivatives_card(test::scene_state(clamped_cubic())));
    EXPECT_NE(text.find("At the start\nC′(0) = p (P₁ − P₀)/(u₄ − u₃)\n"), std::string::npos) << text;
    const Card card = end_derivatives_card(test::scene_state(clamped_cubic()));
    EXPECT_EQ(std::get<CardLine>(card.blocks[1]).text.hover, Hover(HoveredLeg{0}));
    EXPECT_NE(text.find("At the end\nC′(4) = p (P₅ − P₄)/(u₆ − u₅)\n"), std::string::npos) << text;
}

TEST(EndDerivativesCard, says_where_the_formulas_do_not_hold) {
    core::CurveDefinition uniform;
    uniform.degree = 2;
    uniform.knots = {0, 1, 2, 3, 4, 5, 6};
    uniform.points = {{0, 0}, {1, 2}, {4, 5}, {7, 2}};
    EXPECT_NE(card_text(end_derivatives_card(test::scene_state(uniform))).find("The start is not clamped"),
              std::string::npos);
    EXPECT_NE(card_text(end_derivatives_card(test::scene_state(uniform))).find("Clamp both ends"), std::string::npos);
    uniform.knots = {0, 1, 2, 3, 4};
    uniform.periodic = true;
    EXPECT_NE(card_text(end_derivatives_card(test::scene_state(uniform))).find("it has no ends"), std::string::npos);
    EXPECT_NE(card_text(end_derivatives_card(Editor().state())).find("There is no curve"), std::string::npos);
}

}  // namespace
}  // namespace batten::editor
