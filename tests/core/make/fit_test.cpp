#include "core/make/fit.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/base/detail/gauss_rule.h"
#include "core/evaluate/evaluate.h"
#include "core/make/interpolate.h"
#include "core/measure/nearest.h"
#include "tests/core/random_curves.h"
#include "tests/core/told_progress.h"

namespace batten::core {

namespace {

// Points of a wave, unevenly spaced.
std::vector<Point> wave(std::size_t count, double noise = 0.0) {
    RandomCurves random(81);
    std::vector<Point> points;
    for (std::size_t k = 0; k < count; ++k) {
        const double t = 10.0 * static_cast<double>(k) / static_cast<double>(count - 1);
        const double x = t + 0.01 * std::sin(7.0 * t);
        points.emplace_back(x + random.number(-noise, noise), std::sin(x) + random.number(-noise, noise));
    }
    return points;
}

std::vector<Point> circle(std::size_t count) {
    std::vector<Point> points;
    for (std::size_t k = 0; k < count; ++k) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(count);
        points.emplace_back(5.0 + 2.0 * std::cos(angle), 1.0 + 2.0 * std::sin(angle));
    }
    return points;
}

// Over every seventh point.
double largest_distance(const Curve& curve, std::span<const Point> points) {
    double largest = 0.0;
    for (std::size_t k = 0; k < points.size(); k += 7)
        largest = std::max(largest, distance(nearest_point(curve, points[k]).point, points[k]));
    return largest;
}

}  // namespace

TEST(GaussRule, integrates_polynomials_of_twice_its_degree) {
    for (std::size_t count = 1; count <= 26; ++count)
        for (std::size_t power = 0; power < 2 * count; ++power) {
            double sum = 0.0;
            for (const GaussNode& node : gauss_rule(count))
                sum += node.weight * std::pow(node.position, static_cast<double>(power));
            EXPECT_NEAR(sum, power % 2 == 1 ? 0.0 : 2.0 / static_cast<double>(power + 1), 2e-14);
        }
}

TEST(Fit, progress_is_told_and_may_stop_it) {
    const std::vector<Point> points = wave(20'000);
    expect_progress([&](const Progress& progress) { EXPECT_TRUE(fit(points, 50, {}, progress)); });
    expect_progress([&](const Progress& progress) { EXPECT_TRUE(fit_within(points, 1e-4, {}, progress)); });
}

// The least squares line through (0,0), (1,1), (2,-1), (3,0) with its ends fixed is a straight leg; with one inner
// control point at u = 1/2 of a polyline the normal equation can be solved by hand: data at 1/3 and 2/3 have the share
// 2/3 of it, so it is (3/2) times the mean of what is left of them.
TEST(Fit, solves_the_normal_equations) {
    const Point points[] = {{0, 0}, {1, 1}, {2, 4}, {3, 0}};
    const auto found = fit(points, 3, {.degree = 1, .parametrization = Parametrization::uniform}).value();
    // Point 1 leaves (1, 1) - (0, 0)/3, point 2 leaves (2, 4) - (3, 0)/3.
    EXPECT_NEAR(found.curve.control_points()[1].x, 1.5 * 0.5 * (1.0 + 1.0), 1e-14);
    EXPECT_NEAR(found.curve.control_points()[1].y, 1.5 * 0.5 * (1.0 + 4.0), 1e-14);
    EXPECT_NEAR(found.error, 1.5, 1e-14);
    EXPECT_EQ(found.curve.knots()[2], 0.5);
}

TEST(Fit, ends_in_the_first_and_last_point_and_reports_the_largest_error) {
    const auto points = wave(200, 0.02);
    for (const int degree : {1, 2, 3, 5, 8}) {
        const auto found = fit(points, 20, {.degree = degree}).value();
        EXPECT_EQ(found.curve.control_points().size(), 20U);
        EXPECT_EQ(found.curve.control_points().front(), points.front());
        EXPECT_EQ(found.curve.control_points().back(), points.back());
        EXPECT_LE(largest_distance(found.curve, points), found.error * (1 + 1e-12));
        EXPECT_LT(found.error, 0.15) << degree;
        EXPECT_GT(found.error, 0.01) << degree;
    }
}

// The double next to 2/3 is 2/3 - 2^-53 / 3, where the leg from 0 to 3 is at 2 - 2^-53, which is no double.
TEST(Fit, reports_an_error_below_the_last_digit_of_the_points) {
    const Point points[] = {{0, 0}, {2, 0}, {3, 0}};
    const double error = fit(points, 2, {.degree = 1}).value().error;
    EXPECT_GE(error, 0x1p-53);
    EXPECT_LE(error, 0x1p-53 * (1 + 1e-15));
    EXPECT_EQ(fit_within(points, 0x1p-52, {.degree = 1}).value().curve.control_points().size(), 2U);
    EXPECT_EQ(fit_within(points, 0x1p-53, {.degree = 1}).value().curve.control_points().size(), 3U);
}

TEST(Fit, returns_a_polynomial_that_the_points_lie_on) {
    std::vector<Point> points;
    for (int k = 0; k <= 40; ++k) points.emplace_back(k / 40.0, std::pow(k / 40.0 - 0.3, 3));
    const auto found = fit(points, 9, {.parametrization = Parametrization::uniform}).value();
    EXPECT_LT(found.error, 1e-15);
    for (const double u : {0.11, 0.52, 0.93}) EXPECT_NEAR(point_at(found.curve, u).y, std::pow(u - 0.3, 3), 1e-15);
}

TEST(Fit, has_no_smaller_sum_of_squares_beside_it) {
    const auto points = wave(60, 0.05);
    const auto parameters = parametrize(points, Parametrization::chordal).value();
    const Curve best = fit(points, 9).value().curve;
    const auto sum = [&](const Curve& curve) {
        double squares = 0.0;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const Vector miss = point_at(curve, parameters[k]) - points[k];
            squares += dot(miss, miss);
        }
        return squares;
    };
    for (std::size_t i = 1; i + 1 < 9; ++i)
        for (const Vector move : {Vector(1e-4, 0), Vector(-1e-4, 0), Vector(0, 1e-4), Vector(0, -1e-4)}) {
            CurveDefinition moved = best.definition();
            moved.points[i] += move;
            EXPECT_GT(sum(Curve::make(moved).value()), sum(best));
        }
}

TEST(Fit, keeps_end_tangents) {
    const auto points = wave(100);
    const Vector start(10, 12);
    const Vector end(9, -4);
    for (const int degree : {2, 3, 6}) {
        const auto found = fit(points, 15, {.degree = degree, .ends = EndTangents{start, end}}).value();
        EXPECT_LT(length(derivatives_at(found.curve, 0.0, 1)[1] - start), 1e-12);
        EXPECT_LT(length(derivatives_at(found.curve, 1.0, 1)[1] - end), 1e-12);
        const auto one = fit(points, 15, {.degree = degree, .ends = EndTangents{.end = end}}).value();
        EXPECT_LT(length(derivatives_at(one.curve, 1.0, 1)[1] - end), 1e-12);
        EXPECT_GT(length(derivatives_at(one.curve, 0.0, 1)[1] - start), 0.1);
    }
    EXPECT_EQ(fit(points, 15, {.degree = 1, .ends = EndTangents{.start = start}}).error(),
              (CurveError{.code = CurveErrorCode::degree_too_low, .value = 1, .lower = 2}));
}

TEST(Fit, natural_ends_do_not_bend) {
    const auto points = wave(100);
    for (const int degree : {3, 4, 5})
        for (const std::size_t count : {8U, 15U}) {
            const auto found = fit(points, count, {.degree = degree, .ends = NaturalEnds{}}).value();
            for (const double end : {0.0, 1.0}) {
                EXPECT_LT(length(derivatives_at(found.curve, end, 2)[2]), 1e-9) << degree << ' ' << end;
                EXPECT_GT(length(derivatives_at(found.curve, end, 1)[1]), 1.0);
            }
            // A condition costs no more than it must: with all control points free the error is of the same size.
            EXPECT_LT(found.error, 4.0 * fit(points, count - 2, {.degree = degree}).value().error);
        }
    EXPECT_EQ(fit(points, 15, {.degree = 2, .ends = NaturalEnds{}}).error(),
              (CurveError{.code = CurveErrorCode::degree_too_low, .value = 2, .lower = 3}));
}

TEST(Fit, natural_ends_with_all_control_points_interpolate) {
    const auto points = wave(30);
    for (const int degree : {3, 4, 5}) {
        const auto fitted = fit(points, 32, {.degree = degree, .ends = NaturalEnds{}}).value();
        const auto through = interpolate(points, {.degree = degree, .ends = NaturalEnds{}}).value();
        EXPECT_LT(fitted.error, 1e-13);
        // Of higher degree the knots differ a little: here they are averaged over numbers of points.
        if (degree > 3) continue;
        for (std::size_t i = 0; i < 32; ++i)
            EXPECT_LT(distance(fitted.curve.control_points()[i], through.curve.control_points()[i]), 1e-11);
    }
}

TEST(Fit, of_two_points_with_natural_ends_is_their_line) {
    const std::vector<Point> points{{0, 0}, {3, 6}};
    const auto found = fit(points, 4, {.ends = NaturalEnds{}}).value();
    EXPECT_EQ(found.curve.control_points()[1], Point(1, 2));
    EXPECT_EQ(found.curve.control_points()[2], Point(2, 4));
}

TEST(Fit, within_a_tolerance_keeps_natural_ends) {
    const auto found = fit_within(wave(200), 1e-3, {.ends = NaturalEnds{}}).value();
    EXPECT_LE(found.error, 1e-3);
    EXPECT_LT(found.curve.control_points().size(), 40U);
    EXPECT_LT(length(derivatives_at(found.curve, 1.0, 2)[2]), 1e-8);
}

TEST(Fit, smoothing_bends_less_and_ends_in_a_straight_line) {
    const auto points = wave(200, 0.05);
    const auto bending = [](const Curve& curve) {
        double sum = 0.0;
        for (int k = 0; k < 1000; ++k) {
            const Vector bend = derivatives_at(curve, (k + 0.5) / 1000.0, 2)[2];
            sum += dot(bend, bend) / 1000.0;
        }
        return sum;
    };
    double before = std::numeric_limits<double>::infinity();
    for (const double smoothing : {0.0, 1e-8, 1e-6, 1e-4}) {
        const double now = bending(fit(points, 40, {.smoothing = smoothing}).value().curve);
        EXPECT_LT(now, before);
        before = now;
    }
    const Curve straight = fit(points, 40, {.smoothing = 1e12}).value().curve;
    for (const double u : {0.2, 0.5, 0.9})
        EXPECT_LT(distance(point_at(straight, u), points.front() + u * (points.back() - points.front())), 1e-3);
    EXPECT_TRUE(fit(points, 40, {.smoothing = 1e-4, .penalized_derivative = 3}));
    EXPECT_EQ(fit(points, 40, {.smoothing = -1}).error().code, CurveErrorCode::smoothing_negative);
}

TEST(Fit, closed_curves_have_no_seam) {
    const auto points = circle(50);
    for (const int degree : {2, 3, 4, 5}) {
        const auto found = fit(points, 12, {.degree = degree, .ends = ClosedEnds{}}).value();
        EXPECT_TRUE(found.curve.is_periodic());
        EXPECT_EQ(found.curve.control_points().size(), 12U);
        EXPECT_LT(found.error, 2e-2);
        for (const double u : {0.0, 0.1, 0.37, 0.98})
            EXPECT_NEAR(distance(point_at(found.curve, u), Point(5, 1)), 2.0, 2e-2);
    }
}

TEST(Fit, is_the_same_far_from_the_origin) {
    auto points = wave(100, 0.02);
    for (Point& point : points) point = Point(std::round(point.x * 1024) / 1024, std::round(point.y * 1024) / 1024);
    auto far = points;
    for (Point& point : far) point += Vector(1048576, -2097152);
    const Curve near_curve = fit(points, 12).value().curve;
    const Curve far_curve = fit(far, 12).value().curve;
    for (std::size_t i = 0; i < 12; ++i)
        EXPECT_LT(distance(near_curve.control_points()[i] + Vector(1048576, -2097152), far_curve.control_points()[i]),
                  1e-9);
}

// The squares of these distances are no doubles. Those of the points 1e-300 times as large are.
TEST(Fit, tells_the_error_of_the_largest_points) {
    std::vector<Point> points;
    std::vector<Point> large;
    for (int k = 0; k < 6; ++k) {
        points.emplace_back(k, k % 2);
        large.emplace_back(1e300 * k, 1e300 * (k % 2));
    }
    const double error = fit(points, 4).value().error;
    EXPECT_GT(error, 0.1);
    EXPECT_NEAR(fit(large, 4).value().error, 1e300 * error, 1e286);
    const auto refused = fit_within(large, 1e299, {.smoothing = 1e9});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, CurveErrorCode::tolerance_not_reached);
    EXPECT_TRUE(std::isfinite(refused.error().lower));
}

TEST(Fit, refuses_what_the_points_cannot_determine) {
    const auto points = wave(10);
    EXPECT_EQ(describe(fit(points, 11).error()),
              "11 control points were asked for; at most 10 can be determined by these points");
    EXPECT_EQ(fit(points, 3).error(), (CurveError{.code = CurveErrorCode::too_few_points, .value = 3, .lower = 4}));
    EXPECT_EQ(fit(points, 5, {.degree = 0}).error().code, CurveErrorCode::degree_out_of_range);
    EXPECT_LT(fit(points, 10).value().error, 1e-13);
    const Point same[] = {{0, 0}, {1, 1}, {1, 1}, {2, 0}, {3, 0}};
    EXPECT_EQ(describe(fit(same, 4).error()), "point 2 lies on point 1; the two must differ");
    const Point same_reversed[] = {{3, 0}, {2, 0}, {1, 1}, {1, 1}, {0, 0}};
    EXPECT_EQ(describe(fit(same_reversed, 4).error()), "point 3 lies on point 2; the two must differ");
    EXPECT_EQ(describe(fit_within(std::span(points).first(3), 0.1).error()),
              "3 points were found; at least 4 are needed");
}

TEST(FitWithin, meets_the_tolerance_with_knots_where_they_are_needed) {
    // Straight but for one bump.
    std::vector<Point> points;
    for (int k = 0; k <= 400; ++k) points.emplace_back(k / 40.0, std::exp(-8.0 * (k / 40.0 - 3.0) * (k / 40.0 - 3.0)));
    std::size_t before = 0;
    for (const double tolerance : {0.1, 1e-2, 1e-3, 1e-4, 1e-6}) {
        const auto found = fit_within(points, tolerance).value();
        EXPECT_LE(found.error, tolerance);
        EXPECT_LE(largest_distance(found.curve, points), tolerance);
        EXPECT_GE(found.curve.control_points().size(), before);
        before = found.curve.control_points().size();
    }
    const Curve found = fit_within(points, 1e-3).value().curve;
    const auto knots = found.knots().values();
    const auto near_bump = std::count_if(knots.begin(), knots.end(), [](double u) { return 0.1 < u && u < 0.5; });
    const auto beyond = std::count_if(knots.begin(), knots.end(), [](double u) { return 0.55 < u && u < 0.95; });
    EXPECT_GT(near_bump, 2 * beyond + 4);
}

TEST(FitWithin, goes_through_all_points_where_it_must) {
    const auto points = wave(60, 0.5);
    EXPECT_LT(fit_within(points, 1e-9).value().error, 1e-9);
    EXPECT_EQ(fit_within(points, 1e-9).value().curve.control_points().size(), 60U);
    EXPECT_EQ(fit_within(points, 1e-30).error().code, CurveErrorCode::tolerance_not_reached);
    EXPECT_EQ(fit_within(points, 0.01, {.smoothing = 1e9}).error().code, CurveErrorCode::tolerance_not_reached);
    EXPECT_EQ(fit_within(points, 0.0).error().code, CurveErrorCode::tolerance_not_positive);
    EXPECT_EQ(fit_within(points, NAN).error().code, CurveErrorCode::tolerance_not_positive);
}

TEST(FitWithin, closes_curves) {
    for (const int degree : {2, 3, 4})
        for (const double tolerance : {0.1, 1e-3, 1e-5}) {
            const auto found = fit_within(circle(200), tolerance, {.degree = degree, .ends = ClosedEnds{}}).value();
            EXPECT_TRUE(found.curve.is_periodic());
            EXPECT_LE(found.error, tolerance);
            EXPECT_LT(found.curve.control_points().size(), 200U);
            for (const double u : {0.0, 0.2, 0.7})
                EXPECT_NEAR(distance(point_at(found.curve, u), Point(5, 1)), 2.0, 2 * tolerance);
        }
}

// Halving where the errors are leads to breaks that these points do not determine.
TEST(FitWithin, goes_on_evenly_where_finer_breaks_are_singular) {
    constexpr std::array heights{2,  2, 1, -2, 2, 0,  0, 1, 1, -2, 2, 1, -1, -1, -3, 0, 1,  0,
                                 -3, 3, 2, -3, 1, -2, 3, 0, 2, 3,  0, 0, 3,  1,  -2, 0, -2, -3};
    std::vector<Point> points;
    for (std::size_t k = 0; k < heights.size(); ++k) points.emplace_back(static_cast<double>(k), heights[k]);
    const auto found = fit_within(points, 4e-4, {.degree = 4, .ends = ClosedEnds{}});
    ASSERT_TRUE(found.has_value()) << describe(found.error());
    EXPECT_LE(found->error, 4e-4);
    EXPECT_LE(found->curve.control_points().size(), points.size());
}
TEST(FitWithin, takes_many_points) {
    const auto points = wave(5000);
    const auto found = fit_within(points, 1e-4).value();
    EXPECT_LE(found.error, 1e-4);
    EXPECT_LT(found.curve.control_points().size(), 200U);
}

}  // namespace batten::core
