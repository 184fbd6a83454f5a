#include "core/evaluate/hodograph.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/curve/knot_analysis.h"
#include "core/evaluate/evaluate.h"
#include "tests/core/random_curves.h"

namespace batten::core {

namespace {

Curve without_weights(const Curve& curve) {
    CurveDefinition definition = curve.definition();
    definition.weights.clear();
    return Curve::make(std::move(definition)).value();
}

// The largest difference of the hodograph from the derivative, seen from both sides, by the largest derivative met.
double worst_difference(const Curve& curve, const Curve& derivative, RandomCurves& random, int order = 1) {
    double worst = 0.0;
    double scale = 0.0;
    for (int k = 0; k < 40; ++k) {
        const double u = random.parameter(curve);
        // Where it jumps, an open hodograph has at each end only the side that is inside.
        const bool is_seam = u == curve.domain().lower || u == curve.domain().upper;
        if (curve.is_periodic() && !derivative.is_periodic() && is_seam) continue;
        for (const Side side : {Side::left, Side::right}) {
            const Vector expected = derivatives_at(curve, u, order, side)[static_cast<std::size_t>(order)];
            worst = std::max(worst, distance(point_at(derivative, u, side), tip_of(expected)));
            scale = std::max(scale, length(expected));
        }
    }
    return scale > 0.0 ? worst / scale : worst;
}

}  // namespace

TEST(Hodograph, is_the_derivative_of_every_polynomial_curve) {
    RandomCurves random(301);
    for (int k = 0; k < 300; ++k) {
        const Curve curve = without_weights(random.curve());
        const auto result = hodograph(curve);
        ASSERT_TRUE(result) << describe(result.error());
        EXPECT_EQ(result->degree(), std::max(1, curve.degree() - 1));
        EXPECT_EQ(result->domain(), curve.domain());
        EXPECT_FALSE(result->is_rational());
        EXPECT_LE(worst_difference(curve, *result, random), 1e-13) << k;
    }
}

TEST(Hodograph, is_the_derivative_of_every_rational_curve) {
    RandomCurves random(302);
    for (int k = 0; k < 300; ++k) {
        const Curve curve = random.curve();
        if (!curve.is_rational()) continue;
        const auto result = hodograph(curve);
        ASSERT_TRUE(result) << describe(result.error());
        EXPECT_EQ(result->degree(), 2 * curve.degree());
        EXPECT_EQ(result->domain(), curve.domain());
        EXPECT_LE(worst_difference(curve, *result, random), 1e-12) << k;
    }
}

TEST(Hodograph, keeps_its_digits_far_from_the_origin) {
    RandomCurves random(303);
    for (int k = 0; k < 100; ++k) {
        CurveDefinition definition = random.curve().definition();
        // Multiples of 2^-20, which a translation by 2^20 keeps.
        for (Point& point : definition.points)
            point = {std::floor(point.x * 1048576.0) / 1048576.0, std::floor(point.y * 1048576.0) / 1048576.0};
        const auto near = hodograph(Curve::make(definition).value()).value();
        for (Point& point : definition.points) point += Vector(1048576.0, -1048576.0);
        const auto far = hodograph(Curve::make(definition).value()).value();
        EXPECT_TRUE(std::ranges::equal(near.control_points(), far.control_points())) << k;
        EXPECT_TRUE(std::ranges::equal(near.weights(), far.weights())) << k;
    }
}

TEST(Hodograph, of_a_periodic_curve_is_periodic_unless_it_jumps) {
    const std::vector<Point> points{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    const auto smooth =
        Curve::make({.degree = 3, .knots = {0, 1, 2, 3, 4}, .points = points, .periodic = true}).value();
    const Curve derivative = hodograph(smooth).value();
    EXPECT_TRUE(derivative.is_periodic());
    // Knot t_0 = u_3 is the blossom's last argument of P_0; Q_0 = 3 (P_1 - P_0) / (u_4 - u_1) with steps of 1.
    EXPECT_EQ(derivative.control_points()[0], Point(4, 0));
    EXPECT_EQ(derivative.control_points()[3], Point(0, -4));
    EXPECT_EQ(derivative.control_points().size(), 4u);

    const auto cornered =
        Curve::make({.degree = 2, .knots = {0, 1, 1, 3, 4}, .points = points, .periodic = true}).value();
    EXPECT_FALSE(hodograph(cornered)->is_periodic());
    const auto cornered_at_seam =
        Curve::make({.degree = 2, .knots = {0, 0, 1, 3, 4}, .points = points, .periodic = true}).value();
    EXPECT_FALSE(hodograph(cornered_at_seam)->is_periodic());
    CurveDefinition weighted = smooth.definition();
    weighted.weights = {1, 2, 1, 1};
    EXPECT_TRUE(hodograph(Curve::make(weighted).value())->is_periodic());
}

TEST(Hodograph, of_a_polygon_is_a_step_for_each_leg) {
    const auto polygon =
        Curve::make({.degree = 1, .knots = {0, 0, 1, 3, 3}, .points = {{0, 0}, {2, 0}, {2, 6}}}).value();
    const Curve steps = hodograph(polygon).value();
    EXPECT_EQ(steps.degree(), 1);
    EXPECT_TRUE(std::ranges::equal(steps.knots().values(), std::vector<double>{0, 0, 1, 1, 3, 3}));
    EXPECT_TRUE(std::ranges::equal(steps.control_points(), std::vector<Point>{{2, 0}, {2, 0}, {0, 3}, {0, 3}}));
}

TEST(Hodograph, of_a_torn_curve_is_torn_there) {
    const auto torn = Curve::make({.degree = 2,
                                   .knots = {0, 0, 0, 1, 1, 1, 2, 2, 2},
                                   .points = {{0, 0}, {1, 0}, {1, 1}, {5, 5}, {6, 5}, {6, 7}},
                                   .tears = Tears::allow})
                          .value();
    const Curve derivative = hodograph(torn).value();
    EXPECT_TRUE(std::ranges::equal(derivative.knots().values(), std::vector<double>{0, 0, 1, 1, 2, 2}));
    EXPECT_TRUE(std::ranges::equal(derivative.control_points(), std::vector<Point>{{2, 0}, {0, 2}, {2, 0}, {0, 4}}));
}

TEST(Hodograph, refuses_a_rational_curve_of_too_high_a_degree) {
    const auto bezier = [](std::size_t degree) {
        CurveDefinition definition{.degree = static_cast<int>(degree)};
        definition.knots.assign(degree + 1, 0.0);
        definition.knots.insert(definition.knots.end(), degree + 1, 1.0);
        for (std::size_t i = 0; i <= degree; ++i) {
            definition.points.emplace_back(static_cast<double>(i), static_cast<double>(i * i % 5));
            definition.weights.push_back(1.0 + static_cast<double>(i % 3));
        }
        return Curve::make(std::move(definition)).value();
    };
    EXPECT_TRUE(hodograph(bezier(12)).has_value());
    EXPECT_EQ(hodograph(bezier(13)).error(), (CurveError{.code = CurveErrorCode::degree_out_of_range, .value = 26}));
}

TEST(Hodograph, of_a_quarter_circle_has_the_known_ends_and_middle) {
    const auto quarter = Curve::make({.degree = 2,
                                      .knots = {0, 0, 0, 1, 1, 1},
                                      .points = {{1, 0}, {1, 1}, {0, 1}},
                                      .weights = {1, std::sqrt(0.5), 1}})
                             .value();
    const Curve derivative = hodograph(quarter).value();
    // C'(0) = 2 w1 / w0 (P1 - P0).
    EXPECT_NEAR(derivative.control_points().front().y, std::sqrt(2.0), 1e-15);
    EXPECT_EQ(derivative.control_points().front().x, 0.0);
    EXPECT_NEAR(derivative.control_points().back().x, -std::sqrt(2.0), 1e-15);
    // At the middle both components are of the size 4 (sqrt 2 - 1) / sqrt 2.
    EXPECT_NEAR(point_at(derivative, 0.5).y, 4.0 * (std::sqrt(2.0) - 1.0) / std::sqrt(2.0), 1e-15);
    EXPECT_NEAR(point_at(derivative, 0.5).x, -point_at(derivative, 0.5).y, 1e-15);
}

TEST(SecondHodograph, is_the_second_derivative_of_every_curve) {
    RandomCurves random(305);
    int rational = 0;
    for (int k = 0; k < 300; ++k) {
        const Curve drawn = random.curve();
        const Curve curve = k % 2 == 0 ? drawn : without_weights(drawn);
        const auto result = second_hodograph(curve);
        if (curve.is_rational() && curve.degree() > 8) {
            EXPECT_EQ(result.error().code, CurveErrorCode::degree_out_of_range);
            continue;
        }
        ASSERT_TRUE(result) << describe(result.error());
        EXPECT_EQ(result->degree(), curve.is_rational() ? 3 * curve.degree() : std::max(1, curve.degree() - 2));
        EXPECT_EQ(result->domain(), curve.domain());
        EXPECT_LE(worst_difference(curve, *result, random, 2), 1e-9) << k;
        rational += curve.is_rational() ? 1 : 0;
    }
    EXPECT_GT(rational, 50);
}

TEST(SecondHodograph, of_a_cubic_is_the_line_between_its_end_accelerations) {
    const Curve cubic =
        Curve::make({.degree = 3, .knots = {0, 0, 0, 0, 2, 2, 2, 2}, .points = {{0, 0}, {1, 2}, {3, 3}, {4, 0}}})
            .value();
    // 6 (P2 - 2 P1 + P0) / 4 and 6 (P3 - 2 P2 + P1) / 4.
    const Curve second = second_hodograph(cubic).value();
    EXPECT_EQ(second.degree(), 1);
    EXPECT_TRUE(std::ranges::equal(second.control_points(), std::vector<Point>{{1.5, -1.5}, {-1.5, -6}}));
}

TEST(SecondHodograph, of_the_circle_points_to_its_center) {
    // (1 - t^2, 2t) / (1 + t^2): C''(0) = (-4, 0), C''(1) = (1, -1): the weights 1, 1, 2 are those of the text books.
    const Curve arc =
        Curve::make(
            {.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{1, 0}, {1, 1}, {0, 1}}, .weights = {1, 1, 2}})
            .value();
    const Curve second = second_hodograph(arc).value();
    EXPECT_EQ(second.degree(), 6);
    EXPECT_NEAR(distance(point_at(second, 0.0), {-4, 0}), 0.0, 1e-14);
    EXPECT_NEAR(distance(point_at(second, 1.0), {1, -1}), 0.0, 1e-14);
}

TEST(SecondHodograph, of_polygons_is_zero_and_of_parabolas_a_step_for_each_piece) {
    const auto polygon =
        Curve::make({.degree = 1, .knots = {0, 0, 1, 3, 3}, .points = {{0, 0}, {2, 0}, {2, 6}}}).value();
    const Curve nothing = second_hodograph(polygon).value();
    for (const Point& point : nothing.control_points()) EXPECT_EQ(point, Point(0, 0));
    const auto parabolas =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 2, 2, 2}, .points = {{0, 0}, {1, 0}, {1, 1}, {3, 1}}}).value();
    // C' goes from (2, 0) by (0, 1) to (4, 0).
    const Curve steps = second_hodograph(parabolas).value();
    EXPECT_TRUE(std::ranges::equal(steps.control_points(), std::vector<Point>{{-2, 1}, {-2, 1}, {4, -1}, {4, -1}}));
}

}  // namespace batten::core
