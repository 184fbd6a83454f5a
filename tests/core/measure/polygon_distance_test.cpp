#include "core/measure/polygon_distance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/curve/knot_analysis.h"
#include "core/evaluate/evaluate.h"
#include "core/refine/knot_insertion.h"
#include "tests/core/bezier_curve.h"
#include "tests/core/random_curves.h"

namespace batten::core {
namespace {

constexpr double looseness = 1e-4;

void expect_bound(double found, double exact) {
    EXPECT_GE(found, exact * (1.0 - 1e-14));
    EXPECT_LE(found, exact * (1.0 + looseness));
}

TEST(PolygonDistance, of_a_parabola_is_a_quarter_of_the_second_difference) {
    // C(1/2) = (P_0 + 2 P_1 + P_2) / 4 is farthest, from the corner P_1: |P_0 - 2 P_1 + P_2| / 4.
    expect_bound(polygon_distance(bezier({{0, 0}, {1, 2}, {2, 0}})), 1.0);
    expect_bound(polygon_distance(bezier({{0, 0}, {1, 2}, {8, 0}})), 0.25 * std::hypot(6, 4));
}

TEST(PolygonDistance, of_a_cubic) {
    // P_0 = 0, 3, 3, 0 in y: C is 9 t (1 - t), the polygon 9 t up to 1/3 and 3 to 2/3. At 1/3 they are 1 apart, at 1/2
    // 3/4; before 1/3 it is 9 t^2.
    expect_bound(polygon_distance(bezier({{0, 0}, {1, 3}, {2, 3}, {3, 0}})), 1.0);
}

TEST(PolygonDistance, of_a_conic_sees_the_weight) {
    // C(1/2) = (P_0 + 2 w P_1 + P_2) / (2 + 2 w): of the triangle's height 1 / (1 + w) is left.
    for (const double w : {0.01, 0.5, 1.0, 3.0, 1000.0})
        expect_bound(polygon_distance(bezier({{-1, 0}, {0, 1}, {1, 0}}, {1, w, 1})), 1.0 / (1.0 + w));
}

TEST(PolygonDistance, of_degree_1_is_none) {
    EXPECT_EQ(polygon_distance(bezier({{0, 0}, {1, 2}})), 0.0);
    EXPECT_EQ(polygon_distance(
                  Curve::make({.degree = 1, .knots = {0, 1, 2.5, 3, 4}, .points = {{0, 0}, {1, 0}, {1, 5}}}).value()),
              0.0);
}

TEST(PolygonDistance, of_points_on_a_line_in_step_is_none) {
    // Linear precision: points at their abscissae give the line itself.
    const Curve line =
        Curve::make(
            {.degree = 3, .knots = {0, 0, 0, 0, 1, 3, 3, 3, 3}, .points = {{0, 0}, {1, 2}, {4, 8}, {7, 14}, {9, 18}}})
            .value();
    EXPECT_LT(polygon_distance(line), 1e-14);
}

TEST(PolygonDistance, of_uniform_cubics) {
    // At its abscissa, which is a knot, the curve is (P_0 + 4 P_1 + P_2) / 6: from the corner a sixth of the second
    // difference, here (0, -6).
    const Curve open =
        Curve::make(
            {.degree = 3, .knots = {0, 1, 2, 3, 4, 5, 6, 7, 8}, .points = {{0, 0}, {1, 0}, {2, 3}, {3, 0}, {4, 0}}})
            .value();
    expect_bound(polygon_distance(open), 1.0);
    // A square: second differences of length 2 sqrt(2).
    const Curve square =
        Curve::make(
            {.degree = 3, .knots = {0, 1, 2, 3, 4}, .points = {{0, 0}, {2, 0}, {2, 2}, {0, 2}}, .periodic = true})
            .value();
    expect_bound(polygon_distance(square), 2.0 * std::sqrt(2.0) / 6.0);
    // Moved as far as it may be, it stays the same.
    CurveDefinition far = square.definition();
    for (Point& point : far.points) point += Vector{1e6, -1e6};
    EXPECT_NEAR(polygon_distance(Curve::make(far).value()), polygon_distance(square), 1e-8);
}

TEST(PolygonDistance, leaves_out_the_leg_across_a_tear) {
    const Curve torn = Curve::make({.degree = 2,
                                    .knots = {0, 0, 0, 1, 1, 1, 2, 2, 2},
                                    .points = {{0, 0}, {1, 2}, {2, 0}, {100, 0}, {101, 2}, {102, 0}},
                                    .tears = Tears::allow})
                           .value();
    expect_bound(polygon_distance(torn), 1.0);
}

TEST(PolygonDistance, is_a_bound_for_every_curve) {
    RandomCurves random(17);
    for (int k = 0; k < 200; ++k) {
        const Curve curve = random.curve();
        const double bound = polygon_distance(curve);
        const auto p = static_cast<std::size_t>(curve.degree());
        // The curve at the corners' abscissae inside the domain.
        for (std::size_t i = 0; i + p + 1 < curve.knots().size(); ++i) {
            const double u = greville_abscissa(curve.knots(), i);
            if (!(curve.domain().lower < u && u < curve.domain().upper)) continue;
            if (curve.knots().multiplicity(u) > curve.degree()) continue;
            const Point corner = curve.control_points()[i % curve.control_points().size()];
            EXPECT_LE(distance(point_at(curve, u), corner), bound * (1.0 + 1e-12) + 1e-12) << k;
        }
    }
}

TEST(PolygonDistance, is_quartered_by_midpoints) {
    RandomCurves random(18);
    for (int k = 0; k < 20; ++k) {
        CurveDefinition definition = random.curve().definition();
        if (definition.degree == 1) continue;
        if (k % 2 == 0) definition.weights.clear();
        Curve curve = Curve::make(definition).value();
        double before = 0.0;
        double now = polygon_distance(curve);
        for (int round = 0; round < 9; ++round) {
            curve = insert_midpoint_knots(curve).value();
            before = now;
            now = polygon_distance(curve);
        }
        EXPECT_NEAR(now / before, 0.25, 0.03) << k;
    }
}

TEST(PolygonDistance, of_degree_25_and_of_very_small_and_large_curves) {
    std::vector<Point> points;
    for (int i = 0; i <= 25; ++i) points.emplace_back(i, i % 2);
    const double distance = polygon_distance(bezier(points));
    EXPECT_GT(distance, 0.4);
    EXPECT_LT(distance, 1.0);
    for (const double size : {1e-150, 1e-8, 1e8, 1e150}) {
        std::vector<Point> sized;
        for (const Point point : points) sized.push_back(tip_of(size * vector_to(point)));
        EXPECT_NEAR(polygon_distance(bezier(sized)) / size, distance, 2e-4 * distance) << size;
    }
}

}  // namespace
}  // namespace batten::core
