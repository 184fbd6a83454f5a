#include "app/editor/words/uniform_cubic_formula.h"

#include <gtest/gtest.h>

#include "app/editor/words/formula.h"

namespace batten::editor {
namespace {

TEST(UniformCubicFormula, pieces_are_written_as_in_lectures) {
    EXPECT_EQ(piece_formula({}, 0), "b_{0}(t) = (1 − 3 t + 3 t^{2} − t^{3})/6");
    EXPECT_EQ(piece_formula({}, 1), "b_{1}(t) = (4 − 6 t^{2} + 3 t^{3})/6");
    EXPECT_EQ(piece_formula({}, 2), "b_{2}(t) = (1 + 3 t + 3 t^{2} − 3 t^{3})/6");
    EXPECT_EQ(piece_formula({}, 3), "b_{3}(t) = t^{3}/6");
}

TEST(UniformCubicFormula, conditions_have_symbols_and_numbers) {
    const auto conditions = core::uniform_cubic_conditions();
    EXPECT_EQ(condition_formula({}, conditions[0]).symbols, "0 = b_{3}(0)");
    EXPECT_EQ(condition_formula({}, conditions[0]).numbers, "0 = 0");
    EXPECT_EQ(condition_formula({}, conditions[4]).symbols, "b_{3}′(1) = b_{2}′(0)");
    EXPECT_EQ(condition_formula({}, conditions[4]).numbers, "1/2 = 1/2");
    EXPECT_EQ(condition_formula({}, conditions[10]).symbols, "b_{1}′(1) = b_{0}′(0)");
    EXPECT_EQ(condition_formula({}, conditions[10]).numbers, "−1/2 = −1/2");
    EXPECT_EQ(condition_formula({}, conditions[14]).symbols, "b_{0}″(1) = 0");
    EXPECT_EQ(plain_text(condition_formula({}, conditions[8]).symbols), "b₂″(1) = b₁″(0)");
    EXPECT_EQ(condition_formula({}, conditions[8]).numbers, "−2 = −2");
}

TEST(UniformCubicFormula, follow_the_notation) {
    Notation notation{.parameter = ParameterLetter::t, .numbers = NumberStyle::decimals};
    EXPECT_EQ(piece_formula(notation, 3), "b_{3}(s) = s^{3}/6") << "t is taken";
    EXPECT_EQ(sum_formula(notation).numbers, "0.1667 + 0.6667 + 0.1667 + 0 = 1");
    EXPECT_EQ(exact_place({}, core::Point(1.0 / 6.0, -2.5)), "(1/6, −5/2)");
    EXPECT_EQ(exact_place({}, core::Point(3000011.0 / 3.0, -999997.0)), "(1000003.667, −999997)");
    EXPECT_EQ(exact_coordinate({}, 1.5e12), "1.5e12");
    EXPECT_EQ(exact_place(notation, core::Vector(1.0 / 6.0, -2.5)), "(0.1667, −2.5)");
}

TEST(UniformCubicFormula, the_sum_is_one) {
    EXPECT_EQ(sum_formula({}).symbols, "b_{0}(0) + b_{1}(0) + b_{2}(0) + b_{3}(0) = 1");
    EXPECT_EQ(sum_formula({}).numbers, "1/6 + 2/3 + 1/6 + 0 = 1");
}

}  // namespace
}  // namespace batten::editor
