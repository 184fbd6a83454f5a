#include "app/editor/words/cell_names.h"

#include <gtest/gtest.h>

#include "app/editor/words/formula.h"
#include "tests/editor/pointer_driver.h"

namespace batten::editor {
namespace {

AlphaFormula formula_of(const core::CurveDefinition& definition, double u, core::CellPlace place,
                        const Notation& notation = {}) {
    const core::Curve curve = core::Curve::make(definition).value();
    return alpha_formula({curve, core::de_boor_triangle(curve, u), notation}, place);
}

std::string name_of(const core::CurveDefinition& definition, double u, core::CellPlace place,
                    const Notation& notation = {}) {
    const core::Curve curve = core::Curve::make(definition).value();
    return NamedTriangle{curve, core::de_boor_triangle(curve, u), notation}.point(place);
}

constexpr Notation in_decimals{.numbers = NumberStyle::decimals};
constexpr Notation by_first_parent{.triangles = CellNumbering::first};

TEST(AlphaFormula, reads_as_in_the_lecture_notes) {
    const AlphaFormula formula = formula_of(test::cubic(), 0.4, {1, 1});
    EXPECT_EQ(formula.symbols, "α_{3}^{1} = (u − u_{3})/(u_{6} − u_{3})");
    EXPECT_EQ(formula.numbers, "= (2/5 − 0)/(3/4 − 0) = 8/15");
    EXPECT_EQ(plain_text(formula.symbols), "α₃¹ = (u − u₃)/(u₆ − u₃)");
    EXPECT_EQ(formula_of(test::cubic(), 0.4, {3, 0}).symbols, "α_{4}^{3} = (u − u_{4})/(u_{5} − u_{4})");
    EXPECT_EQ(formula_of(test::cubic(), 0.4, {1, 1}, in_decimals).numbers, "= (0.4 − 0)/(0.75 − 0) = 0.533");
    EXPECT_EQ(formula_of(test::cubic(), 0.4, {3, 0}, in_decimals).numbers, "= (0.4 − 0.25)/(0.5 − 0.25) = 0.600");
}

TEST(AlphaFormula, has_decimals_throughout_where_u_is_no_fraction) {
    EXPECT_EQ(formula_of(test::cubic(), 0.4123, {1, 1}).numbers, "= (0.4123 − 0)/(0.75 − 0) = 0.550");
}

TEST(AlphaFormula, puts_subtracted_negative_knots_in_parentheses) {
    const core::CurveDefinition definition{.degree = 1, .knots = {-1, -1, 1, 1}, .points = {{0, 0}, {1, 0}}};
    EXPECT_EQ(formula_of(definition, 0.4, {1, 0}).numbers, "= (2/5 − (−1))/(1 − (−1)) = 7/10");
}

TEST(AlphaFormula, tells_close_knots_apart) {
    const core::CurveDefinition definition{
        .degree = 1, .knots = {1, 1, 1.000004, 1.000004}, .points = {{0, 0}, {1, 0}}};
    EXPECT_EQ(formula_of(definition, 1.000001, {1, 0}).numbers, "= (1.000001 − 1)/(1.000004 − 1) = 0.250");
}

TEST(NamedTriangle, names_points_by_their_last_or_first_parent) {
    EXPECT_EQ(name_of(test::cubic(), 0.4, {0, 0}), "P_{1}");
    EXPECT_EQ(name_of(test::cubic(), 0.4, {1, 1}), "P_{3}^{1}");
    EXPECT_EQ(name_of(test::cubic(), 0.4, {2, 1}), "P_{4}^{2}");
    EXPECT_EQ(name_of(test::cubic(), 0.4, {3, 0}), "C(u)");
    EXPECT_EQ(name_of(test::cubic(), 0.4, {0, 0}, by_first_parent), "P_{1}");
    EXPECT_EQ(name_of(test::cubic(), 0.4, {1, 1}, by_first_parent), "P_{2}^{1}");
    EXPECT_EQ(name_of(test::cubic(), 0.4, {2, 1}, by_first_parent), "P_{2}^{2}");
    EXPECT_EQ(formula_of(test::cubic(), 0.4, {1, 1}, by_first_parent).symbols,
              "α_{2}^{1} = (u − u_{3})/(u_{6} − u_{3})");
}

TEST(NamedTriangle, of_a_bezier_curve_begins_with_p01_or_p11) {
    const core::CurveDefinition bezier{.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {1, 2}, {2, 0}}};
    EXPECT_EQ(name_of(bezier, 0.5, {1, 0}), "P_{1}^{1}");
    EXPECT_EQ(name_of(bezier, 0.5, {1, 0}, by_first_parent), "P_{0}^{1}");
}

TEST(NamedTriangle, names_the_points_of_a_periodic_curve_as_the_canvas_does) {
    EXPECT_EQ(name_of(test::closed_cubic(), 5.5, {0, 0}), "P_{5}");
    EXPECT_EQ(name_of(test::closed_cubic(), 5.5, {0, 1}), "P_{0}");
    EXPECT_EQ(name_of(test::closed_cubic(), 5.5, {1, 0}), "P_{6}^{1}");
}

}  // namespace
}  // namespace batten::editor
