#include "core/edit/offset.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/evaluate/evaluate.h"
#include "core/measure/nearest.h"
#include "tests/core/known_curves.h"
#include "tests/core/random_curves.h"

namespace batten::core {

namespace {

// Left turning, a quarter over each unit.
Curve circle_about(Point center, double radius) {
    return over(ellipse(radius, radius, center), 0.0, 4.0);
}

Curve gentle(bool periodic, bool rational, int degree = 3) {
    CurveDefinition definition{.degree = degree, .knots = {}, .points = {}, .periodic = periodic};
    const int n = 9;
    for (int i = 0; i < n; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / n;
        const double radius = 10.0 + 0.7 * std::sin(2.0 * angle);
        definition.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
        definition.weights.push_back(rational ? 1.0 + 0.1 * (i % 2) : 1.0);
    }
    for (int i = 0; i < (periodic ? n + 1 : n + degree + 1); ++i)
        definition.knots.push_back(periodic ? i : std::min(std::max(i, degree), n));
    return Curve::make(std::move(definition)).value();
}

Point true_offset(const Curve& curve, double u, double distance) {
    const auto d = derivatives_at(curve, u, 1);
    return d.point + distance / length(d[1]) * turned_left(d[1]);
}

double sampled_error(const Curve& curve, const Curve& result, double distance) {
    const Interval domain = curve.domain();
    double largest = 0.0;
    for (int k = 0; k <= 1000; ++k) {
        const double u = domain.clamp(domain.lower + domain.length() * k / 1000.0);
        largest = std::max(largest, core::distance(point_at(result, u), true_offset(curve, u, distance)));
    }
    return largest;
}

}  // namespace

TEST(Offset, of_a_circle_is_a_circle) {
    const Curve inner = offset(circle_about({3, -2}, 2.0), 0.5, 1e-9).value().curve;
    const Curve outer = offset(circle_about({3, -2}, 2.0), -0.5, 1e-9).value().curve;
    EXPECT_EQ(inner.degree(), 2);
    EXPECT_EQ(inner.control_points().size(), 9U);
    for (double u = 0.0; u <= 4.0; u += 0.01) {
        EXPECT_NEAR(distance(point_at(inner, u), Point(3, -2)), 1.5, 4e-15);
        EXPECT_NEAR(distance(point_at(outer, u), Point(3, -2)), 2.5, 4e-15);
    }
    EXPECT_EQ(describe(offset(circle_about({0, 0}, 2.0), 2.5, 1e-9).error()).substr(0, 20), "the distance is 2.5,");
}

TEST(Offset, of_a_line_is_the_parallel) {
    const Curve line = Curve::make({.degree = 2,
                                    .knots = {0, 0, 0, 1, 2, 2, 2},
                                    .points = {{0, 0}, {3, 4}, {6, 8}, {12, 16}},
                                    .weights = {1, 2, 3, 1}})
                           .value();
    const auto result = offset(line, 5.0, 1e-6).value();
    EXPECT_LT(result.error, 1e-14);
    const Vector move(-4, 3);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_LT(distance(result.curve.control_points()[i], line.control_points()[i] + move), 1e-14);
}

TEST(Offset, of_a_polygon_is_mitred) {
    const Curve square =
        Curve::make(
            {.degree = 1, .knots = {0, 1, 2, 3, 4}, .points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}}, .periodic = true})
            .value();
    const auto inside = offset(square, 1.0, 1e-6).value();
    const Point expected[] = {{1, 1}, {3, 1}, {3, 3}, {1, 3}};
    EXPECT_TRUE(std::ranges::equal(inside.curve.control_points(), expected));
    EXPECT_EQ(inside.error, 0.0);
    EXPECT_EQ(offset(square, -1.0, 1e-6).value().curve.control_points()[2], Point(5, 5));
    EXPECT_EQ(describe(offset(square, 2.0, 1e-6).error()),
              "leg 0 of the polygon would vanish or turn around; the distance must be less");
    const Curve open = Curve::make({.degree = 1, .knots = {0, 0, 1, 2, 2}, .points = {{0, 0}, {4, 0}, {4, 4}}}).value();
    const Point beside[] = {{0, -1}, {5, -1}, {5, 4}};
    EXPECT_TRUE(std::ranges::equal(offset(open, -1.0, 1e-6).value().curve.control_points(), beside));
    const Curve back = Curve::make({.degree = 1, .knots = {0, 0, 1, 2, 2}, .points = {{0, 0}, {4, 0}, {1, 0}}}).value();
    EXPECT_EQ(offset(back, 1.0, 1e-6).error(), (CurveError{.code = CurveErrorCode::curve_has_corner, .value = 1}));
}

TEST(Offset, keeps_its_tolerance_everywhere) {
    for (const bool periodic : {false, true})
        for (const bool rational : {false, true})
            for (const int degree : {2, 5})
                for (const double distance : {1.5, -3.0})
                    for (const double tolerance : {1e-2, 1e-7}) {
                        const Curve curve = gentle(periodic, rational, degree);
                        const auto result = offset(curve, distance, tolerance);
                        ASSERT_TRUE(result) << describe(result.error());
                        EXPECT_EQ(result->curve.is_periodic(), periodic);
                        EXPECT_EQ(result->curve.domain(), curve.domain());
                        EXPECT_LE(result->error, tolerance);
                        EXPECT_LE(sampled_error(curve, result->curve, distance), tolerance);
                    }
}

// The parabola y = x^2 has the offset points (t - 2 t d / s, t^2 + d / s) with s = sqrt(1 + 4 t^2).
TEST(Offset, tells_an_error_that_no_point_exceeds) {
    const Curve parabola =
        Curve::make({.degree = 2, .knots = {-1, -1, -1, 1, 1, 1}, .points = {{-1, 1}, {0, -1}, {1, 1}}}).value();
    for (const double d : {-0.7, 0.3})
        for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
            const Approximation found = offset(parabola, d, tolerance).value();
            double largest = 0.0;
            for (int k = 0; k <= 20000; ++k) {
                const double t = k / 10000.0 - 1.0;
                const double s = std::sqrt(1.0 + 4.0 * t * t);
                largest = std::max(largest, distance(point_at(found.curve, t), {t - 2.0 * t * d / s, t * t + d / s}));
            }
            EXPECT_GE(found.error, largest - 1e-14) << d << ", " << tolerance;
            EXPECT_LE(found.error, 1.02 * largest + 1e-12) << d << ", " << tolerance;
            EXPECT_LE(found.error, tolerance);
        }
}

TEST(Offset, of_a_curve_of_many_spans_has_room_for_all_of_them) {
    CurveDefinition definition{.degree = 3, .knots = {0, 0, 0}, .points = {}};
    constexpr int n = 21000;
    for (int i = 0; i < n; ++i) definition.points.emplace_back(i, std::sin(0.3 * i));
    for (int i = 0; i < n - 2; ++i) definition.knots.push_back(i);
    definition.knots.insert(definition.knots.end(), 3, n - 3);
    const Curve curve = Curve::make(std::move(definition)).value();
    const auto result = offset(curve, 0.1, 1e-3).value();
    EXPECT_LE(result.error, 1e-3);
    EXPECT_LE(sampled_error(curve, result.curve, 0.1), 1e-3);
}

TEST(Offset, lies_to_the_left_when_the_distance_is_positive) {
    const Curve curve = gentle(true, false);  // runs round (0, 0) to the left, which is inside
    const Curve inside = offset(curve, 2.0, 1e-6).value().curve;
    for (const double u : {0.0, 2.3, 7.9}) {
        EXPECT_LT(distance(point_at(inside, u), {}), distance(point_at(curve, u), {}) - 1.9);
        EXPECT_NEAR(distance(nearest_point(curve, point_at(inside, u)).point, point_at(inside, u)), 2.0, 2e-6);
    }
}

TEST(Offset, is_as_good_far_from_the_origin_and_over_any_domain) {
    CurveDefinition definition = gentle(false, true).definition();
    for (Point& point : definition.points) point += Vector(1e6, -1e6);
    const Curve far = Curve::make(definition).value();
    const auto result = offset(far, 1.0, 1e-7).value();
    EXPECT_LE(sampled_error(far, result.curve, 1.0), 1e-7);
    for (const double scale : {1e-9, 1e9}) {
        CurveDefinition scaled = gentle(false, true).definition();
        for (double& knot : scaled.knots) knot *= scale;
        const Curve curve = Curve::make(scaled).value();
        EXPECT_LE(sampled_error(curve, offset(curve, 1.0, 1e-7).value().curve, 1.0), 1e-7);
    }
}

TEST(Offset, refuses_cusps_corners_and_standstill) {
    const Curve parabola =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{-1, 1}, {0, -1}, {1, 1}}}).value();
    // y = x^2 has the radius of curvature 1/2 at u = 1/2, on its left.
    const auto error = offset(parabola, 0.6, 1e-6).error();
    EXPECT_EQ(error.code, CurveErrorCode::offset_too_far);
    EXPECT_LT(error.lower, 0.6);
    EXPECT_TRUE(offset(parabola, 0.45, 1e-6));
    EXPECT_TRUE(offset(parabola, -0.6, 1e-6));
    const Curve bent =
        Curve::make(
            {.degree = 2, .knots = {0, 0, 0, 1, 1, 2, 2, 2}, .points = {{0, 0}, {1, 1}, {2, 0}, {3, 1}, {4, 0}}})
            .value();
    EXPECT_EQ(offset(bent, 0.1, 1e-6).error(), (CurveError{.code = CurveErrorCode::curve_has_corner, .value = 1}));
    const Curve still =
        Curve::make({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{0, 0}, {0, 0}, {1, 2}, {3, 0}}})
            .value();
    EXPECT_EQ(offset(still, 0.1, 1e-6).error(), (CurveError{.code = CurveErrorCode::curve_stands_still, .value = 0}));
    EXPECT_EQ(offset(parabola, 0.1, 0.0).error().code, CurveErrorCode::tolerance_not_positive);
    EXPECT_EQ(offset(parabola, 0.1, 1e-30).error().code, CurveErrorCode::tolerance_not_reached);
    const Curve vast =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {1e160, 1e160}, {2e160, 0}}}).value();
    EXPECT_EQ(offset(vast, -1e159, 1e155).error().code, CurveErrorCode::not_computable);
    EXPECT_EQ(offset(parabola, 0.0, 1e-3).value().curve, parabola);
}

TEST(Offset, gives_an_answer_or_a_reason_for_any_curve) {
    RandomCurves random(121);
    int answers = 0;
    for (int trial = 0; trial < 60; ++trial) {
        const Curve curve = random.curve();
        const auto result = offset(curve, 0.02, 1e-3);
        if (!result) continue;
        ++answers;
        EXPECT_LE(result->error, 1e-3);
    }
    EXPECT_GT(answers, 10);
}

}  // namespace batten::core
