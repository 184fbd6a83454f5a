#include "app/editor/words/basis_formula.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/words/uniform_cubic_formula.h"
#include "core/curve/knot_kinds.h"

namespace batten::editor {
namespace {

constexpr Notation fractions{};
constexpr Notation decimals{PointLetter::P, ParameterLetter::t, DegreeOrOrder::degree, CellNumbering::last,
                            NumberStyle::decimals};

const core::KnotVector& lecture() {
    static const auto knots = core::KnotVector::make(3, {0, 1, 2, 3, 4, 5, 6, 7}).value();
    return knots;
}

TEST(BasisFormula, writes_a_cell_with_its_two_functions_and_ramps) {
    const core::BasisTriangle triangle = core::basis_triangle(lecture(), 0, 1.5);
    const RecurrenceFormula formula = recurrence_formula(lecture(), triangle, 2, 1, fractions);
    EXPECT_EQ(formula.symbols[0], "N_{1,2} = (u − u_{1})/(u_{3} − u_{1}) N_{1,1}");
    EXPECT_EQ(formula.symbols[1], "+ (u_{4} − u)/(u_{4} − u_{2}) N_{2,1}");
    EXPECT_EQ(formula.knots[0], "= (3/2 − 1)/(3 − 1) · 1/2");
    EXPECT_EQ(formula.knots[1], "+ (4 − 3/2)/(4 − 2) · 0");
    EXPECT_EQ(formula.numbers, "= 1/4 · 1/2 + 5/4 · 0 = 1/8");
    EXPECT_EQ(formula.note, "");
    EXPECT_EQ(recurrence_formula(lecture(), triangle, 3, 0, fractions).numbers, "= 1/2 · 3/4 + 5/6 · 1/8 = 23/48");
    EXPECT_EQ(recurrence_formula(lecture(), triangle, 3, 0, decimals).numbers,
              "= 0.5 · 0.75 + 0.8333 · 0.125 = 0.4792");
}

TEST(BasisFormula, says_where_0_over_0_counts_as_0) {
    const auto knots = core::KnotVector::make(2, {0, 0, 0, 1, 1, 1}).value();
    const core::BasisTriangle first = core::basis_triangle(knots, 0, 0.25);
    const RecurrenceFormula both = recurrence_formula(knots, first, 1, 0, fractions);
    EXPECT_EQ(both.knots[0], "= 0/0 · 0");
    EXPECT_EQ(both.knots[1], "+ 0/0 · 0");
    EXPECT_EQ(both.numbers, "= 0 · 0 + 0 · 0 = 0");
    EXPECT_EQ(both.note, "u_{0} = u_{1} = u_{2}: both ratios are 0/0, which counts as 0");
    const RecurrenceFormula one = recurrence_formula(knots, first, 2, 0, fractions);
    EXPECT_EQ(one.knots[0], "= 0/0 · 0");
    EXPECT_EQ(one.knots[1], "+ (1 − 1/4)/(1 − 0) · 3/4");
    EXPECT_EQ(one.note, "u_{0} = u_{1} = u_{2}: the first ratio is 0/0, which counts as 0");
    const core::BasisTriangle last = core::basis_triangle(knots, 2, 0.25);
    EXPECT_EQ(recurrence_formula(knots, last, 2, 0, fractions).note,
              "u_{3} = u_{4} = u_{5}: the second ratio is 0/0, which counts as 0");
}

TEST(BasisFormula, puts_negative_numbers_in_parentheses) {
    const auto knots = core::KnotVector::make(1, {-3, -2, -1, 0}).value();
    const core::BasisTriangle triangle = core::basis_triangle(knots, 0, -1.5);
    const RecurrenceFormula formula = recurrence_formula(knots, triangle, 1, 0, fractions);
    EXPECT_EQ(formula.knots[0], "= ((−3/2) − (−3))/((−2) − (−3)) · 0");
    EXPECT_EQ(formula.knots[1], "+ ((−1) − (−3/2))/((−1) − (−2)) · 1");
}

TEST(BasisFormula, says_why_a_step_is_1_or_0) {
    const core::BasisTriangle triangle = core::basis_triangle(lecture(), 0, 1.5);
    EXPECT_EQ(step_formula(lecture(), triangle, 0, fractions),
              "N_{0,0} = 0, because u = 3/2 is not in [u_{0}, u_{1}) = [0, 1)");
    EXPECT_EQ(step_formula(lecture(), triangle, 1, fractions),
              "N_{1,0} = 1, because u = 3/2 is in [u_{1}, u_{2}) = [1, 2)");
    const auto knots = core::KnotVector::make(2, {0, 0, 0, 1, 1, 1}).value();
    const core::BasisTriangle end = core::basis_triangle(knots, 1, 1.0);
    EXPECT_EQ(step_formula(knots, end, 0, fractions), "N_{1,0} = 0, because u_{1} = u_{2}");
    EXPECT_EQ(step_formula(knots, end, 1, fractions), "N_{2,0} = 1, because u = 1 is in [u_{2}, u_{3}] = [0, 1]");
}

TEST(BasisFormula, writes_knots_so_that_they_can_be_told_apart) {
    EXPECT_EQ(knot_value_text(lecture(), 3.5, fractions), "7/2");
    EXPECT_EQ(knot_value_text(lecture(), 3.5, decimals), "3.5");
    EXPECT_EQ(knot_value_text(lecture(), 3.14159, fractions), "3.142");
    const auto far = core::KnotVector::make(1, {1e6, 1e6, 1e6 + 0.5, 1e6 + 1, 1e6 + 1}).value();
    EXPECT_EQ(knot_value_text(far, 1e6, fractions), "1000000");
    EXPECT_EQ(knot_value_text(far, 1e6 + 0.25, fractions), "1000000.25");
    EXPECT_EQ(knot_value_text(far, 999.5, fractions), "999.5") << "1999/2 cannot be read at a glance";
    EXPECT_EQ(knot_value_text(far, 1e300, fractions), "1e300");
}

TEST(BasisFormula, writes_derivatives_by_the_functions_one_degree_lower) {
    const auto knots = core::KnotVector::make(3, {0, 0, 0, 0, 0.25, 0.5, 1, 1, 1, 1}).value();
    const BasisDerivativeFormula formula = basis_derivative_formula(knots, 1, fractions);
    EXPECT_EQ(formula.symbols, "N′_{1,3} = 3/(u_{4} − u_{1}) N_{1,2} − 3/(u_{5} − u_{2}) N_{2,2}");
    EXPECT_EQ(formula.numbers, "= 12 N_{1,2} − 6 N_{2,2}");
    EXPECT_EQ(basis_derivative_formula(knots, 0, fractions).numbers, "= 0 N_{0,2} − 12 N_{1,2}");
}

TEST(BasisFormula, writes_polynomials_as_lecture_notes_do) {
    const auto pieces = core::basis_pieces(lecture(), 0, 3);
    EXPECT_EQ(polynomial_text(pieces[0].in_t, "t", fractions), "t^{3}/6");
    EXPECT_EQ(polynomial_text(pieces[1].in_t, "t", fractions), "(−3t^{3} + 3t^{2} + 3t + 1)/6");
    EXPECT_EQ(polynomial_text(pieces[2].in_t, "t", fractions), "(3t^{3} − 6t^{2} + 4)/6");
    EXPECT_EQ(polynomial_text(pieces[3].in_t, "t", fractions), "(−t^{3} + 3t^{2} − 3t + 1)/6");
    EXPECT_EQ(polynomial_text(pieces[1].in_u, "u", fractions), "(−3u^{3} + 12u^{2} − 12u + 4)/6");
    EXPECT_EQ(polynomial_text(pieces[0].in_t, "t", decimals), "0.1667t^{3}");
    EXPECT_EQ(polynomial_text(pieces[1].in_t, "t", decimals), "−0.5t^{3} + 0.5t^{2} + 0.5t + 0.1667");
    EXPECT_EQ(polynomial_text(core::basis_pieces(lecture(), 2, 1)[0].in_u, "u", fractions), "u − 2");
    EXPECT_EQ(polynomial_text(core::basis_pieces(lecture(), 2, 0)[0].in_u, "u", fractions), "1");
}

TEST(BasisFormula, writes_decimals_where_fractions_cannot_be_read) {
    const auto irrational = core::KnotVector::make(1, {0, 0, std::sqrt(0.5), 1, 1}).value();
    EXPECT_EQ(polynomial_text(core::basis_pieces(irrational, 1, 1)[0].in_u, "u", fractions), "1.414u");
    EXPECT_EQ(polynomial_text({{0.0, 0.0}, {}}, "u", fractions), "0");
    EXPECT_EQ(polynomial_text({{0.5, 1.0}, {{1, 2}, {1, 1000003}}}, "u", fractions), "u + 0.5");
}

TEST(BasisFormula, names_the_parameter_of_a_span_unlike_that_of_the_curve) {
    EXPECT_STREQ(local_parameter(fractions), "t");
    EXPECT_STREQ(local_parameter(decimals), "s");
}

}  // namespace
}  // namespace batten::editor
