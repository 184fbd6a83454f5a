#include "core/edit/redraw.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/curve/knot_kinds.h"
#include "core/evaluate/evaluate.h"
#include "core/make/conics.h"
#include "core/make/interpolate.h"
#include "core/measure/nearest.h"
#include "tests/core/random_curves.h"

namespace batten::core {

namespace {

Curve through(const std::vector<Point>& points, int degree = 3, Ends ends = FreeEnds{}) {
    return interpolate(points, {.degree = degree, .ends = std::move(ends)}).value().curve;
}

// A wave over x from 0 to 100 with 40 control points.
Curve wave(int degree, std::size_t count = 40) {
    std::vector<Point> points;
    for (std::size_t k = 0; k < count; ++k) {
        const double x = 100.0 * static_cast<double>(k) / static_cast<double>(count - 1);
        points.emplace_back(x, 5.0 * std::sin(0.1 * x));
    }
    return Curve::make(make_knots(KnotKind::clamped_uniform, degree, count).value(), points, {}).value();
}

// The curve itself from one parameter to another, which may be beyond the end of a closed one, with a bump on it.
Curve bump(const Curve& curve, double from, double to, double height = 12.0) {
    std::vector<Point> points;
    for (int k = 0; k <= 40; ++k) {
        const double t = k / 40.0;
        const double rise = std::pow(std::sin(std::numbers::pi * t), 3);
        points.push_back(point_at(curve, curve.knots().into_domain(from + t * (to - from))) +
                         Vector{0.0, height * rise});
    }
    return through(points);
}

// The curvature by differences of points alone, from one side of `u`.
double measured_curvature(const Curve& curve, double u, double step) {
    const Point a = point_at(curve, curve.knots().into_domain(u));
    const Point b = point_at(curve, curve.knots().into_domain(u + step));
    const Point c = point_at(curve, curve.knots().into_domain(u + 2.0 * step));
    const double turn = angle_between(b - a, c - b);
    return 2.0 * turn / (distance(a, b) + distance(b, c)) * (step < 0.0 ? -1.0 : 1.0);
}

double jump_of_curvature(const Curve& curve, double u) {
    const double step = 1e-6 * curve.domain().length();
    return std::abs(measured_curvature(curve, u, step) - measured_curvature(curve, u, -step));
}

std::size_t points_that_stay(const Curve& before, const Curve& after) {
    std::size_t count = 0;
    for (const Point& point : before.control_points())
        if (std::ranges::find(after.control_points(), point) != after.control_points().end()) ++count;
    return count;
}

// That the curve outside the part keeps its shape and parameters.
void expect_same_outside(const Curve& before, const Curve& after, double from, double to, double tolerance = 1e-9) {
    const Interval domain = before.domain();
    for (int k = 0; k <= 200; ++k) {
        const double u = domain.lower + domain.length() * k / 200.0;
        if (from - 1e-9 <= u && u <= to + 1e-9) continue;
        EXPECT_LT(distance(point_at(before, u), point_at(after, u)), tolerance) << u;
    }
}

std::vector<std::pair<int, double>> pairs_of(std::initializer_list<int> degrees, std::initializer_list<double> places) {
    std::vector<std::pair<int, double>> pairs;
    for (const int degree : degrees)
        for (const double place : places) pairs.emplace_back(degree, place);
    return pairs;
}

}  // namespace

TEST(Redraw, follows_the_shape_and_joins_it_with_curvature) {
    for (const int degree : {3, 4, 5}) {
        const Curve curve = wave(degree);
        const double from = 0.31;
        const double to = 0.62;
        const Curve shape = bump(curve, from, to);
        const auto redrawn = redraw(curve, shape, 0.1);
        ASSERT_TRUE(redrawn);
        EXPECT_LE(redrawn->error, 0.1);
        const Curve& after = redrawn->curve;
        EXPECT_EQ(after.degree(), degree);
        EXPECT_EQ(after.domain(), curve.domain());
        expect_same_outside(curve, after, from, to);
        for (int k = 0; k <= 50; ++k) {
            const Point point = point_at(shape, k / 50.0);
            EXPECT_LT(distance(nearest_point(after, point).point, point), 0.3) << degree << " " << k;
        }
        // That of the wave is at most 0.05.
        EXPECT_LT(jump_of_curvature(after, from), 2e-3) << degree;
        EXPECT_LT(jump_of_curvature(after, to), 2e-3) << degree;
        EXPECT_GE(points_that_stay(curve, after), 20U);
    }
}

TEST(Redraw, does_not_depend_on_the_direction_of_the_shape) {
    const Curve curve = wave(3);
    const Curve there = redraw(curve, bump(curve, 0.25, 0.5), 0.1).value().curve;
    const Curve back = redraw(curve, bump(curve, 0.5, 0.25), 0.1).value().curve;
    ASSERT_EQ(there.control_points().size(), back.control_points().size());
    for (int k = 0; k <= 40; ++k) EXPECT_LT(distance(point_at(there, k / 40.0), point_at(back, k / 40.0)), 0.05);
}

TEST(Redraw, keeps_every_bit_outside) {
    const Curve curve = wave(3, 10000);
    const auto redrawn = redraw(curve, bump(curve, 0.5, 0.6, 3.0), 0.05);
    ASSERT_TRUE(redrawn);
    const auto before = curve.control_points();
    const auto after = redrawn->curve.control_points();
    EXPECT_TRUE(std::ranges::equal(before.first(4990), after.first(4990)));
    EXPECT_TRUE(std::ranges::equal(before.last(3990), after.last(3990)));
    EXPECT_TRUE(std::ranges::equal(curve.knots().values().first(4990), redrawn->curve.knots().values().first(4990)));
    EXPECT_TRUE(std::ranges::equal(curve.knots().values().last(3990), redrawn->curve.knots().values().last(3990)));
    EXPECT_LT(after.size(), 9100U);
}

TEST(Redraw, joins_a_rational_curve) {
    CurveDefinition definition = wave(3).definition();
    RandomCurves random(3);
    definition.weights.resize(definition.points.size());
    for (double& weight : definition.weights) weight = random.number(0.5, 2.0);
    const Curve curve = Curve::make(definition).value();
    const auto redrawn = redraw(curve, bump(curve, 0.3, 0.6), 0.1);
    ASSERT_TRUE(redrawn);
    EXPECT_LE(redrawn->error, 0.2);
    expect_same_outside(curve, redrawn->curve, 0.3, 0.6);
    EXPECT_LT(jump_of_curvature(redrawn->curve, 0.3), 3e-3);
    EXPECT_LT(jump_of_curvature(redrawn->curve, 0.6), 3e-3);
    EXPECT_EQ(redrawn->curve.weights().front(), curve.weights().front());
    EXPECT_EQ(redrawn->curve.weights().back(), curve.weights().back());
}

TEST(Redraw, replaces_the_nearer_part_of_a_closed_curve_also_through_the_seam) {
    std::vector<Point> points;
    for (int k = 0; k < 40; ++k)
        points.emplace_back(50.0 * std::cos(k * std::numbers::pi / 20), 50.0 * std::sin(k * std::numbers::pi / 20));
    // From degree 4 on the seam that is moved is a multiple knot.
    for (const auto& [degree, middle] : pairs_of({3, 4, 5, 7}, {0.5, 0.02, 0.98, 0.0})) {
        SCOPED_TRACE(testing::Message() << degree << " " << middle);
        const Curve ring = Curve::make(make_knots(KnotKind::periodic, degree, 40).value(), points, {}).value();
        const double period = ring.domain().length();
        const double lower = ring.domain().lower;
        const auto at = [&](double share) { return point_at(ring, lower + period * (share - std::floor(share))); };
        const Point from = at(middle - 0.1);
        const Point to = at(middle + 0.1);
        const double first = lower + period * (middle - 0.1 < 0.0 ? middle + 0.9 : middle - 0.1);
        const Curve shape = bump(ring, first, first + 0.2 * period, -8.0);
        const auto redrawn = redraw(ring, shape, 0.1);
        ASSERT_TRUE(redrawn);
        const Curve& after = redrawn->curve;
        EXPECT_TRUE(after.is_periodic());
        EXPECT_LE(redrawn->error, 0.15);
        EXPECT_NEAR(after.domain().length(), period, 1e-12 * period);
        // The rest stays a circle; the middle of the part is where the bow is.
        for (int k = 0; k <= 60; ++k) {
            const Point point = at(middle + 0.12 + 0.76 * k / 60.0);
            EXPECT_LT(distance(nearest_point(after, point).point, point), 1e-6);
        }
        EXPECT_LT(distance(nearest_point(after, point_at(shape, 0.5)).point, point_at(shape, 0.5)), 0.3);
        for (const Point& joint : {from, to}) EXPECT_LT(jump_of_curvature(after, nearest_point(after, joint).u), 2e-3);
        EXPECT_GE(points_that_stay(ring, after), 24U);
    }
}

TEST(Redraw, takes_an_end_of_the_curve_along) {
    const Curve curve = wave(3);
    const Point from = point_at(curve, 0.7);
    const Curve shape = through({from, from + Vector{10, 6}, from + Vector{20, 6}, from + Vector{42, -10}});
    // The shape ends beyond the end of the curve.
    const auto redrawn = redraw(curve, shape, 0.1);
    ASSERT_TRUE(redrawn);
    EXPECT_LT(distance(redrawn->curve.control_points().back(), point_at(shape, 1.0)), 0.2);
    expect_same_outside(curve, redrawn->curve, 0.7, 1.0);
}

TEST(Redraw, leads_from_the_curve_to_a_shape_beside_it) {
    const Curve curve = wave(3);
    CurveDefinition lifted = bump(curve, 0.3, 0.6).definition();
    for (Point& point : lifted.points) point += Vector{0.0, 1.5};
    const Curve shape = Curve::make(lifted).value();
    const auto redrawn = redraw(curve, shape, 0.1);
    ASSERT_TRUE(redrawn);
    EXPECT_LT(jump_of_curvature(redrawn->curve, nearest_point(curve, point_at(shape, 0.0)).u), 3e-3);
    for (int k = 8; k <= 12; ++k) {
        const Point point = point_at(shape, k / 20.0);
        EXPECT_LT(distance(nearest_point(redrawn->curve, point).point, point), 1.0);
    }
}

TEST(Redraw, takes_every_degree_and_place) {
    for (const int degree : {1, 2, 7, 25}) {
        const Curve curve = wave(degree, 60);
        const auto redrawn = redraw(curve, bump(curve, 0.3, 0.6, 6.0), 0.2);
        ASSERT_TRUE(redrawn) << degree;
        // In high degrees what stays is described by knots far from it.
        expect_same_outside(curve, redrawn->curve, 0.3, 0.6, degree == 25 ? 1e-5 : 1e-9);
        EXPECT_LT(redrawn->error, 1.0) << degree;
    }
    CurveDefinition far = wave(3).definition();
    for (Point& point : far.points) point += Vector{1e6, -1e6};
    const Curve curve = Curve::make(far).value();
    const auto redrawn = redraw(curve, bump(curve, 0.3, 0.6), 0.1);
    ASSERT_TRUE(redrawn);
    EXPECT_LE(redrawn->error, 0.1);
}

TEST(Redraw, refuses_in_a_written_order) {
    const Curve curve = wave(3);
    const Curve dot = through({{-50, 0}, {-52, 1}, {-55, 0}, {-60, 0}});
    EXPECT_EQ(redraw(curve, dot, 0.0).error().code, CurveErrorCode::tolerance_not_positive);
    EXPECT_EQ(redraw(curve, dot, 0.1).error().code, CurveErrorCode::range_empty);
}

}  // namespace batten::core
