#include "core/evaluate/de_boor.h"

#include <gtest/gtest.h>

#include "core/evaluate/evaluate.h"
#include "tests/core/random_curves.h"
#include "tests/core/reference.h"

namespace batten::core {

namespace {

Curve example_wave() {
    return Curve::make(
               {.degree = 3,
                .knots = {0, 0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1},
                .points =
                    {{-6, -2.25}, {-4.5, 2.5}, {-1.5, 3.5}, {-0.5, -2.5}, {2.5, -3.25}, {3.5, 2.25}, {6.25, 2.75}}})
        .value();
}

}  // namespace

TEST(DeBoor, triangle_of_the_lecture_notes) {
    const DeBoorTriangle triangle = de_boor_triangle(example_wave(), 0.4);
    EXPECT_EQ(triangle.span, 4u);
    ASSERT_EQ(triangle.levels.size(), 4u);
    const std::vector<std::vector<double>> alphas{{0.8, 8.0 / 15, 0.2}, {0.8, 0.3}, {0.6}};
    for (std::size_t r = 1; r <= 3; ++r) {
        ASSERT_EQ(triangle.levels[r].size(), 4 - r);
        for (std::size_t j = 0; j < triangle.levels[r].size(); ++j)
            EXPECT_NEAR(triangle.levels[r][j].alpha, alphas[r - 1][j], 1e-15);
    }
    // alpha_3^1 = (0.4 - u_3) / (u_6 - u_3).
    const DeBoorCell& cell = triangle.levels[1][1];
    EXPECT_EQ(cell.index, 3u);
    EXPECT_EQ(cell.lower_knot, 3u);
    EXPECT_EQ(cell.upper_knot, 6u);
}

TEST(DeBoor, every_cell_is_what_its_alpha_and_knots_say) {
    RandomCurves random(21);
    for (int k = 0; k < 200; ++k) {
        const Curve curve = random.curve();
        const auto p = static_cast<std::size_t>(curve.degree());
        const Side side = random.whole(0, 1) == 0 ? Side::left : Side::right;
        const DeBoorTriangle triangle = de_boor_triangle(curve, random.parameter(curve), side);
        ASSERT_EQ(triangle.levels.size(), p + 1);
        for (std::size_t r = 0; r <= p; ++r) {
            ASSERT_EQ(triangle.levels[r].size(), p + 1 - r);
            for (std::size_t j = 0; j < triangle.levels[r].size(); ++j) {
                const DeBoorCell& cell = triangle.levels[r][j];
                EXPECT_EQ(cell.index, triangle.span - p + r + j);
                if (r == 0) continue;
                const double lower = curve.knots()[cell.lower_knot];
                const double upper = curve.knots()[cell.upper_knot];
                EXPECT_EQ(cell.upper_knot - cell.lower_knot, p - r + 1);
                EXPECT_EQ(cell.alpha, (triangle.u - lower) / (upper - lower));
                EXPECT_TRUE(cell.alpha >= 0.0 && cell.alpha <= 1.0);
                const DeBoorCell& a = triangle.levels[r - 1][j];
                const DeBoorCell& b = triangle.levels[r - 1][j + 1];
                const double weight = (1 - cell.alpha) * a.weight + cell.alpha * b.weight;
                const Vector sum =
                    (1 - cell.alpha) * a.weight * vector_to(a.point) + cell.alpha * b.weight * vector_to(b.point);
                EXPECT_NEAR(cell.weight, weight, 1e-14);
                EXPECT_LE(reference::relative_distance(curve, cell.point, tip_of(sum / weight)), 1e-14);
            }
        }
    }
}

TEST(DeBoor, ends_in_the_curve_point) {
    RandomCurves random(22);
    for (int k = 0; k < 200; ++k) {
        const Curve curve = random.curve();
        const double u = random.parameter(curve);
        EXPECT_LE(
            reference::relative_distance(curve, de_boor_triangle(curve, u).point(), reference::point_at(curve, u)),
            1e-14);
    }
}

TEST(DeBoor, ends_of_a_clamped_rational_curve_are_bit_equal_to_the_end_points) {
    // Lifting and projecting, x w / w, would change the last bit of some of these.
    for (int k = 1; k < 50; ++k) {
        const Point first(0.1 * k, 0.7 / k);
        const Point last(0.3 / k, -0.9 * k);
        const Curve curve = Curve::make({.degree = 2,
                                         .knots = {0, 0, 0, 1, 1, 1},
                                         .points = {first, {1, 1}, last},
                                         .weights = {0.3 * k, 1, 0.7 + 0.1 * k}})
                                .value();
        EXPECT_EQ(de_boor_triangle(curve, 0).point(), first);
        EXPECT_EQ(de_boor_triangle(curve, 1).point(), last);
        EXPECT_EQ(point_at(curve, 0), first);
        EXPECT_EQ(point_at(curve, 1), last);
    }
}

TEST(DeBoor, casteljau_has_one_alpha_throughout) {
    const Curve curve =
        Curve::make({.degree = 3, .knots = {2, 2, 2, 2, 6, 6, 6, 6}, .points = {{0, 0}, {1, 2}, {3, 2}, {4, 0}}})
            .value();
    const auto triangle = de_casteljau_triangle(curve, 3).value();
    for (std::size_t r = 1; r <= 3; ++r)
        for (const DeBoorCell& cell : triangle.levels[r]) EXPECT_EQ(cell.alpha, 0.25);
    EXPECT_EQ(triangle.point(), Point(58.0 / 64, 72.0 / 64));
}

TEST(DeBoor, casteljau_is_for_one_bezier_piece_only) {
    EXPECT_EQ(de_casteljau_triangle(example_wave(), 0.4).error().code, CurveErrorCode::curve_not_polynomial_piece);
    const Curve unclamped = Curve::make({.degree = 1, .knots = {0, 1, 2, 3}, .points = {{0, 0}, {1, 2}}}).value();
    EXPECT_EQ(de_casteljau_triangle(unclamped, 1.5).error().code, CurveErrorCode::curve_not_polynomial_piece);
}

}  // namespace batten::core
