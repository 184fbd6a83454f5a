#include "render/formula_label.h"

#include <gtest/gtest.h>

#include "render/prose.h"

namespace batten::render {
namespace {

std::string set(std::string_view formula) {
    const FormulaLabel label = formula_label(formula);
    EXPECT_TRUE(label.unknown.empty()) << formula;
    return label.text;
}

TEST(FormulaLabel, sets_letters_and_signs) {
    EXPECT_EQ(set("\\alpha \\le \\int \\sqrt{2} \\frac{1}{6} \\mathbb{R}"), "α ≤ ∫ √2 ⅙ℝ");
    EXPECT_EQ(set("\\Delta u\\neq\\varepsilon"), "Δu ≠ ε");
    EXPECT_EQ(set("P_0,\\ldots,P_n"), "P_{0}, …, P_{n}");
    EXPECT_EQ(set("u\\in[0,1]"), "u ∈ [0, 1]");
    EXPECT_EQ(set("\\{a\\}\\quad\\|b\\|"), "{a}\u2003‖b‖");
}

TEST(FormulaLabel, spaces_as_formulas_are) {
    EXPECT_EQ(set("C(u)=a+b-c"), "C(u) = a + b − c");
    EXPECT_EQ(set("x = -1"), "x = −1") << "a sign";
    EXPECT_EQ(set("(-1)^n"), "(−1)^{n}");
    EXPECT_EQ(set("\\sum_{i=0}^n N_{i,p}(u) P_i"), "∑_{i=0}^{n} N_{i,p}(u)P_{i}");
    EXPECT_EQ(set("2\\cdot 10^{-3}"), "2 · 10^{−3}");
    EXPECT_EQ(set("\\sin t+\\max(a,b)"), "sin t + max(a, b)");
    EXPECT_EQ(set("u=0{,}5"), "u = 0,5");
    EXPECT_EQ(set("12.5"), "12.5");
    EXPECT_EQ(set("f: A\\to B"), "f: A → B");
}

TEST(FormulaLabel, sets_fractions_on_the_line) {
    EXPECT_EQ(set("\\frac13"), "⅓");
    EXPECT_EQ(set("1\\tfrac{1}{2}"), "1½");
    EXPECT_EQ(set("\\frac{7}{15}"), "7/15");
    EXPECT_EQ(set("\\frac{u-u_i}{u_{i+p}-u_i}N"), "(u − u_{i})/(u_{i+p} − u_{i}) N");
    EXPECT_EQ(set("\\frac{a}{2h}"), "a/(2h)") << "not a half of a, times h";
    EXPECT_EQ(set("\\frac{a}{10}"), "a/10");
    EXPECT_EQ(set("\\frac{\\frac{a}{b}}{c}"), "(a/b)/c");
    EXPECT_EQ(set("\\frac{1}{(a+b)}"), "1/(a + b)");
    EXPECT_EQ(set("\\frac{{a+b}}{\\mathbf{c}}"), "(a + b)/c");
}

TEST(FormulaLabel, sets_roots) {
    EXPECT_EQ(set("\\sqrt 2"), "√2");
    EXPECT_EQ(set("\\sqrt{10}"), "√10");
    EXPECT_EQ(set("\\sqrt{x^2+1}"), "√(x^{2} + 1)");
    EXPECT_EQ(set("\\sqrt{\\frac{a}{b}}"), "√(a/b)");
    EXPECT_EQ(set("2\\sqrt[3]{x}"), "2^{3}√x");
}

TEST(FormulaLabel, sets_words_and_fonts) {
    EXPECT_EQ(set("\\mathbf{P}_i\\text{ for all }i"), "P_{i} for all i");
    EXPECT_EQ(set("\\left(\\mathrm{d}u\\right)"), "(du)");
    EXPECT_EQ(set("\\left.a\\right|_{u=0}"), "a|_{u=0}");
}

TEST(FormulaLabel, sets_scripts) {
    EXPECT_EQ(set("P_i^{(1)}"), "P_{i}^{(1)}");
    EXPECT_EQ(set("x_\\alpha"), "x_{α}");
    EXPECT_EQ(set("C''(u)"), "C′′(u)");
    EXPECT_EQ(set("90^\\circ"), "90°");
    EXPECT_EQ(set("e^{x^2}"), "e^{x²}") << "a script within a script has signs of its own";
    EXPECT_EQ(set("P_{i_j}"), "P_{iⱼ}");
}

TEST(FormulaLabel, tells_what_it_does_not_know) {
    const FormulaLabel label = formula_label("\\vec{a} + \\foo b");
    EXPECT_EQ(label.text, "\\vec{a} + \\foo b");
    EXPECT_EQ(label.unknown, (std::vector<std::string>{"\\vec", "\\foo"}));
    EXPECT_EQ(formula_label("P_{i_q}").unknown, std::vector<std::string>{"_q"}) << "there is no such sign";
    EXPECT_EQ(formula_label("P_{i_q}").text, "P_{i_q}");
}

TEST(FormulaLabel, takes_whatever_it_gets) {
    for (const char* formula :
         {"", "_", "^{}", "\\", "\\frac", "\\frac{}{}", "\\sqrt[", "{", "}", "a_", "''", "\\left"})
        formula_label(formula);
    const std::string deep = std::string(100'000, '{') + "a" + std::string(100'000, '}');
    EXPECT_FALSE(formula_label(deep).text.empty());
    const std::string long_formula(100'000, 'a');
    EXPECT_EQ(formula_label(long_formula).text, long_formula);
}

TEST(FormulaLabel, tells_where_something_lacks_what_it_is_of) {
    for (const char* formula :
         {"\\frac{1}", "\\frac", "\\sqrt", "x_", "x^ ", "{\\frac{1}} + 1", "\\mathbb", "x^2^3", "x_1_2", "x_1^2_3"})
        EXPECT_FALSE(formula_label(formula).is_whole) << formula;
    for (const char* formula :
         {"\\frac12", "\\frac{}{}", "x_1^2", "x^2 y^3", "\\sqrt[3]{x}^2", "x^{2^3}", "x'^2", "\\foo"})
        EXPECT_TRUE(formula_label(formula).is_whole) << formula;
}

TEST(ProseLabel, sets_what_stands_between_dollar_signs) {
    EXPECT_EQ(prose_label("The point $P_3$ of $N_{i,3}$"), "The point P_{3} of N_{i,3}");
    EXPECT_EQ(prose_label("from $5 to $6, \\alpha"), "from $5 to $6, \\alpha");
    EXPECT_EQ(unset_commands("\\foo and $\\bar x$"), std::vector<std::string>{"\\bar"});
    EXPECT_EQ(prose_label("half of it, $\\frac{1}$, is $x^2$"), "half of it, $\\frac{1}$, is x^{2}");
    EXPECT_EQ(prose_label("\\$x_1$, and \\$5 for $x_2$"), "$x_1$, and $5 for x_{2}");
}

}  // namespace
}  // namespace batten::render
