#include "core/edit/fair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/curve/knot_analysis.h"
#include "core/evaluate/evaluate.h"
#include "core/make/conics.h"
#include "core/measure/deviation.h"
#include "core/measure/geometric_distance.h"
#include "core/refine/degree.h"
#include "core/refine/periodic.h"
#include "tests/core/random_curves.h"
#include "tests/core/smooth_shapes.h"

namespace batten::core {

namespace {

// The integral of |C'''|^2 by the midpoint rule.
double variation(const Curve& curve) {
    const auto knots = curve.knots().values();
    const Interval domain = curve.domain();
    double sum = 0.0;
    for (std::size_t s = 0; s + 1 < knots.size(); ++s) {
        if (knots[s] < domain.lower || knots[s + 1] > domain.upper) continue;
        const double step = (knots[s + 1] - knots[s]) / 200.0;
        for (int k = 0; k < 200 && step > 0.0; ++k) {
            const Vector third = derivatives_at(curve, knots[s] + (k + 0.5) * step, 3)[3];
            sum += step * dot(third, third);
        }
    }
    return sum;
}

Curve bumpy(bool periodic, bool rational, bool clamped = true) {
    CurveDefinition definition{.degree = 3, .knots = {}, .points = {}, .periodic = periodic};
    const int n = 16;
    for (int i = 0; i < n; ++i) {
        const double angle = 6.0 * i / n;
        const double radius = 10.0 + (i == 6 ? 0.8 : 0.0) - (i == 11 ? 0.5 : 0.0);
        definition.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
        definition.weights.push_back(rational ? 1.0 + 0.2 * (i % 3) : 1.0);
    }
    for (int i = 0; i < (periodic ? n + 1 : n + 4); ++i) {
        const int inner = std::min(std::max(i, 3), n);
        definition.knots.push_back(periodic || !clamped ? i : inner);
    }
    return Curve::make(std::move(definition)).value();
}

}  // namespace

TEST(Fair, varies_less_within_the_distance_and_uses_it) {
    for (const bool periodic : {false, true})
        for (const bool rational : {false, true}) {
            const Curve curve = bumpy(periodic, rational);
            double before = variation(curve);
            for (const double distance : {1e-6, 0.05, 0.3}) {
                const auto result = fair(curve, distance).value();
                EXPECT_LE(result.error, distance);
                EXPECT_GT(result.error, 0.9 * distance);
                EXPECT_EQ(result.error, geometric_distance(curve, result.curve));
                const double now = variation(result.curve);
                EXPECT_LT(now, before);
                before = now;
                EXPECT_EQ(result.curve.knots(), curve.knots());
                EXPECT_TRUE(std::ranges::equal(result.curve.weights(), curve.weights()));
            }
            EXPECT_LT(before, 0.75 * variation(curve));
        }
}

TEST(Fair, ends_stay) {
    const Curve clamped = bumpy(false, true);
    const Curve faired = fair(clamped, 0.2).value().curve;
    EXPECT_EQ(faired.control_points().front(), clamped.control_points().front());
    EXPECT_EQ(faired.control_points().back(), clamped.control_points().back());
    const Curve open = bumpy(false, false, false);
    const auto result = fair(open, 0.2).value();
    for (const double u : {open.domain().lower, open.domain().upper})
        EXPECT_LT(distance(point_at(open, u), point_at(result.curve, u)), 1e-13);
    EXPECT_LT(variation(result.curve), 0.5 * variation(open));
}

TEST(Fair, does_the_same_far_from_the_origin_and_over_any_domain) {
    const Curve curve = bumpy(false, true);
    const Curve expected = fair(curve, 0.1).value().curve;
    for (const double scale : {1e-9, 1.0, 1e9}) {
        CurveDefinition definition = curve.definition();
        for (double& knot : definition.knots) knot *= scale;
        for (Point& point : definition.points) point += Vector(1e6, -1e6);
        const auto result = fair(Curve::make(std::move(definition)).value(), 0.1).value();
        EXPECT_LE(result.error, 0.1);
        for (std::size_t i = 0; i < expected.control_points().size(); ++i)
            EXPECT_LT(distance(result.curve.control_points()[i], expected.control_points()[i] + Vector(1e6, -1e6)),
                      1e-4);
    }
}

// With no limit a cubic without inner knots becomes a parabola: P3 - 3 P2 + 3 P1 - P0 = 0.
TEST(Fair, a_cubic_piece_becomes_a_parabola_where_it_may) {
    const Curve curve =
        Curve::make({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{0, 0}, {1, 3}, {2, -3}, {4, 1}}})
            .value();
    const Curve faired = fair(curve, 100.0).value().curve;
    const auto points = faired.control_points();
    const Vector third = (points[3] - points[0]) - 3.0 * (points[2] - points[1]);
    EXPECT_LT(length(third), 1e-11);
}

// On a line only the speed changes: as a shape the curve stays.
TEST(Fair, the_distance_is_that_of_the_shape) {
    const Curve curve =
        Curve::make({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{0, 0}, {1, 2}, {5, 10}, {6, 12}}})
            .value();
    const auto result = fair(curve, 0.01).value();
    const auto points = result.curve.control_points();
    EXPECT_LT(length((points[3] - points[0]) - 3.0 * (points[2] - points[1])), 1e-11);
    EXPECT_LE(result.error, 0.01);
    EXPECT_GT(largest_deviation(curve, result.curve), 0.1);
}

TEST(Fair, low_degrees_have_smaller_jumps) {
    for (const int degree : {1, 2}) {
        CurveDefinition definition{.degree = degree, .knots = {}, .points = {}};
        for (int i = 0; i < 10; ++i) definition.points.emplace_back(i, i % 2 == 0 ? 0.0 : 0.3);
        for (int i = 0; i < 10 + degree + 1; ++i) definition.knots.push_back(std::min(std::max(i, degree), 10));
        const Curve curve = Curve::make(std::move(definition)).value();
        const auto result = fair(curve, 0.1).value();
        EXPECT_LE(result.error, 0.1);
        EXPECT_GT(result.error, 0.09);
        double before = 0.0;
        double after = 0.0;
        for (int k = degree + 1; k < 10; ++k)
            for (const auto& [c, sum] : {std::pair{&curve, &before}, std::pair{&result.curve, &after}}) {
                const auto r = static_cast<std::size_t>(degree);
                const Vector jump =
                    derivatives_at(*c, k, degree, Side::right)[r] - derivatives_at(*c, k, degree, Side::left)[r];
                *sum += dot(jump, jump);
            }
        EXPECT_LT(after, 0.6 * before);
    }
}

TEST(Fair, stays_within_the_distance_on_any_curve) {
    RandomCurves random(111);
    for (int trial = 0; trial < 20; ++trial) {
        const Curve curve = random.curve();
        const auto result = fair(curve, 0.05);
        ASSERT_TRUE(result);
        EXPECT_LE(result->error, 0.05);
        EXPECT_EQ(result->error, geometric_distance(curve, result->curve));
    }
    EXPECT_EQ(fair(random.curve(), 0.0).error().code, CurveErrorCode::tolerance_not_positive);
}

TEST(Fair, keeps_the_smoothness_of_the_shape) {
    RandomCurves random(395);
    for (const int degree : {2, 3, 4, 6})
        for (int k = 0; k < 5; ++k) {
            const Curve curve = smooth_by_shape(degree, 4, random);
            ASSERT_EQ(joint_continuity(curve).front().parametric, 0);
            ASSERT_EQ(joint_continuity(curve).front().geometric, std::min(degree - 1, 2));
            for (const double distance : {1e-3, 0.3}) {
                const auto faired = fair(curve, distance).value();
                EXPECT_GT(faired.error, 0.5 * distance);
                EXPECT_TRUE(smoothness_losses(curve, faired.curve).empty()) << degree;
            }
        }
}

TEST(Fair, keeps_a_closed_curve_smooth_at_its_ends) {
    const Curve round = circle({0, 0}, 1000.0).value();
    const auto result = fair(round, 10.0).value();
    EXPECT_GT(result.error, 9.0);
    const JointContinuity ends = continuity_of_ends(result.curve);
    EXPECT_EQ(ends.position.size, 0.0);
    EXPECT_LE(std::abs(ends.angle.value()), 1e-12);
    const Curve ring = bumpy(true, true);
    for (const Curve& curve : {to_clamped(ring).value(), to_wrapped(ring, 1e-9).value().curve}) {
        const auto faired = fair(curve, 0.3).value();
        EXPECT_GT(faired.error, 0.25);
        EXPECT_EQ(continuity_of_ends(faired.curve).geometric, 2);
        EXPECT_TRUE(smoothness_losses(curve, faired.curve).empty());
    }
}

TEST(Fair, keeps_the_smoothness_across_a_seam) {
    // A circle of 9 points, closed without a seam: G2 at triple knots.
    const Curve ring = elevate_degree(to_periodic(circle({1, 2}, 3.0).value(), 1e-9).value().curve, 1).value();
    const auto faired = fair(ring, 0.2).value();
    EXPECT_GT(faired.error, 0.0);
    EXPECT_TRUE(smoothness_losses(ring, faired.curve).empty());
}

// A quarter of the control points moves, whose Greville abscissae lie in the part.
TEST(FairPart, moves_what_lies_in_the_part_alone) {
    for (const bool periodic : {false, true})
        for (const bool rational : {false, true}) {
            const Curve curve = bumpy(periodic, rational);
            const Interval part{4.5, 8.5};
            const auto result = fair_part(curve, part, 0.3).value();
            EXPECT_LE(result.error, 0.3);
            EXPECT_LT(variation(result.curve), variation(curve));
            EXPECT_EQ(result.curve.knots(), curve.knots());
            std::size_t moved = 0;
            for (std::size_t i = 0; i < curve.control_points().size(); ++i) {
                const double place = greville_abscissa(curve.knots(), i);
                const bool is_inside = part.contains(place);
                EXPECT_EQ(result.curve.control_points()[i] != curve.control_points()[i], is_inside) << i;
                moved += is_inside ? 1 : 0;
            }
            EXPECT_EQ(moved, 4u);
        }
}

// Its ends are made by three points each, of which the first may be pinned, or outside of the part.
TEST(FairPart, moves_nothing_else_at_ends_that_no_point_makes_alone) {
    for (const bool rational : {false, true}) {
        const Curve curve = bumpy(false, rational, false);
        const Interval domain = curve.domain();
        const Interval part{3.5, 9.5};
        const Curve found = fair_part(curve, part, 0.3).value().curve;
        for (std::size_t i = 0; i < 16; ++i)
            EXPECT_EQ(found.control_points()[i] != curve.control_points()[i],
                      part.contains(greville_abscissa(curve.knots(), i)))
                << i;
        const std::vector<std::size_t> pinned{0, 7, 15};
        const Curve held = fair(curve, 0.3, {}, pinned).value().curve;
        for (std::size_t i = 0; i < 16; ++i)
            EXPECT_EQ(held.control_points()[i] == curve.control_points()[i], std::ranges::binary_search(pinned, i))
                << i;
        for (const Curve* one : {&found, &held})
            for (const double end : {domain.lower, domain.upper})
                EXPECT_LT(distance(point_at(*one, end), point_at(curve, end)), 1e-12);
    }
}

TEST(FairPart, goes_over_the_seam_of_a_periodic_curve) {
    const Curve curve = bumpy(true, false);
    const Curve found = fair_part(curve, {14.5, 18.5}, 0.3).value().curve;
    for (std::size_t i = 0; i < 16; ++i) {
        double place = greville_abscissa(curve.knots(), i);
        if (place < 10.0) place += 16.0;
        EXPECT_EQ(found.control_points()[i] != curve.control_points()[i], 14.5 <= place && place <= 18.5) << i;
    }
}

TEST(FairPart, a_part_without_control_points_changes_nothing_and_none_is_refused) {
    const Curve curve = bumpy(false, false);
    EXPECT_EQ(fair_part(curve, {8.05, 8.1}, 0.1).value().curve, curve);
    EXPECT_EQ(fair_part(curve, {8.0, 8.0}, 0.1).error().code, CurveErrorCode::range_empty);
    EXPECT_EQ(fair_part(curve, {7.0, 9.0}, 0.0).error().code, CurveErrorCode::tolerance_not_positive);
}

TEST(FairPart, a_part_that_is_not_there_is_refused) {
    const auto refused = fair_part(bumpy(false, false), {12.0, 17.0}, 0.1);
    EXPECT_EQ(refused.error().code, CurveErrorCode::parameter_outside_domain);
    EXPECT_EQ(refused.error().value, 17.0);
    EXPECT_EQ(refused.error().upper, 16.0);
    EXPECT_EQ(fair_part(bumpy(false, false), {2.0, 9.0}, 0.1).error().value, 2.0);
    EXPECT_TRUE(fair_part(bumpy(true, false), {12.0, 32.0}, 0.1));
    EXPECT_EQ(fair_part(bumpy(true, false), {12.0, 33.0}, 0.1).error().value, 33.0);
}

TEST(FairPart, all_of_a_curve_is_a_part) {
    const Curve curve = bumpy(false, true);
    const Curve whole = fair(curve, 0.1).value().curve;
    const Curve part = fair_part(curve, curve.domain(), 0.1).value().curve;
    for (std::size_t i = 0; i < whole.control_points().size(); ++i)
        EXPECT_LT(distance(whole.control_points()[i], part.control_points()[i]), 1e-9);
}

}  // namespace batten::core
