#include "core/measure/nearest.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/curve/knot_analysis.h"
#include "core/curve/knot_kinds.h"
#include "core/evaluate/evaluate.h"
#include "core/refine/degree.h"
#include "core/refine/knot_refinement.h"
#include "tests/core/golden.h"
#include "tests/core/known_curves.h"
#include "tests/core/random_curves.h"

namespace batten::core {
namespace {

const double half_root = std::sqrt(0.5);

TEST(Golden, closest_point) {
    golden::Tally tally("closest_point.json");
    for (const auto& members : golden::cases("closest_point.json")) {
        tally.count_case();
        const auto name = members.at("name").get<std::string>();
        const Curve curve = golden::curve_of(members);
        const Point query(members.at("query").at(0).get<double>(), members.at("query").at(1).get<double>());
        const CurveSample found = nearest_point(curve, query);
        const double size = golden::largest_coordinate(curve.control_points());
        const double distance = members.at("distance").get<double>();
        tally.add("distance", std::abs(core::distance(found.point, query) - distance) / size, 1e-14, name);
        EXPECT_EQ(found.point, point_at(curve, found.u)) << name;
        tally.add("parameter", std::abs(found.u - members.at("u").get<double>()) / curve.domain().length(), 1e-11,
                  name);
    }
}

TEST(Nearest, is_never_farther_than_any_sample) {
    RandomCurves random(71);
    for (int i = 0; i < 300; ++i) {
        const Curve curve = random.curve();
        const double x = random.number(-10.0, 10.0);
        const Point query(x, random.number(-10.0, 10.0));
        const double found = distance(nearest_point(curve, query).point, query);
        for (int k = 0; k <= 500; ++k) {
            const double u = curve.domain().lower + curve.domain().length() * k / 500.0;
            EXPECT_LE(found, distance(point_at(curve, u), query) + 1e-12);
        }
    }
}

TEST(Nearest, point_of_the_curve_is_its_own_nearest) {
    RandomCurves random(72);
    for (int i = 0; i < 300; ++i) {
        const Curve curve = random.curve();
        const Point query = point_at(curve, random.parameter(curve));
        EXPECT_LE(distance(nearest_point(curve, query).point, query), 8.0 * 2e-14);
    }
}

TEST(Nearest, of_equally_near_points_the_first_is_taken) {
    EXPECT_EQ(nearest_point(ellipse(1, 1), {0, 0}).u, 0.0);
    const Curve valley =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{-1, 1}, {0, -1}, {1, 1}}}).value();
    // y = x^2 has the two nearest points x = -+sqrt(1/2) to (0, 1).
    const CurveSample found = nearest_point(valley, {0, 1});
    EXPECT_NEAR(found.point.x, -half_root, 1e-12);
    EXPECT_NEAR(found.u, 0.5 - 0.5 * half_root, 1e-12);
}

TEST(Nearest, seam_of_a_closed_curve_is_its_beginning) {
    EXPECT_EQ(nearest_point(ellipse(1, 1), {2, 0}).u, 0.0);
    const Curve loop =
        Curve::make(
            {.degree = 2, .knots = {0, 1, 2, 3, 4}, .points = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}, .periodic = true})
            .value();
    EXPECT_EQ(nearest_point(loop, tip_of(3.0 * vector_to(point_at(loop, 0.0)))).u, 0.0);
}

TEST(Nearest, corner_and_ends_are_found) {
    const Curve polyline =
        Curve::make({.degree = 1, .knots = {0, 0, 1, 2, 2}, .points = {{0, 0}, {2, 0}, {2, 2}}}).value();
    EXPECT_EQ(nearest_point(polyline, {3, -1}).u, 1.0);
    EXPECT_EQ(nearest_point(polyline, {-1, -1}).u, 0.0);
    EXPECT_EQ(nearest_point(polyline, {2.5, 9}).u, 2.0);
    EXPECT_NEAR(nearest_point(polyline, {0.5, -3}).u, 0.25, 1e-15);
}

TEST(Nearest, cusp_has_no_speed_and_is_found_all_the_same) {
    const Curve cusp =
        Curve::make({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{0, 0}, {1, 1}, {0, 1}, {1, 0}}})
            .value();
    EXPECT_NEAR(nearest_point(cusp, {0.5, 2.0}).u, 0.5, 1e-6);
    EXPECT_NEAR(distance(nearest_point(cusp, {0.5, 2.0}).point, Point(0.5, 0.75)), 0.0, 1e-12);
}

TEST(Nearest, far_from_the_origin_as_near_it) {
    const Vector offset(1e6, -3e6);
    RandomCurves random(73);
    for (int i = 0; i < 50; ++i) {
        const Curve curve = random.open_curve();
        CurveDefinition moved = curve.definition();
        for (Point& point : moved.points) point += offset;
        const Point query(random.number(-10.0, 10.0), 4.0);
        const double near = distance(nearest_point(curve, query).point, query);
        const Curve far = Curve::make(moved).value();
        EXPECT_NEAR(distance(nearest_point(far, query + offset).point, query + offset), near, 1e-8);
    }
}

TEST(Nearest, query_beyond_all_measure_ends) {
    EXPECT_NEAR(nearest_point(ellipse(1, 1), {1e12, 0}).u, 0.0, 1e-9);
    EXPECT_TRUE(std::isfinite(nearest_point(ellipse(1, 1), {0, 1e200}).point.y));
    EXPECT_NEAR(nearest_point(ellipse(1, 1), {1e-9, 1e-9}).u, 0.125, 1e-5);
    const Curve overflowing = Curve::make({.degree = 3,
                                           .knots = {5, 5, 5, 5, 6, 6, 6, 6},
                                           .points = {{0, 0}, {1e20, 5}, {2, -1e300}, {3, 0}},
                                           .weights = {1e-300, 1e300, 1e10, 1e-300}})
                                  .value();
    EXPECT_TRUE(overflowing.domain().contains(nearest_point(overflowing, {1, 1}).u));
    const Curve point = Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {3, Point(1, 1)}}).value();
    EXPECT_EQ(nearest_point(point, {1, 1}).u, 0.0);
}

TEST(Nearest, a_finder_answers_every_question_as_the_plain_call_does) {
    RandomCurves random(74);
    for (int i = 0; i < 50; ++i) {
        const Curve curve = random.curve();
        const NearestFinder finder(curve);
        for (int k = 0; k < 10; ++k) {
            const double x = random.number(-10.0, 10.0);
            const Point query(x, random.number(-10.0, 10.0));
            const CurveSample found = finder.nearest(query);
            const CurveSample expected = nearest_point(curve, query);
            EXPECT_EQ(found.u, expected.u);
            EXPECT_EQ(found.point, expected.point);
        }
    }
}

// On both sides of a tear the curve has a point of its own.
TEST(Nearest, both_ends_of_a_tear_are_found) {
    const Curve torn = Curve::make({.degree = 1,
                                    .knots = {0, 0, 1, 1, 2, 2},
                                    .points = {{0, 0}, {2, 0}, {2, 1}, {0, 1}},
                                    .tears = Tears::allow})
                           .value();
    EXPECT_EQ(nearest_point(torn, {3, 0.25}).point, Point(2, 0));
    EXPECT_EQ(nearest_point(torn, {3, 0.75}).point, Point(2, 1));
}

// A gentle wave of n control points.
Curve wave(int degree, std::size_t n) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < n; ++i) {
        const double x = static_cast<double>(i) / static_cast<double>(n);
        points.emplace_back(x, 0.05 * std::sin(30.0 * x));
    }
    return Curve::make(make_knots(KnotKind::clamped_uniform, degree, n).value(), std::move(points), {}).value();
}

TEST(Nearest, looks_grow_as_the_logarithm_of_the_control_points) {
    const Point queries[] = {{0.3, 0.01}, {0.5, 0.2}, {0.77, -0.1}, {1.5, 0.0}, {-2.0, 3.0}};
    for (const int degree : {1, 3, 10})
        for (const std::size_t n : {100U, 1000U, 10'000U, 100'000U}) {
            const NearestFinder finder(wave(degree, n));
            for (const Point& query : queries) {
                std::size_t looks = 0;
                finder.nearest(query, &looks);
                EXPECT_LE(looks, 20.0 + 8.0 * std::log2(static_cast<double>(n))) << degree << ' ' << n;
            }
        }
}

// Where all distances are equal, or nearly, there is nothing that halving could tell apart.
TEST(Nearest, near_the_center_of_a_circle_every_span_is_looked_at_a_few_times) {
    std::vector<double> more;
    for (int i = 1; i < 400; ++i) more.push_back(i / 401.0);
    for (const Curve& round : {ellipse(1, 1), refine_knots(elevate_degree(ellipse(1, 1), 3).value(), more).value()}) {
        const NearestFinder finder(round);
        const auto spans = static_cast<std::size_t>(segment_count(round.knots()));
        for (const double offset : {0.0, 1e-17, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-9, 1e-6, 1e-3}) {
            std::size_t looks = 0;
            const CurveSample found = finder.nearest({-0.6 * offset, 0.8 * offset}, &looks);
            EXPECT_LE(looks, 40 + 4 * spans) << offset;
            EXPECT_NEAR(distance(found.point, {-0.6 * offset, 0.8 * offset}), 1.0 - offset, 2e-14);
            if (offset == 0.0) {
                EXPECT_EQ(found.u, 0.0);
            }
            // 1 - cos of the angle to the nearest point makes the distance larger by that times the offset.
            if (offset >= 1e-9) {
                EXPECT_LT(distance(found.point, {-0.6, 0.8}), std::sqrt(1e-13 / offset));
            }
        }
    }
}

TEST(Nearest, many_points_of_the_highest_degree_take_a_few_looks) {
    RandomCurves random(75);
    std::vector<Point> points;
    for (int i = 0; i < 1000; ++i) points.emplace_back(0.01 * i, random.number(-1.0, 1.0));
    const Curve curve =
        Curve::make(make_knots(KnotKind::clamped_uniform, max_degree, 1000).value(), std::move(points), {}).value();
    const NearestFinder finder(curve);
    for (int i = 0; i < 20; ++i) {
        const double x = random.number(-1.0, 11.0);
        const Point query(x, random.number(-2.0, 2.0));
        std::size_t looks = 0;
        const double found = distance(finder.nearest(query, &looks).point, query);
        EXPECT_LE(looks, 300U);
        for (int k = 0; k <= 2000; ++k) EXPECT_LE(found, distance(point_at(curve, k / 2000.0), query) + 1e-13);
    }
}

}  // namespace
}  // namespace batten::core
