#include "core/evaluate/end_derivatives.h"

#include <gtest/gtest.h>

#include "core/evaluate/evaluate.h"
#include "tests/core/random_curves.h"

namespace batten::core {

TEST(EndDerivatives, of_a_clamped_cubic_are_the_formulas_with_their_numbers) {
    // 3 (P1 - P0) / (1 - 0) and 6 / 1 ((P2 - P1) / 3 - (P1 - P0) / 1), and at the end, where the knots 3 and 1 are 1
    // and 3 away from 4, 3 (P4 - P3) / 1 and 6 / 1 ((P4 - P3) / 1 - (P3 - P2) / 3).
    const Curve curve = Curve::make({.degree = 3,
                                     .knots = {0, 0, 0, 0, 1, 3, 4, 4, 4, 4},
                                     .points = {{0, 0}, {1, 2}, {4, 5}, {7, 2}, {9, 1}, {9, 0}}})
                            .value();
    const auto start = end_derivatives(curve, CurveEnd::start).value();
    EXPECT_EQ(start.factor, 3.0);
    EXPECT_EQ(start.first, Vector(3, 6));
    EXPECT_EQ(start.end_knot.index, 3U);
    EXPECT_EQ(start.near.index, 4U);
    EXPECT_EQ(start.near.value, 1.0);
    EXPECT_EQ(start.second->far.index, 5U);
    EXPECT_EQ(start.second->far.value, 3.0);
    EXPECT_EQ(start.near_point.index, 1U);
    EXPECT_EQ(start.second->far_point.index, 2U);
    EXPECT_EQ(start.second->value, Vector(0, -6));
    EXPECT_EQ(start.second->far_factor, 2.0);
    EXPECT_EQ(start.second->near_factor, 8.0);
    EXPECT_FALSE(start.is_rational);
    const auto end = end_derivatives(curve, CurveEnd::end).value();
    EXPECT_EQ(end.first, Vector(0, -3));
    EXPECT_EQ(end.end_knot.index, 6U);
    EXPECT_EQ(end.near.index, 5U);
    EXPECT_EQ(end.second->far.index, 4U);
    EXPECT_EQ(end.end_point.index, 5U);
    EXPECT_EQ(end.second->far_point.index, 3U);
    EXPECT_EQ(end.second->value, Vector(-4, -4));
}

TEST(EndDerivatives, of_a_quarter_circle_have_its_weights) {
    // (1 - t^2, 2t) / (1 + t^2)
    const Curve arc =
        Curve::make(
            {.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{1, 0}, {1, 1}, {0, 1}}, .weights = {1, 1, 2}})
            .value();
    const auto start = end_derivatives(arc, CurveEnd::start).value();
    EXPECT_TRUE(start.is_rational);
    EXPECT_EQ(start.first, Vector(0, 2));
    EXPECT_EQ(start.second->far_factor, 4.0);
    EXPECT_EQ(start.second->near_factor, 4.0);
    EXPECT_EQ(start.second->value, Vector(-4, 0));
    const auto end = end_derivatives(arc, CurveEnd::end).value();
    EXPECT_EQ(end.factor, 1.0);
    EXPECT_EQ(end.first, Vector(-1, 0));
    EXPECT_EQ(end.second->far_factor, 1.0);
    EXPECT_EQ(end.second->near_factor, 0.0);
    EXPECT_EQ(end.second->value, Vector(1, -1));
}

TEST(EndDerivatives, agree_with_the_derivatives_of_all_curves) {
    RandomCurves random(331);
    int found = 0;
    for (int k = 0; k < 400; ++k) {
        const Curve curve = random.curve();
        for (const CurveEnd end : {CurveEnd::start, CurveEnd::end}) {
            const auto at = end_derivatives(curve, end);
            if (!at) continue;
            const Jet jet = derivatives_at(curve, parameter_of(curve.domain(), end), 2);
            EXPECT_EQ(jet.point, at->end_point.point);
            EXPECT_LE(robust_length(at->first - jet[1]), 1e-13 * robust_length(jet[1])) << k;
            EXPECT_EQ(at->second.has_value(), curve.degree() > 1);
            if (!at->second) continue;
            const double size =
                at->second->far_factor * robust_length(at->second->far_point.point - at->end_point.point);
            const double other = at->second->near_factor * robust_length(at->near_point.point - at->end_point.point);
            EXPECT_LE(robust_length(at->second->value - jet[2]), 1e-13 * (size + std::abs(other))) << k;
            ++found;
        }
    }
    EXPECT_GT(found, 200);
}

TEST(EndDerivatives, are_none_where_the_curve_does_not_begin_in_a_control_point) {
    const std::vector<Point> points{{0, 0}, {1, 2}, {4, 5}, {7, 2}};
    const Curve uniform = Curve::make({.degree = 2, .knots = {0, 1, 2, 3, 4, 5, 6}, .points = points}).value();
    EXPECT_FALSE(end_derivatives(uniform, CurveEnd::start));
    EXPECT_FALSE(end_derivatives(uniform, CurveEnd::end));
    const Curve periodic =
        Curve::make({.degree = 2, .knots = {0, 1, 2, 3, 4}, .points = points, .periodic = true}).value();
    EXPECT_FALSE(end_derivatives(periodic, CurveEnd::start));
    // The outermost knot acts on nothing, and every leg of a polygon begins in a control point.
    const Curve loose = Curve::make({.degree = 2, .knots = {-1, 0, 0, 1, 2, 2, 3}, .points = points}).value();
    EXPECT_EQ(end_derivatives(loose, CurveEnd::start)->first, Vector(2, 4));
    EXPECT_EQ(end_derivatives(loose, CurveEnd::end)->first, Vector(6, -6));
    const Curve polygon = Curve::make({.degree = 1, .knots = {-1, 0, 2, 3, 4, 5}, .points = points}).value();
    EXPECT_EQ(end_derivatives(polygon, CurveEnd::start)->first, Vector(0.5, 1));
    // P0 acts nowhere where the end of the domain has all its knots but the first.
    const Curve shifted = Curve::make({.degree = 2, .knots = {-1, 0, 0, 0, 1, 1, 1}, .points = points}).value();
    EXPECT_EQ(end_derivatives(shifted, CurveEnd::start)->end_point.index, 1U);
    EXPECT_EQ(end_derivatives(shifted, CurveEnd::start)->first, Vector(6, 6));
}

TEST(EndDerivatives, of_a_weighted_line_bend_in_time_only) {
    const Curve line =
        Curve::make({.degree = 1, .knots = {0, 0, 2, 2}, .points = {{0, 0}, {4, 2}}, .weights = {1, 3}}).value();
    const auto start = end_derivatives(line, CurveEnd::start).value();
    EXPECT_EQ(start.first, Vector(6, 3));
    EXPECT_EQ(start.factor, 1.5);
}

}  // namespace batten::core
