#include "core/measure/continuity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"
#include "core/refine/knot_insertion.h"
#include "tests/core/known_curves.h"
#include "tests/core/random_curves.h"

namespace batten::core {
namespace {

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

// Of the knot `u` of `curve`.
JointContinuity joint_at(const Curve& curve, double u) {
    for (const DistinctKnot& knot : distinct_knots(curve.knots()))
        if (knot.value == u) return joint_continuity_at(curve, knot, control_box(curve));
    ADD_FAILURE() << u << " is no knot";
    return {};
}

TEST(Continuity, both_sides_of_a_joint_have_their_derivatives) {
    // 3 (P3 - P2) / (1/2) and 6 (P3 - 2 P2 + P1) / (1/4) of the first piece, and likewise of the second.
    const auto joint = joint_at(cubic_pieces({{0, 0}, {1, 2}, {2, 1}, {3, 1}, {5, 1}, {6, 3}, {7, 0}}), 0.5);
    EXPECT_EQ(joint.left.point, Point(3, 1));
    EXPECT_EQ(joint.right.point, Point(3, 1));
    EXPECT_EQ(joint.left.first, Vector(6, 0));
    EXPECT_EQ(joint.right.first, Vector(12, 0));
    EXPECT_EQ(joint.left.second, Vector(0, 24));
    EXPECT_EQ(joint.right.second, Vector(-24, 48));
    EXPECT_EQ(joint.second.size, std::hypot(24.0, 24.0));
    EXPECT_EQ(speed_ratio(joint).value(), 2.0);
    EXPECT_FALSE(joint.first.is_rounding());
    EXPECT_TRUE(joint.position.is_rounding());
}

TEST(Continuity, of_one_knot_is_that_of_all) {
    RandomCurves random(313);
    for (int i = 0; i < 100; ++i) {
        const Curve curve = random.curve();
        for (const JointContinuity& joint : joint_continuity_within(curve, curve.domain())) {
            const JointContinuity alone = joint_at(curve, joint.u);
            EXPECT_EQ(alone.kind, joint.kind);
            EXPECT_EQ(alone.first.size, joint.first.size);
            EXPECT_EQ(alone.angle, joint.angle);
            // From the whole curve, not from one piece.
            const double before = joint.kind == JointKind::seam ? curve.domain().upper : joint.u;
            const Jet left = derivatives_at(curve, before, 2, Side::left);
            const Jet right = derivatives_at(curve, joint.u, 2, Side::right);
            const double size = robust_length(left[1]) + robust_length(right[1]);
            EXPECT_LE(robust_length(joint.left.first - left[1]), 1e-12 * size) << i << " at " << joint.u;
            EXPECT_LE(robust_length(joint.right.first - right[1]), 1e-12 * size) << i << " at " << joint.u;
        }
    }
}

TEST(Continuity, rounding_is_no_jump) {
    RandomCurves random(317);
    for (int i = 0; i < 300; ++i) {
        const Curve curve = random.curve();
        for (const Curve& where : {curve, moved(curve, {1e6, 2e6})})
            for (const JointContinuity& joint : joint_continuity_within(where, where.domain())) {
                EXPECT_TRUE(joint.promised < 0 || joint.position.is_rounding()) << i << " at " << joint.u;
                EXPECT_TRUE(joint.promised < 1 || joint.first.is_rounding()) << i << " at " << joint.u;
                EXPECT_TRUE(joint.promised < 2 || joint.second.is_rounding()) << i << " at " << joint.u;
            }
    }
}

TEST(Continuity, falls_with_every_knot_that_comes_to_another_down_to_the_tear) {
    // Knots in the middle come together at 1/2; the cubic of these points is symmetric to no knot.
    const std::vector<Point> points{{0, 0}, {1, 3}, {2, -1}, {4, 2}, {5, 5}, {7, 1}, {8, 0}, {9, 4}};
    const std::vector<std::vector<double>> middles{
        {0.5, 0.6, 0.7, 0.8}, {0.5, 0.5, 0.7, 0.8}, {0.5, 0.5, 0.5, 0.8}, {0.5, 0.5, 0.5, 0.5}};
    for (int k = 1; k <= 4; ++k) {
        std::vector<double> knots{0, 0, 0, 0};
        const auto& middle = middles[static_cast<std::size_t>(k) - 1];
        knots.insert(knots.end(), middle.begin(), middle.end());
        knots.insert(knots.end(), 4, 1.0);
        const auto joint =
            joint_at(Curve::make({.degree = 3, .knots = knots, .points = points, .tears = Tears::allow}).value(), 0.5);
        EXPECT_EQ(joint.multiplicity, k);
        EXPECT_EQ(joint.promised, 3 - k);
        EXPECT_EQ(joint.parametric, 3 - k);
        EXPECT_EQ(joint.second.is_rounding(), k < 2);
        EXPECT_EQ(joint.first.is_rounding(), k < 3);
        EXPECT_EQ(joint.position.is_rounding(), k < 4);
    }
    // The tear is between P3 and P4.
    const Curve torn = Curve::make({.degree = 3,
                                    .knots = {0, 0, 0, 0, 0.5, 0.5, 0.5, 0.5, 1, 1, 1, 1},
                                    .points = points,
                                    .tears = Tears::allow})
                           .value();
    EXPECT_EQ(joint_at(torn, 0.5).left.point, Point(4, 2));
    EXPECT_EQ(joint_at(torn, 0.5).right.point, Point(5, 5));
    EXPECT_EQ(joint_at(torn, 0.5).position.size, std::sqrt(10.0));
}

// A cubic Bézier curve.
Curve cubic(std::vector<Point> points, double end = 1.0) {
    return Curve::make({.degree = 3, .knots = {0, 0, 0, 0, end, end, end, end}, .points = std::move(points)}).value();
}

Box box_of(const Curve& first, const Curve& second) {
    Box box = control_box(first);
    box.include(control_box(second).lower);
    box.include(control_box(second).upper);
    return box;
}

TEST(Continuity, between_two_curves_has_their_speeds) {
    const Curve first = cubic({{0, 0}, {1, 2}, {2, 1}, {3, 1}});
    const Curve second = cubic({{3, 1}, {5, 1}, {6, 3}, {7, 0}}, 2.0);
    const Box box = box_of(first, second);
    ASSERT_EQ(ends_that_meet(first, second, box), (std::vector<JoinedEnds>{{CurveEnd::end, CurveEnd::start}}));
    const auto joint = continuity_between(first, second, {CurveEnd::end, CurveEnd::start}, box);
    EXPECT_EQ(joint.kind, JointKind::curves);
    EXPECT_EQ(joint.left.first, Vector(3, 0));
    EXPECT_EQ(joint.right.first, Vector(3, 0));
    EXPECT_EQ(joint.left.second, Vector(0, 6));
    EXPECT_EQ(joint.right.second, Vector(-1.5, 3));
    EXPECT_EQ(joint.parametric, 1);
    EXPECT_EQ(joint.geometric, 1);
    EXPECT_NEAR(joint.before.value(), 2.0 / 3.0, 1e-15);
    EXPECT_NEAR(joint.after.value(), 1.0 / 3.0, 1e-15);
    const auto quicker =
        continuity_between(first, cubic({{3, 1}, {5, 1}, {6, 3}, {7, 0}}), {CurveEnd::end, CurveEnd::start}, box);
    EXPECT_EQ(quicker.parametric, 0);
    EXPECT_EQ(quicker.geometric, 1);
    EXPECT_EQ(speed_ratio(quicker).value(), 2.0);
}

TEST(Continuity, between_two_curves_at_any_of_their_ends_is_run_through_from_the_first_into_the_second) {
    const std::vector<Point> before{{0, 0}, {1, 2}, {2, 1}, {3, 1}};
    const std::vector<Point> after{{3, 1}, {5, 1}, {6, 3}, {7, 0}};
    for (const JoinedEnds ends : all_joined_ends) {
        std::vector<Point> a = before;
        std::vector<Point> b = after;
        if (ends.first == CurveEnd::start) std::ranges::reverse(a);
        if (ends.second == CurveEnd::end) std::ranges::reverse(b);
        const Curve first = moved(cubic(a), {1e6, -1e6});
        const Curve second = moved(cubic(b), {1e6, -1e6});
        const Box box = box_of(first, second);
        ASSERT_EQ(ends_that_meet(first, second, box), std::vector{ends});
        const auto joint = continuity_between(first, second, ends, box);
        EXPECT_EQ(joint.left.first, Vector(3, 0));
        EXPECT_EQ(joint.right.first, Vector(6, 0));
        EXPECT_EQ(joint.left.second, Vector(0, 6));
        EXPECT_EQ(joint.right.second, Vector(-6, 12));
        EXPECT_NEAR(joint.before.value(), 2.0 / 3.0, 1e-9);
        EXPECT_NEAR(joint.after.value(), 1.0 / 3.0, 1e-9);
        EXPECT_EQ(joint.geometric, 1);
        EXPECT_TRUE(joint.position.is_rounding());
    }
}

TEST(Continuity, between_two_curves_that_turn_back_or_lie_apart) {
    const Curve first = cubic({{0, 0}, {1, 2}, {2, 1}, {3, 1}});
    const Curve back = cubic({{3, 1}, {2, 1}, {6, 3}, {7, 0}});
    const auto joint = continuity_between(first, back, {}, box_of(first, back));
    EXPECT_NEAR(std::abs(joint.angle.value()), std::numbers::pi, 1e-15);
    EXPECT_EQ(joint.geometric, 0);
    const Curve apart = cubic({{3, 1.5}, {4, 1.5}, {6, 3}, {7, 0}});
    EXPECT_TRUE(ends_that_meet(first, apart, box_of(first, apart)).empty());
    const auto gap = continuity_between(first, apart, {}, box_of(first, apart));
    EXPECT_EQ(gap.position.size, 0.5);
    EXPECT_EQ(gap.geometric, -1);
    // A leaf of two curves meets at both of its tips.
    const Curve other = cubic({{0, 0}, {1, -2}, {2, -1}, {3, 1}});
    EXPECT_EQ(ends_that_meet(first, other, box_of(first, other)).size(), 2U);
}

Curve pieces_of_size(double size) {
    std::vector<Point> points{{0, 0}, {1, 2}, {2, 1}, {3, 1}, {5, 1}, {6, 3}, {7, 0}};
    for (Point& point : points) point = tip_of(size / 7.0 * vector_to(point));
    points.front() = {-size, 0.0};
    return cubic_pieces(std::move(points));
}

TEST(Continuity, of_numbers_as_large_and_as_small_as_doubles) {
    for (const double size : {1e300, 1e-300}) EXPECT_EQ(joint_at(pieces_of_size(size), 0.5).geometric, 1);
    EXPECT_EQ(joint_at(pieces_of_size(1.6e308), 0.5).promised, 0);
}

}  // namespace
}  // namespace batten::core
