#include "core/measure/continuity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/refine/knot_insertion.h"
#include "tests/core/random_curves.h"

namespace batten::core {
namespace {

Curve moved(const Curve& curve, Vector offset) {
    CurveDefinition definition = curve.definition();
    for (Point& point : definition.points) point += offset;
    return Curve::make(std::move(definition)).value();
}

Curve cubic_pieces(std::vector<Point> points, double knot = 0.5) {
    return Curve::make({.degree = 3, .knots = {0, 0, 0, 0, knot, knot, knot, 1, 1, 1, 1}, .points = std::move(points)})
        .value();
}

TEST(Continuity, c0_by_its_knots_but_g1_by_its_shape) {
    // Leg lengths 1 and 2 along one line, so that the speed jumps from 6 to 12 but not the direction.
    const auto joints = joint_continuity(cubic_pieces({{0, 0}, {1, 2}, {2, 1}, {3, 1}, {5, 1}, {6, 3}, {7, 0}}));
    ASSERT_EQ(joints.size(), 1U);
    EXPECT_EQ(joints[0].promised, 0);
    EXPECT_EQ(joints[0].multiplicity, 3);
    EXPECT_EQ(joints[0].parametric, 0);
    EXPECT_EQ(joints[0].geometric, 1);
    EXPECT_EQ(joints[0].position.size, 0.0);
    EXPECT_NEAR(joints[0].first.size, 6.0, 1e-13);
    EXPECT_NEAR(joints[0].first.relative, 0.5, 1e-14);
    EXPECT_NEAR(joints[0].angle.value(), 0.0, 1e-15);
    // Curvature 2/3 h / leg^2 of a cubic, h the height of the next leg but one: a = 1, h = 1 (to the right of the
    // direction reversed, so left), then a = 2, h = 2.
    EXPECT_NEAR(joints[0].before.value(), 2.0 / 3.0, 1e-14);
    EXPECT_NEAR(joints[0].after.value(), 1.0 / 3.0, 1e-14);
}

TEST(Continuity, of_speed_of_acceleration_and_of_curvature) {
    // Equal legs: C1. The second differences agree as well: C2.
    const auto smooth = joint_continuity(cubic_pieces({{0, 0}, {1, 2}, {2, 1}, {3, 1}, {4, 1}, {5, 2}, {7, 0}}));
    EXPECT_EQ(smooth[0].parametric, 2);
    EXPECT_EQ(smooth[0].geometric, 2);
    // C1 and not G2: the outer neighbor higher.
    const auto bent = joint_continuity(cubic_pieces({{0, 0}, {1, 2}, {2, 1}, {3, 1}, {4, 1}, {5, 3}, {7, 0}}));
    EXPECT_EQ(bent[0].parametric, 1);
    EXPECT_EQ(bent[0].geometric, 1);
    // G2 and not C1: legs 1 and 2, heights 1 and 4, so curvature 2/3 on both sides.
    const auto g2 = joint_continuity(cubic_pieces({{0, 0}, {1, 2}, {2, 1}, {3, 1}, {5, 1}, {6, 5}, {7, 0}}));
    EXPECT_EQ(g2[0].parametric, 0);
    EXPECT_EQ(g2[0].geometric, 2);
}

TEST(Continuity, corner_has_its_angle) {
    const auto joints = joint_continuity(
        Curve::make({.degree = 1, .knots = {0, 0, 1, 2, 2}, .points = {{0, 0}, {1, 0}, {1, 3}}}).value());
    ASSERT_EQ(joints.size(), 1U);
    EXPECT_EQ(joints[0].geometric, 0);
    EXPECT_NEAR(joints[0].angle.value(), 0.5 * std::numbers::pi, 1e-15);
    EXPECT_NEAR(joints[0].first.size, std::sqrt(10.0), 1e-15);
}

TEST(Continuity, cusp_is_smooth_by_its_derivatives_and_not_by_its_shape) {
    // (t^2, t^3) from -1 to 1, with a simple knot put in at the cusp.
    const Curve cusp = Curve::make({.degree = 3,
                                    .knots = {-1, -1, -1, -1, 1, 1, 1, 1},
                                    .points = {{1, -1}, {-1.0 / 3, 1}, {-1.0 / 3, -1}, {1, 1}}})
                           .value();
    const auto joints = joint_continuity(insert_knot(cusp, 0.0).value());
    ASSERT_EQ(joints.size(), 1U);
    EXPECT_EQ(joints[0].promised, 2);
    EXPECT_EQ(joints[0].parametric, 2);
    EXPECT_EQ(joints[0].geometric, 0);
    EXPECT_NEAR(std::abs(joints[0].angle.value()), std::numbers::pi, 1e-7);
    EXPECT_FALSE(joints[0].before.has_value());
}

TEST(Continuity, zero_speed_on_one_side_keeps_the_direction) {
    // The second piece begins with a double point: speed 0, but the direction is that of the first piece.
    const auto joints = joint_continuity(cubic_pieces({{0, 0}, {1, 2}, {2, 1}, {3, 1}, {3, 1}, {5, 1}, {7, 0}}));
    EXPECT_EQ(joints[0].parametric, 0);
    EXPECT_EQ(joints[0].geometric, 1);
    EXPECT_TRUE(joints[0].before.has_value());
    EXPECT_FALSE(joints[0].after.has_value());
}

TEST(Continuity, tear_is_a_gap) {
    const Curve torn = Curve::make({.degree = 1,
                                    .knots = {0, 0, 1, 1, 2, 2},
                                    .points = {{0, 0}, {1, 0}, {1, 3}, {2, 3}},
                                    .tears = Tears::allow})
                           .value();
    const auto joints = joint_continuity(torn);
    ASSERT_EQ(joints.size(), 1U);
    EXPECT_EQ(joints[0].promised, -1);
    EXPECT_EQ(joints[0].parametric, -1);
    EXPECT_EQ(joints[0].geometric, -1);
    EXPECT_EQ(joints[0].position.size, 3.0);
    EXPECT_NEAR(joints[0].position.relative, 3.0 / std::sqrt(13.0), 1e-15);
}

TEST(Continuity, ends_that_meet_are_a_joint) {
    const double w = std::sqrt(0.5);
    const Curve circle =
        Curve::make({.degree = 2,
                     .knots = {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1},
                     .points = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}},
                     .weights = {1, w, 1, w, 1, w, 1, w, 1}})
            .value();
    for (const Curve& curve : {circle, moved(circle, {1e6, -3e6})}) {
        const auto joints = joint_continuity(curve);
        ASSERT_EQ(joints.size(), 4U);
        EXPECT_EQ(joints.back().kind, JointKind::ends);
        for (const JointContinuity& joint : joints) {
            // This circle is C1 besides, with legs and weights mirrored at every joint.
            EXPECT_EQ(joint.parametric, 1);
            EXPECT_EQ(joint.geometric, 2);
        }
        EXPECT_TRUE(is_closed(curve));
    }
    const Curve arc =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {1, 1}, {2, 0}}}).value();
    EXPECT_TRUE(joint_continuity(arc).empty());
    EXPECT_FALSE(is_closed(arc));
    EXPECT_EQ(continuity_of_ends(arc).position.size, 2.0);
}

TEST(Continuity, found_is_never_less_than_promised) {
    RandomCurves random(311);
    int knots = 0;
    for (int i = 0; i < 300; ++i) {
        const Curve curve = random.curve();
        for (const Curve& where : {curve, moved(curve, {1e6, 2e6})})
            for (const JointContinuity& joint : joint_continuity(where)) {
                EXPECT_GE(joint.parametric, std::min(joint.promised, 2)) << i << " at " << joint.u;
                ++knots;
            }
    }
    EXPECT_GT(knots, 500);
}

TEST(Continuity, seam_of_a_periodic_curve_comes_first) {
    const Curve loop =
        Curve::make(
            {.degree = 2, .knots = {0, 1, 2, 3, 4}, .points = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}, .periodic = true})
            .value();
    const auto joints = joint_continuity(loop);
    ASSERT_EQ(joints.size(), 4U);
    EXPECT_EQ(joints[0].kind, JointKind::seam);
    EXPECT_EQ(joints[1].kind, JointKind::knot);
    for (const JointContinuity& joint : joints) {
        EXPECT_EQ(joint.promised, 1);
        EXPECT_EQ(joint.parametric, 1);
        // By symmetry the curvature is the same on both sides of the middle of every leg.
        EXPECT_EQ(joint.geometric, 2);
    }
}

TEST(Continuity, does_not_depend_on_the_size_of_the_domain) {
    for (const double length : {1e-9, 1.0, 1e9}) {
        const Curve curve = Curve::make({.degree = 3,
                                         .knots = {0, 0, 0, 0, 0.5 * length, 0.5 * length, 0.5 * length, length, length,
                                                   length, length},
                                         .points = {{0, 0}, {1, 2}, {2, 1}, {3, 1}, {5, 1}, {6, 3}, {7, 0}}})
                                .value();
        EXPECT_EQ(joint_continuity(curve)[0].parametric, 0);
        EXPECT_EQ(joint_continuity(curve)[0].geometric, 1);
    }
}

}  // namespace
}  // namespace batten::core
