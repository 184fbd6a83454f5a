#include "core/refine/periodic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/curve/knot_analysis.h"
#include "core/evaluate/evaluate.h"
#include "core/make/conics.h"
#include "core/measure/closing.h"
#include "core/measure/deviation.h"
#include "tests/core/random_curves.h"
#include "tests/core/reference.h"

namespace batten::core {

namespace {

// The largest relative distance at equal parameters, which `b` may have one period later.
double difference(const Curve& a, const Curve& b, RandomCurves& random) {
    double worst = 0.0;
    for (int k = 0; k < 30; ++k) {
        const double u = random.parameter(a);
        const double period = b.domain().length();
        const double there = u < b.domain().lower ? u + period : u > b.domain().upper ? u - period : u;
        worst = std::max(worst, reference::relative_distance(a, point_at(a, u), point_at(b, there)));
    }
    return worst;
}

}  // namespace

TEST(Periodic, opens_every_periodic_curve_clamped) {
    RandomCurves random(331);
    for (int k = 0; k < 300; ++k) {
        const Curve curve = random.periodic_curve();
        const auto clamped = to_clamped(curve);
        ASSERT_TRUE(clamped) << describe(clamped.error());
        EXPECT_TRUE(is_clamped(clamped->knots()));
        EXPECT_EQ(clamped->domain(), curve.domain());
        EXPECT_EQ(clamped->control_points().front(), clamped->control_points().back());
        EXPECT_EQ(clamped->weights().front(), clamped->weights().back());
        EXPECT_EQ(clamped->control_points().size(),
                  curve.control_points().size() + 1 +
                      static_cast<std::size_t>(curve.degree() - curve.knots().multiplicity(curve.domain().lower)));
        EXPECT_LE(difference(curve, *clamped, random), 1e-14) << k;
    }
}

TEST(Periodic, clamps_every_open_curve) {
    RandomCurves random(332);
    for (int k = 0; k < 300; ++k) {
        const Curve curve = random.open_curve();
        const auto clamped = to_clamped(curve);
        ASSERT_TRUE(clamped) << describe(clamped.error());
        EXPECT_TRUE(is_clamped(clamped->knots()));
        EXPECT_EQ(clamped->domain(), curve.domain());
        EXPECT_LE(difference(curve, *clamped, random), 1e-14) << k;
        if (is_clamped(curve.knots())) {
            EXPECT_EQ(*clamped, curve);
        }
    }
}

TEST(Periodic, wraps_with_points_that_are_bit_equal_and_back) {
    RandomCurves random(333);
    for (int k = 0; k < 300; ++k) {
        const Curve curve = random.periodic_curve();
        const Curve wrapped = to_wrapped(curve, 1e-9)->curve;
        const std::size_t n = curve.control_points().size();
        const auto p = static_cast<std::size_t>(curve.degree());
        ASSERT_EQ(wrapped.control_points().size(), n + p);
        for (std::size_t i = 0; i < n + p; ++i) {
            EXPECT_EQ(wrapped.control_points()[i], curve.control_points()[i % n]);
            EXPECT_EQ(wrapped.weights()[i], curve.weights()[i % n]);
        }
        EXPECT_TRUE(std::ranges::equal(wrapped.knots().values(), curve.knots().values()));
        EXPECT_LE(difference(curve, wrapped, random), 1e-15) << k;
        const Approximation again = to_periodic(wrapped, 1e-9).value();
        EXPECT_EQ(again.curve, curve) << k;
        EXPECT_LE(again.error, 1e-13);
    }
}

TEST(Periodic, closes_a_curve_whose_ends_meet) {
    RandomCurves random(334);
    for (int k = 0; k < 300; ++k) {
        const Curve periodic = random.periodic_curve();
        const Curve clamped = to_clamped(periodic).value();
        const auto closed = to_periodic(clamped, 1e-9);
        ASSERT_TRUE(closed) << describe(closed.error());
        EXPECT_TRUE(closed->curve.is_periodic());
        EXPECT_LE(closed->error, 1e-9);
        EXPECT_LE(difference(clamped, closed->curve, random), 1e-10) << k;
    }
}

TEST(Periodic, seam_is_as_smooth_by_its_knots_as_the_curve_is) {
    RandomCurves random(338);
    for (int k = 0; k < 300; ++k) {
        const Curve periodic = random.periodic_curve();
        const double seam = periodic.domain().lower;
        const Approximation closed = to_periodic(to_clamped(periodic).value(), 1e-9).value();
        EXPECT_LE(closed.curve.knots().multiplicity(seam), periodic.knots().multiplicity(seam)) << k;
        if (closed.curve.control_points().size() != periodic.control_points().size()) continue;
        for (std::size_t i = 0; i < periodic.control_points().size(); ++i) {
            // The seam may be named at the other end of the period, which turns the points.
            double nearest = std::numeric_limits<double>::infinity();
            for (const Point& point : closed.curve.control_points())
                nearest = std::min(nearest, distance(point, periodic.control_points()[i]));
            EXPECT_LE(nearest, 1e-8) << k;
        }
    }
    // A corner stays one.
    const auto drop =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 2, 2, 2}, .points = {{0, 0}, {2, 1}, {-2, 1}, {0, 0}}}).value();
    EXPECT_EQ(to_periodic(drop, 1e-9)->curve.knots().multiplicity(0.0), 2);
    // Nearly smooth: (0.01, 0) off the line of the neighbors, which a tolerance of 0.01 forgives.
    const auto nearly =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 2, 2, 2}, .points = {{0, 0}, {2, 1}, {-2, -0.99}, {0, 0}}})
            .value();
    EXPECT_EQ(to_periodic(nearly, 1e-3)->curve.knots().multiplicity(0.0), 2);
    const Approximation smooth = to_periodic(nearly, 0.01).value();
    EXPECT_EQ(smooth.curve.knots().multiplicity(0.0), 1);
    EXPECT_GT(smooth.error, 1e-3);
    EXPECT_LE(smooth.error, 0.005);
}

TEST(Periodic, closes_a_rational_curve_with_different_end_weights) {
    // A drop of three weights; the shape is compared by nearest parameters, since the parameter changes.
    const auto drop = Curve::make({.degree = 3,
                                   .knots = {0, 0, 0, 0, 1, 2, 2, 2, 2},
                                   .points = {{0, 0}, {3, 1}, {0, 4}, {-3, 1}, {0, 0}},
                                   .weights = {1, 2, 1, 1, 8}})
                          .value();
    const Approximation closed = to_periodic(drop, 1e-9).value();
    EXPECT_EQ(closed.curve.domain(), drop.domain());
    EXPECT_LE(closed.error, 1e-14);
    // c = 8^(1/3) = 2: s = t / (t + 2 (1 - t)) in halves of the domain.
    for (int k = 0; k <= 40; ++k) {
        const double t = k / 40.0;
        const double s = t / (t + 2.0 * (1.0 - t));
        EXPECT_LE(distance(point_at(closed.curve, 2.0 * t), point_at(drop, 2.0 * s)), 4e-15) << t;
    }
}

TEST(Periodic, moves_the_seam_of_every_periodic_curve) {
    RandomCurves random(335);
    for (int k = 0; k < 300; ++k) {
        const Curve curve = random.periodic_curve();
        const double u = random.parameter(curve);
        const auto moved = move_seam(curve, u, 1e-9);
        ASSERT_TRUE(moved) << describe(moved.error());
        const bool was_knot = curve.knots().multiplicity(u) > 0;
        EXPECT_EQ(moved->curve.control_points().size(), curve.control_points().size() + (was_knot ? 0 : 1));
        EXPECT_TRUE(moved->curve.is_periodic());
        EXPECT_EQ(moved->error, 0.0);
        const bool is_seam = u == curve.domain().lower || u == curve.domain().upper;
        EXPECT_EQ(moved->curve.domain().lower, is_seam ? curve.domain().lower : u);
        EXPECT_LE(difference(curve, moved->curve, random), 5e-14) << k;
    }
}

TEST(Periodic, rotates_points_without_a_change_of_a_bit) {
    const auto curve =
        Curve::make(
            {.degree = 3, .knots = {0, 1, 2, 3, 4}, .points = {{0, 0}, {4, 0}, {4, 4}, {0, 5}}, .periodic = true})
            .value();
    const Curve moved = move_seam(curve, 1.0, 1e-9)->curve;
    EXPECT_TRUE(std::ranges::equal(moved.control_points(), std::vector<Point>{{4, 0}, {4, 4}, {0, 5}, {0, 0}}));
    EXPECT_TRUE(std::ranges::equal(moved.knots().stored(), std::vector<double>{1, 2, 3, 4, 5}));
    EXPECT_EQ(point_at(moved, 2.25), point_at(curve, 2.25));
}

TEST(Periodic, moves_the_seam_of_closed_open_curves) {
    RandomCurves random(336);
    for (int k = 0; k < 200; ++k) {
        const Curve periodic = random.periodic_curve();
        const Curve curve = k % 2 == 0 ? to_clamped(periodic).value() : to_wrapped(periodic, 1e-9)->curve;
        const double u = random.parameter(curve);
        const auto moved = move_seam(curve, u, 1e-9);
        ASSERT_TRUE(moved) << describe(moved.error());
        EXPECT_EQ(closing_of(moved->curve).closing, closing_of(curve).closing) << k;
        EXPECT_LE(moved->error, 1e-13);
        EXPECT_LE(difference(curve, moved->curve, random), 2e-14) << k;
    }
    const Curve ring = circle({0, 0}, 1.0).value();
    const Curve turned = move_seam(ring, 0.25, 1e-9)->curve;
    EXPECT_TRUE(is_clamped(turned.knots()));
    EXPECT_EQ(turned.control_points().front(), Point(0, 1));
    EXPECT_EQ(turned.control_points().back(), Point(0, 1));
    EXPECT_EQ(turned.control_points().size(), 9u);
}

TEST(Periodic, refuses_open_curves_and_bad_numbers) {
    using Code = CurveErrorCode;
    const auto arc = circular_arc({0, 0}, 1.0, {0, 180}).value();
    EXPECT_EQ(to_periodic(arc, 0.5).error(), (CurveError{.code = Code::ends_apart, .value = 2, .upper = 0.5}));
    EXPECT_EQ(to_wrapped(arc, 0.5).error().code, Code::ends_apart);
    EXPECT_EQ(move_seam(arc, 0.5, 0.5).error().code, Code::ends_apart);
    const auto ring = circle({0, 0}, 1.0).value();
    EXPECT_EQ(to_periodic(ring, 0.0).error().code, Code::tolerance_not_positive);
    EXPECT_EQ(move_seam(ring, 1.5, 1e-9).error().code, Code::parameter_outside_domain);
    EXPECT_EQ(move_seam(ring, std::nan(""), 1e-9).error().code, Code::parameter_not_finite);
}

TEST(Periodic, tells_the_gap_of_ends_as_far_apart_as_doubles_reach) {
    using Code = CurveErrorCode;
    const auto with_ends_at = [](double x) {
        return Curve::make({.degree = 1, .knots = {0, 0, 1, 2, 2}, .points = {{-x, 0}, {0, 1}, {x, 0}}}).value();
    };
    EXPECT_EQ(to_periodic(with_ends_at(1e300), 1.0).error(),
              (CurveError{.code = Code::ends_apart, .value = 2e300, .upper = 1.0}));
    EXPECT_EQ(to_periodic(with_ends_at(1.5e308), 1.0).error().code, Code::not_computable);
    EXPECT_EQ(to_wrapped(with_ends_at(1.5e308), 1.0).error().code, Code::not_computable);
    EXPECT_EQ(move_seam(with_ends_at(1.5e308), 0.5, 1.0).error().code, Code::not_computable);
}

TEST(Periodic, works_far_away_and_on_tiny_and_huge_domains) {
    RandomCurves random(337);
    for (int k = 0; k < 100; ++k) {
        CurveDefinition definition = random.periodic_curve().definition();
        const double scale = k % 2 == 0 ? 1e-9 : 1e9;
        for (double& knot : definition.knots) knot *= scale;
        for (Point& point : definition.points) point += Vector(1e6, -1e6);
        const Curve curve = Curve::make(std::move(definition)).value();
        const Curve clamped = to_clamped(curve).value();
        EXPECT_LE(difference(curve, clamped, random), 1e-14) << k;
        const auto closed = to_periodic(clamped, 1e-6);
        ASSERT_TRUE(closed) << describe(closed.error());
        EXPECT_LE(difference(curve, closed->curve, random), 1e-12) << k;
        const auto moved = move_seam(clamped, random.parameter(curve), 1e-6);
        ASSERT_TRUE(moved) << describe(moved.error());
        EXPECT_LE(difference(curve, moved->curve, random), 1e-14) << k;
    }
}

}  // namespace batten::core
