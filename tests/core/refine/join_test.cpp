#include "core/refine/join.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/curve/knot_analysis.h"
#include "core/refine/bezier_form.h"
#include "core/refine/split.h"
#include "tests/core/shape_check.h"

namespace batten::core {
namespace {

constexpr JoinContinuity all[]{JoinContinuity::c0, JoinContinuity::c1, JoinContinuity::c2, JoinContinuity::g1,
                               JoinContinuity::g2};

int order_of(JoinContinuity continuity) {
    if (continuity == JoinContinuity::c0) return 0;
    return continuity == JoinContinuity::c1 || continuity == JoinContinuity::g1 ? 1 : 2;
}

bool is_geometric(JoinContinuity continuity) {
    return continuity == JoinContinuity::g1 || continuity == JoinContinuity::g2;
}

// How far derivatives (C) or direction and curvature (G) differ on both sides of the joint.
double jump_at(const Curve& curve, double u, JoinContinuity continuity) {
    const int order = order_of(continuity);
    const auto before = derivatives_at(curve, u, 2, Side::left);
    const auto after = derivatives_at(curve, u, 2, Side::right);
    double jump = distance(before.point, after.point);
    if (!is_geometric(continuity)) {
        for (std::size_t r = 1; r <= static_cast<std::size_t>(order); ++r)
            jump = std::max(jump, length(before[r] - after[r]) / std::max(1.0, length(before[r])));
        return jump;
    }
    jump = std::max(jump, length(before[1] / length(before[1]) - after[1] / length(after[1])));
    if (order < 2) return jump;
    const double left = curvature_at(curve, u, Side::left).value();
    const double right = curvature_at(curve, u, Side::right).value();
    return std::max(jump, std::abs(left - right) / std::max(1.0, std::abs(left)));
}

TEST(Join, has_the_continuity_asked_for) {
    RandomCurves random(371);
    for (int k = 0; k < 200; ++k) {
        const Curve first = random.open_curve();
        const Curve second = random.open_curve();
        for (const JoinContinuity continuity : all) {
            const auto joined = join(first, second, continuity);
            ASSERT_TRUE(joined) << describe(joined.error());
            const double joint = first.domain().upper;
            EXPECT_LE(jump_at(joined->curve, joint, continuity), 1e-9);
            EXPECT_EQ(joined->curve.domain().lower, first.domain().lower);
            EXPECT_NEAR(joined->curve.domain().upper, joint + second.domain().length(), 1e-13);
            // The first one keeps its shape and the second one its end.
            const auto part = sub_curve(joined->curve, first.domain().lower, joint).value();
            EXPECT_LE(shape_change(first, part, random), 1e-11);
            EXPECT_LE(distance(point_at(joined->curve, joined->curve.domain().upper),
                               point_at(second, second.domain().upper)),
                      1e-9);
        }
    }
}

TEST(Join, moves_no_more_points_than_the_continuity_needs) {
    RandomCurves random(372);
    const Curve first = high_degree_curve(3, 5, random);
    const Curve second = high_degree_curve(3, 6, random);
    for (const JoinContinuity continuity : {JoinContinuity::c0, JoinContinuity::g1, JoinContinuity::g2}) {
        const auto joined = join(first, second, continuity).value();
        const std::size_t offset = first.control_points().size() - 1;
        for (std::size_t i = 0; i <= offset; ++i)
            EXPECT_EQ(joined.curve.control_points()[i], first.control_points()[i]);
        const auto moved = static_cast<std::size_t>(order_of(continuity)) + 1;
        for (std::size_t i = moved; i < second.control_points().size(); ++i)
            EXPECT_EQ(joined.curve.control_points()[offset + i], second.control_points()[i]);
        EXPECT_GT(joined.error, 0.0);
        EXPECT_EQ(joined.curve.knots().multiplicity(first.domain().upper), 3);
    }
}

TEST(Join, of_two_lines_by_hand) {
    const Curve first = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {2, 0}}}).value();
    const Curve second = Curve::make({.degree = 1, .knots = {5, 5, 7, 7}, .points = {{3, 1}, {3, 5}}}).value();
    const auto touching = join(first, second, JoinContinuity::c0).value();
    EXPECT_EQ(touching.curve.control_points()[1], Point(2, 0));
    EXPECT_EQ(touching.curve.control_points()[2], Point(3, 5));
    EXPECT_NEAR(touching.error, std::sqrt(2.0), 1e-15);
    EXPECT_EQ(stored(touching.curve), (std::vector<double>{0, 0, 1, 3, 3}));
    // As a parabola the second has legs of 2; the first of them turns into the direction of the line.
    const auto smooth = join(first, second, JoinContinuity::g1).value();
    EXPECT_EQ(smooth.curve.degree(), 2);
    EXPECT_EQ(smooth.curve.control_points()[3], Point(4, 0));
    EXPECT_EQ(smooth.curve.control_points()[4], Point(3, 5));
    // C' = (2, 0) of the line is 2 / 2 times the leg of a parabola over [1, 3].
    const auto even = join(first, second, JoinContinuity::c1).value();
    EXPECT_EQ(even.curve.knots().multiplicity(1.0), 1);
    EXPECT_LE(distance(point_at(even.curve, 2.0), Point(0.25 * 2 + 0.5 * 4 + 0.25 * 3, 0.25 * 5)), 1e-15);
}

TEST(Join, of_the_parts_of_a_curve_restores_it) {
    RandomCurves random(373);
    CurveDefinition definition = high_degree_curve(3, 7, random).definition();
    definition.weights.clear();
    const Curve curve = Curve::make(definition).value();
    const auto parts = split(curve, 0.37 * curve.domain().upper).value();
    for (const JoinContinuity continuity : all) {
        const auto joined = join(parts[0], parts[1], continuity).value();
        EXPECT_LE(joined.error, 1e-13);
        EXPECT_EQ(joined.curve.domain(), curve.domain());
        EXPECT_LE(shape_change(curve, joined.curve, random), 1e-14);
    }
    const Curve smooth = join(parts[0], parts[1], JoinContinuity::c2)->curve;
    EXPECT_EQ(smooth.knots().multiplicity(0.37 * curve.domain().upper), 1);
}

TEST(Join, keeps_its_continuity_far_away_and_in_high_degrees) {
    RandomCurves random(374);
    for (const int degree : {10, 24})
        for (const JoinContinuity continuity : all) {
            const Curve first = translated(high_degree_curve(degree, 3, random), {1e6, 1e6});
            const Curve second = translated(high_degree_curve(degree, 3, random), {1e6, 1e6});
            const auto joined = join(first, second, continuity);
            ASSERT_TRUE(joined) << describe(joined.error());
            EXPECT_LE(jump_at(joined->curve, first.domain().upper, continuity), 1e-6);
        }
}

TEST(Join, refuses_rings_and_ends_without_direction) {
    using Code = CurveErrorCode;
    const Curve line = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {2, 0}}}).value();
    const Curve point = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{1, 1}, {1, 1}}}).value();
    const Curve ring =
        Curve::make({.degree = 2, .knots = {0, 1, 2}, .points = {{0, 0}, {1, 2}}, .periodic = true}).value();
    EXPECT_EQ(join(ring, line, JoinContinuity::c0).error().code, Code::curve_periodic);
    EXPECT_EQ(join(line, ring, JoinContinuity::c0).error().code, Code::curve_periodic);
    EXPECT_EQ(join(point, line, JoinContinuity::g1).error().code, Code::curve_stands_still);
    EXPECT_EQ(join(line, point, JoinContinuity::g1).error().code, Code::curve_stands_still);
    EXPECT_TRUE(join(point, line, JoinContinuity::c2));
}

}  // namespace
}  // namespace batten::core
