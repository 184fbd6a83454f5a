#include "app/editor/derived/blend_lines.h"

#include <gtest/gtest.h>

#include "tests/editor/pointer_driver.h"

namespace batten::editor {
namespace {

/// The lines of cell j of level r at u.
struct Lines {
    std::string blend;
    std::string homogeneous;
    WeightFormula weight;
    std::string projected;
};

Lines lines_of(const core::CurveDefinition& definition, double u, core::CellPlace place,
               const Notation& notation = {}) {
    const core::Curve curve = core::Curve::make(definition).value();
    const core::DeBoorTriangle triangle = core::de_boor_triangle(curve, u);
    const BlendedCell blended{{curve, triangle, notation}, place};
    return {blend_line(blended), homogeneous_line(blended), weight_formula(blended), projected_line(blended)};
}

/// The quarter of the unit circle from (1, 0) as its weights 1, 1, 2.
core::CurveDefinition quarter_circle() {
    return {.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{1, 0}, {1, 1}, {0, 1}}, .weights = {1, 1, 2}};
}

TEST(BlendLine, is_that_of_the_lecture) {
    // alpha = 0.8, 8/15, 0.2; 0.8, 0.3; 0.6.
    EXPECT_EQ(lines_of(test::cubic(), 0.4, {1, 0}).blend, "P_{2}^{1} = 1/5 P_{1} + 4/5 P_{2}");
    EXPECT_EQ(lines_of(test::cubic(), 0.4, {1, 1}).blend, "P_{3}^{1} = 7/15 P_{2} + 8/15 P_{3}");
    EXPECT_EQ(lines_of(test::cubic(), 0.4, {1, 2}).blend, "P_{4}^{1} = 4/5 P_{3} + 1/5 P_{4}");
    EXPECT_EQ(lines_of(test::cubic(), 0.4, {2, 1}).blend, "P_{4}^{2} = 7/10 P_{3}^{1} + 3/10 P_{4}^{1}");
    EXPECT_EQ(lines_of(test::cubic(), 0.4, {3, 0}).blend, "C(u) = 2/5 P_{3}^{2} + 3/5 P_{4}^{2}");
}

TEST(BlendLine, is_a_copy_where_u_is_a_knot) {
    EXPECT_EQ(lines_of(test::cubic(), 0.25, {1, 2}).blend, "P_{4}^{1} = P_{3}");
    EXPECT_EQ(lines_of(test::cubic(), 1.0, {1, 2}).blend, "P_{6}^{1} = P_{6}");
    EXPECT_EQ(lines_of(test::cubic(), 1.0, {3, 0}).blend, "C(u) = P_{6}^{2}");
}

TEST(BlendLine, has_decimals_where_there_is_no_small_fraction) {
    EXPECT_EQ(lines_of(test::cubic(), 0.4123, {1, 1}).blend, "P_{3}^{1} = 0.450 P_{2} + 0.550 P_{3}");
    EXPECT_EQ(lines_of(test::cubic(), 1e-7, {1, 1}).blend, "P_{2}^{1} = 1 P_{1} + 2e−7 P_{2}");
}

TEST(BlendLine, names_points_of_a_closed_curve_as_the_canvas_does) {
    EXPECT_EQ(lines_of(test::closed_cubic(), 5.5, {1, 0}).blend, "P_{6}^{1} = 1/6 P_{5} + 5/6 P_{0}");
}

TEST(BlendLine, of_a_rational_curve_has_the_shares_that_the_weights_make) {
    // At 1/2: 1/2 P_0 + 1/2 P_1 with equal weights; (1/2 1 P_1 + 1/2 2 P_2) / (3/2) = 1/3 P_1 + 2/3 P_2; then the
    // weights 1 and 3/2 give 5/4 and 2/5, 3/5: the point (3/5, 4/5) of the circle.
    EXPECT_EQ(lines_of(quarter_circle(), 0.5, {1, 0}).blend, "P_{1}^{1} = 1/2 P_{0} + 1/2 P_{1}");
    const Lines first = lines_of(quarter_circle(), 0.5, {1, 1});
    EXPECT_EQ(first.weight.symbols, "w_{2}^{1} = 1/2 w_{1} + 1/2 w_{2}");
    EXPECT_EQ(first.weight.numbers, "= 1/2 · 1 + 1/2 · 2 = 3/2");
    EXPECT_EQ(first.homogeneous, "w_{2}^{1} P_{2}^{1} = 1/2 w_{1} P_{1} + 1/2 w_{2} P_{2}");
    EXPECT_EQ(first.projected, "P_{2}^{1} = (1/2 w_{1} P_{1} + 1/2 w_{2} P_{2}) / w_{2}^{1}");
    EXPECT_EQ(first.blend, "P_{2}^{1} = 1/3 P_{1} + 2/3 P_{2}");
    const Lines last = lines_of(quarter_circle(), 0.5, {2, 0});
    EXPECT_EQ(last.weight.symbols, "w(u) = 1/2 w_{1}^{1} + 1/2 w_{2}^{1}");
    EXPECT_EQ(last.weight.numbers, "= 1/2 · 1 + 1/2 · 3/2 = 5/4");
    EXPECT_EQ(last.blend, "C(u) = 2/5 P_{1}^{1} + 3/5 P_{2}^{1}");
    EXPECT_EQ(lines_of(quarter_circle(), 0.0, {1, 1}).weight.symbols, "w_{2}^{1} = w_{1}");
    EXPECT_EQ(lines_of(quarter_circle(), 0.0, {1, 1}).weight.numbers, "= 1");
}

TEST(BlendLine, has_shares_that_make_its_point) {
    core::CurveDefinition definition = test::cubic();
    definition.weights = {1, 0.001, 1000, 3, 0.5, 7, 1};
    const core::Curve curve = core::Curve::make(definition).value();
    for (const double u : {0.1, 0.25, 0.4, 0.7, 0.99}) {
        const core::DeBoorTriangle triangle = core::de_boor_triangle(curve, u);
        for (std::size_t r = 1; r <= 3; ++r)
            for (std::size_t j = 0; j < triangle.levels[r].size(); ++j) {
                const Notation notation;
                const BlendedCell blended{{curve, triangle, notation}, {r, j}};
                const double share = blended.euclidean_share();
                const core::Point a = blended.named.cell(blended.lower()).point;
                const core::Point b = blended.named.cell(blended.upper()).point;
                const core::Point point = triangle.levels[r][j].point;
                EXPECT_NEAR(point.x, (1 - share) * a.x + share * b.x, 1e-13);
                EXPECT_NEAR(point.y, (1 - share) * a.y + share * b.y, 1e-13);
            }
    }
}

TEST(BlendLine, follows_the_notation) {
    EXPECT_EQ(lines_of(test::cubic(), 0.4, {1, 1}, {.triangles = CellNumbering::first}).blend,
              "P_{2}^{1} = 7/15 P_{2} + 8/15 P_{3}");
    EXPECT_EQ(lines_of(test::cubic(), 0.4, {2, 1}, {.triangles = CellNumbering::first}).blend,
              "P_{2}^{2} = 7/10 P_{2}^{1} + 3/10 P_{3}^{1}");
    EXPECT_EQ(lines_of(quarter_circle(), 0.5, {1, 1}, {.triangles = CellNumbering::first}).weight.symbols,
              "w_{1}^{1} = 1/2 w_{1} + 1/2 w_{2}");
    EXPECT_EQ(lines_of(test::cubic(), 0.4, {1, 1}, {.numbers = NumberStyle::decimals}).blend,
              "P_{3}^{1} = 0.467 P_{2} + 0.533 P_{3}");
    EXPECT_EQ(lines_of(quarter_circle(), 0.5, {1, 1}, {.numbers = NumberStyle::decimals}).weight.numbers,
              "= 0.500 · 1 + 0.500 · 2 = 1.5");
}

TEST(ShareTexts, sum_to_one_as_they_stand) {
    EXPECT_EQ(share_texts({}, 0.6666).lower, "0.333");
    EXPECT_EQ(share_texts({}, 0.6666).upper, "0.667");
    EXPECT_EQ(share_texts({}, 0.45051).lower, "0.549");
    EXPECT_EQ(share_texts({}, 0.45051).upper, "0.451");
    EXPECT_EQ(share_texts({}, 1.0 / 3.0).lower, "2/3");
    EXPECT_EQ(share_texts({}, 0.0).lower, "1");
    EXPECT_EQ(share_texts({}, 1.0 - 1e-9).lower, "1e−9");
}

}  // namespace
}  // namespace batten::editor
