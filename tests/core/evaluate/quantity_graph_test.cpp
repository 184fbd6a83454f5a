#include "core/evaluate/quantity_graph.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/bezier_curve.h"

namespace batten::core {
namespace {

constexpr Interval all_values{-1e9, 1e9};

// y = x^2 for x from -2 to 4, so x = 6u - 2.
Curve parabola() {
    return bezier({{-2, 4}, {1, -8}, {4, 16}});
}

TEST(QuantityGraph, parabola_in_closed_form) {
    const auto curvatures = quantity_graph(parabola(), Quantity::curvature, all_values, 60);
    const auto speeds = quantity_graph(parabola(), Quantity::speed, all_values, 60);
    ASSERT_EQ(curvatures.size(), 1U);
    ASSERT_EQ(speeds.size(), 1U);
    ASSERT_EQ(curvatures[0].size(), 61U);
    for (std::size_t k = 0; k < 61; ++k) {
        const double x = 6.0 * static_cast<double>(k) / 60.0 - 2.0;
        EXPECT_NEAR(curvatures[0][k].u, static_cast<double>(k) / 60.0, 1e-15);
        EXPECT_NEAR(curvatures[0][k].value, 2.0 / std::pow(1.0 + 4.0 * x * x, 1.5), 1e-12);
        EXPECT_NEAR(speeds[0][k].value, 6.0 * std::sqrt(1.0 + 4.0 * x * x), 1e-12);
    }
    // The other way the curve turns right.
    const auto mirrored = quantity_graph(bezier({{2, 4}, {-1, -8}, {-4, 16}}), Quantity::curvature, all_values, 8);
    EXPECT_LT(mirrored[0][0].value, 0.0);
}

TEST(QuantityGraph, each_span_has_its_own_values_at_a_knot) {
    // Two parabolas, y = x (1 - x) on [0, 1] and y = (x - 1) (x - 2) on [1, 2], with C1 at x = 1: curvature -2 and 2
    // over 2^(3/2).
    const Curve curve = Curve::make({.degree = 2,
                                     .knots = {0, 0, 0, 1, 1, 2, 2, 2},
                                     .points = {{0, 0}, {0.5, 0.5}, {1, 0}, {1.5, -0.5}, {2, 0}}})
                            .value();
    const auto runs = quantity_graph(curve, Quantity::curvature, all_values, 100);
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_EQ(runs[0].back().u, 1.0);
    EXPECT_EQ(runs[1].front().u, 1.0);
    EXPECT_NEAR(runs[0].back().value, -1.0 / std::sqrt(2.0), 1e-15);
    EXPECT_NEAR(runs[1].front().value, 1.0 / std::sqrt(2.0), 1e-15);
    const auto part = quantity_graph(curve, Quantity::speed, {0.25, 0.75}, 100);
    ASSERT_EQ(part.size(), 1U);
    EXPECT_EQ(part[0].front().u, 0.25);
    EXPECT_EQ(part[0].back().u, 0.75);
    EXPECT_NEAR(part[0].front().value, std::sqrt(1.0 + 0.25), 1e-15);
    EXPECT_TRUE(quantity_graph(curve, Quantity::speed, {2.0, 3.0}, 100).empty());
}

TEST(QuantityGraph, breaks_at_a_cusp_and_misses_in_a_point) {
    // (t^2, t^3) for t from -1 to 1 stands still at u = 1/2.
    const Curve cusp = bezier({{1, -1}, {-1.0 / 3, 1}, {-1.0 / 3, -1}, {1, 1}});
    const auto runs = quantity_graph(cusp, Quantity::curvature, all_values, 100);
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_LT(runs[0].back().u, 0.5);
    EXPECT_GT(runs[1].front().u, 0.5);
    EXPECT_EQ(quantity_graph(cusp, Quantity::speed, all_values, 100).size(), 1U);
    const Curve still = bezier({{1, 1}, {1, 1}, {1, 1}});
    EXPECT_TRUE(quantity_graph(still, Quantity::curvature, all_values, 100).empty());
    EXPECT_EQ(quantity_graph(still, Quantity::speed, all_values, 100)[0][3].value, 0.0);
}

TEST(QuantityGraph, cost_is_bounded_whatever_the_curve) {
    CurveDefinition definition{.degree = 3};
    for (int i = 0; i < 10'000; ++i) definition.points.emplace_back(1e6 + i, i % 3);
    for (int i = 0; i < 10'004; ++i) definition.knots.push_back(i);
    const Curve curve = Curve::make(std::move(definition)).value();
    const auto runs = quantity_graph(curve, Quantity::speed, all_values, 500);
    ASSERT_EQ(runs.size(), 1U);
    EXPECT_EQ(runs[0].size(), 501U);
    std::size_t count = 0;
    for (const GraphRun& run : quantity_graph(curve, Quantity::speed, {50.5, 60.5}, 500)) count += run.size();
    EXPECT_GE(count, 400U);
    EXPECT_LE(count, 511U);
    // On a periodic curve, whole.
    const Curve circle =
        Curve::make(
            {.degree = 2, .knots = {0, 1, 2, 3, 4}, .points = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}, .periodic = true})
            .value();
    EXPECT_EQ(quantity_graph(circle, Quantity::curvature, all_values, 100).size(), 4U);
}

}  // namespace
}  // namespace batten::core
