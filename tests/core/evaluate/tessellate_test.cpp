#include "core/evaluate/tessellate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/curve/knot_kinds.h"
#include "core/evaluate/evaluate.h"
#include "core/refine/degree.h"
#include "tests/core/random_curves.h"

namespace batten::core {
namespace {

using Runs = std::vector<std::vector<CurveSample>>;

const Box everything{{-1e6, -1e6}, {1e6, 1e6}};
const double half_root = std::sqrt(0.5);

Curve circle(double radius, Point center = {0, 0}) {
    const double w = half_root;
    std::vector<Point> points{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
    for (Point& point : points) point = center + radius * vector_to(point);
    return Curve::make({.degree = 2,
                        .knots = {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1},
                        .points = points,
                        .weights = {1, w, 1, w, 1, w, 1, w, 1}})
        .value();
}

std::size_t sample_count(const Runs& runs) {
    std::size_t count = 0;
    for (const auto& run : runs) count += run.size();
    return count;
}

double distance_to_chord(Point p, Point a, Point b) {
    const Vector along = b - a;
    const double length_squared = dot(along, along);
    const double t = length_squared > 0.0 ? std::clamp(dot(p - a, along) / length_squared, 0.0, 1.0) : 0.0;
    return distance(p, a + t * along);
}

// The farthest that the curve between neighboring samples is from their chord, by 11 points in each.
double measured_deviation(const Curve& curve, const std::vector<CurveSample>& run) {
    double largest = 0.0;
    for (std::size_t i = 0; i + 1 < run.size(); ++i)
        for (int k = 1; k < 12; ++k) {
            const double u = run[i].u + (run[i + 1].u - run[i].u) * k / 12.0;
            largest = std::max(largest, distance_to_chord(point_at(curve, u), run[i].point, run[i + 1].point));
        }
    return largest;
}

Curve random_curve_of_degree(RandomCurves& random, int degree, double weight_range) {
    const auto count = static_cast<std::size_t>(degree + 1 + random.whole(0, 6));
    std::vector<Point> points;
    std::vector<double> weights;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = random.number(-8.0, 8.0);
        points.emplace_back(x, random.number(-8.0, 8.0));
        weights.push_back(std::exp(random.number(-1.0, 1.0) * std::log(weight_range)));
    }
    return Curve::make(make_knots(KnotKind::clamped_uniform, degree, count).value(), points, weights).value();
}

TEST(Tessellate, curve_is_within_tolerance_for_every_degree) {
    RandomCurves random(61);
    for (const int degree : {1, 2, 3, 4, 5, 7, 10, 15, 20, 25})
        for (const double tolerance : {0.5, 1e-2, 1e-3})
            for (const double weight_range : {1.0, 10.0, 1000.0}) {
                const Curve curve = random_curve_of_degree(random, degree, weight_range);
                const Runs runs = tessellate(curve, {tolerance, everything, curve.domain()});
                ASSERT_EQ(runs.size(), 1U);
                EXPECT_EQ(runs[0].front().u, curve.domain().lower);
                EXPECT_EQ(runs[0].back().u, curve.domain().upper);
                EXPECT_LE(measured_deviation(curve, runs[0]), tolerance) << degree << " " << weight_range;
            }
}

TEST(Tessellate, every_sort_of_curve_is_within_tolerance) {
    RandomCurves random(62);
    for (int i = 0; i < 200; ++i) {
        const Curve curve = random.curve();
        const Runs runs = tessellate(curve, {1e-3, everything, curve.domain()});
        ASSERT_EQ(runs.size(), 1U);
        EXPECT_LE(measured_deviation(curve, runs[0]), 1e-3);
    }
}

TEST(Tessellate, circle_takes_few_samples) {
    for (const double tolerance : {0.1, 1e-2, 1e-3, 1e-4, 1e-6}) {
        const Runs runs = tessellate(circle(1.0), {tolerance, everything, {0.0, 1.0}});
        const double ideal = M_PI / std::acos(1.0 - tolerance);
        EXPECT_LE(static_cast<double>(sample_count(runs)), 3.0 * ideal + 1.0) << tolerance;
        EXPECT_GE(static_cast<double>(sample_count(runs)), ideal) << tolerance;
    }
}

TEST(Tessellate, samples_ascend_and_are_never_doubled) {
    RandomCurves random(63);
    for (int i = 0; i < 100; ++i) {
        const Curve curve = random.curve();
        for (const auto& run : tessellate(curve, {1e-2, everything, curve.domain()}))
            for (std::size_t k = 0; k + 1 < run.size(); ++k) EXPECT_LT(run[k].u, run[k + 1].u);
    }
}

TEST(Tessellate, samples_are_points_of_the_curve) {
    const Curve curve = circle(3.0);
    const Runs runs = tessellate(curve, {1e-3, everything, {0.0, 1.0}});
    for (const auto& sample : runs[0]) EXPECT_EQ(sample.point, point_at(curve, sample.u));
}

TEST(Tessellate, straight_pieces_have_two_samples) {
    const Curve polyline =
        Curve::make({.degree = 1, .knots = {0, 0, 1, 2, 2}, .points = {{0, 0}, {3, 4}, {5, 1}}}).value();
    EXPECT_EQ(sample_count(tessellate(polyline, {1e-9, everything, {0.0, 2.0}})), 3U);
    const Curve line = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {3, 4}}}).value();
    const Curve raised = elevate_degree(line, 4).value();
    EXPECT_EQ(sample_count(tessellate(raised, {1e-9, everything, {0.0, 1.0}})), 2U);
}

TEST(Tessellate, straight_curve_that_turns_back_is_not_taken_for_its_chord) {
    // C(u) runs along the x axis from 0 to 1.35 and back to 1.
    const Curve curve =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {2, 0}, {1, 0}}}).value();
    const Runs runs = tessellate(curve, {1e-4, everything, {0.0, 1.0}});
    double farthest = 0.0;
    for (const auto& sample : runs[0]) farthest = std::max(farthest, sample.point.x);
    EXPECT_NEAR(farthest, 4.0 / 3.0, 1e-4);
}

TEST(Tessellate, only_the_visible_part_is_sampled) {
    const Curve curve = circle(1.0);
    const Runs all = tessellate(curve, {1e-6, everything, {0.0, 1.0}});
    const Runs part = tessellate(curve, {1e-6, Box{{0.9, -0.1}, {1.1, 0.1}}, {0.0, 1.0}});
    ASSERT_EQ(part.size(), 2U) << "the circle enters at its end and leaves at its beginning";
    EXPECT_LT(sample_count(part), sample_count(all) / 10);
    EXPECT_TRUE(tessellate(curve, {1e-6, Box{{-0.1, -0.1}, {0.1, 0.1}}, {0.0, 1.0}}).empty());
    EXPECT_TRUE(tessellate(curve, {1e-6, Box{}, {0.0, 1.0}}).empty());
}

TEST(Tessellate, what_is_in_the_view_is_never_left_out) {
    RandomCurves random(64);
    for (int i = 0; i < 100; ++i) {
        const Curve curve = random.curve();
        const double u = random.parameter(curve);
        const Point seen = point_at(curve, u);
        const Runs runs =
            tessellate(curve, {1e-4, Box{seen - Vector(0.01, 0.01), seen + Vector(0.01, 0.01)}, curve.domain()});
        double nearest = 1e9;
        for (const auto& run : runs)
            for (std::size_t k = 0; k + 1 < run.size(); ++k)
                nearest = std::min(nearest, distance_to_chord(seen, run[k].point, run[k + 1].point));
        EXPECT_LE(nearest, 1e-4);
    }
}

TEST(Tessellate, range_cuts_inside_a_span) {
    const Curve curve = circle(1.0);
    const Runs runs = tessellate(curve, {1e-4, everything, {0.1, 0.6}});
    ASSERT_EQ(runs.size(), 1U);
    EXPECT_EQ(runs[0].front().u, 0.1);
    EXPECT_EQ(runs[0].back().u, 0.6);
    EXPECT_EQ(runs[0].front().point, point_at(curve, 0.1));
    EXPECT_LE(measured_deviation(curve, runs[0]), 1e-4);
    EXPECT_TRUE(tessellate(curve, {1e-4, everything, {0.3, 0.3}}).empty());
    EXPECT_EQ(sample_count(tessellate(curve, {1e-4, everything, {-5.0, 5.0}})),
              sample_count(tessellate(curve, {1e-4, everything, {0.0, 1.0}})));
}

TEST(Tessellate, tear_begins_a_new_run) {
    const Curve torn = Curve::make({.degree = 2,
                                    .knots = {0, 0, 0, 1, 1, 1, 2, 2, 2},
                                    .points = {{0, 0}, {1, 2}, {2, 0}, {5, 0}, {6, 2}, {7, 0}},
                                    .tears = Tears::allow})
                           .value();
    const Runs runs = tessellate(torn, {1e-2, everything, {0.0, 2.0}});
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_EQ(runs[0].back().point, Point(2, 0));
    EXPECT_EQ(runs[1].front().point, Point(5, 0));
}

TEST(Tessellate, steady_at_a_zoom_of_1e12) {
    const Curve curve = circle(1.0, {3.0, -2.0});
    const double u = 0.1234567;
    const Point seen = point_at(curve, u);
    for (int i = 0; i < 20; ++i) {
        const Vector pan(1e-13 * i, -0.5e-13 * i);
        const Vector reach(1e-12, 1e-12);
        const Runs runs = tessellate(curve, {2.5e-16, Box{seen + pan - reach, seen + pan + reach}, {0.0, 1.0}});
        ASSERT_EQ(runs.size(), 1U);
        EXPECT_LE(sample_count(runs), 20U);
        for (const auto& sample : runs[0]) {
            EXPECT_EQ(sample.point, point_at(curve, sample.u));
            EXPECT_NEAR(distance(sample.point, Point(3.0, -2.0)), 1.0, 1e-15);
            EXPECT_LE(distance(sample.point, seen), 200e-12) << "far samples would lose digits on the screen";
        }
    }
}

TEST(Tessellate, tolerance_below_rounding_ends) {
    const Curve curve = circle(1e-3, {1e3, 1e3});
    EXPECT_LE(sample_count(tessellate(curve, {1e-300, everything, {0.0, 1.0}})), 100'000U);
}

TEST(Tessellate, degenerate_curves_end) {
    const Curve point =
        Curve::make({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {4, Point(2, 3)}}).value();
    EXPECT_EQ(sample_count(tessellate(point, {1e-9, everything, {0.0, 1.0}})), 2U);
    const double tiny = 5e-324;
    const Curve short_domain =
        Curve::make({.degree = 2, .knots = {0, 0, 0, tiny, tiny, tiny}, .points = {{0, 0}, {1, 5}, {2, 0}}}).value();
    EXPECT_GE(sample_count(tessellate(short_domain, {1e-9, everything, short_domain.domain()})), 2U);
    const Curve overflowing = Curve::make({.degree = 3,
                                           .knots = {0, 0, 0, 0, 1, 1, 1, 1},
                                           .points = {{0, 0}, {1e20, 5}, {2, -1e300}, {3, 0}},
                                           .weights = {1e-300, 1e300, 1e10, 1e-300}})
                                  .value();
    EXPECT_LE(sample_count(tessellate(overflowing, {1e-9, everything, {0.0, 1.0}})), 1000U);
    const Curve heavy = Curve::make({.degree = 3,
                                     .knots = {0, 0, 0, 0, 1, 1, 1, 1},
                                     .points = {{0, 0}, {1, 5}, {2, -5}, {3, 0}},
                                     .weights = {1e-6, 1e6, 1e-6, 1e6}})
                            .value();
    const Runs runs = tessellate(heavy, {1e-3, everything, {0.0, 1.0}});
    ASSERT_EQ(runs.size(), 1U);
    EXPECT_LE(measured_deviation(heavy, runs[0]), 1e-3);
}

}  // namespace
}  // namespace batten::core
