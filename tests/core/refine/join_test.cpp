#include "core/refine/join.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/curve/knot_analysis.h"
#include "core/make/conics.h"
#include "core/make/shapes.h"
#include "core/measure/continuity.h"
#include "core/refine/bezier_form.h"
#include "core/refine/reparametrize.h"
#include "core/refine/reverse.h"
#include "core/refine/split.h"
#include "tests/core/joint_jumps.h"
#include "tests/core/known_curves.h"
#include "tests/core/shape_check.h"

namespace batten::core {
namespace {

constexpr JoinContinuity all[]{JoinContinuity::c0, JoinContinuity::c1, JoinContinuity::c2,
                               JoinContinuity::g1, JoinContinuity::g2, JoinContinuity::g3};

int order_of(JoinContinuity continuity) {
    if (continuity == JoinContinuity::c0) return 0;
    if (continuity == JoinContinuity::g3) return 3;
    return continuity == JoinContinuity::c1 || continuity == JoinContinuity::g1 ? 1 : 2;
}

bool is_geometric(JoinContinuity continuity) {
    return continuity == JoinContinuity::g1 || continuity == JoinContinuity::g2 || continuity == JoinContinuity::g3;
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
    jump = std::max(jump, std::abs(left - right) / std::max(1.0, std::abs(left)));
    if (order < 3) return jump;
    // Differences of curvature are right to a few digits only.
    const double change = change_by_differences(curve, u, Side::left);
    return std::max(jump, 1e-5 * std::abs(change - change_by_differences(curve, u, Side::right)) /
                              std::max({1.0, std::abs(change), left * left}));
}

// How much less smooth, in G levels, `after` is at a knot than `before` was there; the joint is left out, and so is
// what `before` does not reach.
int lost_levels(const Curve& before, const JoinedCurve& after) {
    int lost = 0;
    const auto old_joints = joint_continuity(before);
    for (const JointContinuity& now : joint_continuity(after.curve, {.angle = 1e-5, .curvature = 1e-4})) {
        if (now.kind != JointKind::knot || now.u == after.joint || !before.domain().contains(now.u)) continue;
        int level = 2;
        for (const JointContinuity& old : old_joints)
            if (old.u == now.u && old.kind == JointKind::knot) level = old.geometric;
        lost = std::max(lost, level - now.geometric);
    }
    return lost;
}

constexpr JoinedEnds forward{CurveEnd::end, CurveEnd::start};

TEST(Join, has_the_continuity_asked_for) {
    RandomCurves random(371);
    for (int k = 0; k < 200; ++k) {
        const Curve first = random.open_curve();
        const Curve second = random.open_curve();
        for (const JoinContinuity continuity : all) {
            const auto joined = join(first, second, continuity, forward);
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

TEST(Join, keeps_the_second_curve_behind_the_part_that_changes) {
    RandomCurves random(375);
    for (int k = 0; k < 100; ++k) {
        const Curve first = random.open_curve();
        const Curve second = random.open_curve();
        for (const JoinContinuity continuity : all) {
            const auto joined = join(first, second, continuity, forward).value();
            ASSERT_EQ(joined.changed.lower, joined.joint);
            if (joined.changed.upper >= joined.curve.domain().upper) continue;
            const auto rest = sub_curve(joined.curve, joined.changed.upper, joined.curve.domain().upper).value();
            const auto old = shift_domain(second, joined.joint).value();
            EXPECT_LE(shape_change(old, rest, random), 1e-12);
        }
    }
}

TEST(Join, keeps_the_smoothness_of_both_curves_at_their_knots) {
    RandomCurves random(376);
    for (int k = 0; k < 60; ++k) {
        const Curve first = random.open_curve();
        const Curve second = to_bezier(random.open_curve()).value();
        for (const JoinContinuity continuity : all) {
            const auto joined = join(first, second, continuity, forward).value();
            EXPECT_EQ(lost_levels(first, joined), 0);
            EXPECT_EQ(lost_levels(shift_domain(second, joined.joint).value(), joined), 0);
        }
    }
}

double largest_curvature(const Curve& curve, Interval range) {
    double largest = 0.0;
    for (int k = 0; k <= 1000; ++k)
        largest = std::max(
            largest, std::abs(curvature_at(curve, range.lower + range.length() * k / 1000.0, Side::left).value_or(0)));
    return largest;
}

// A quarter of the unit circle from (1, 0) to (0, 1), and one of radius 2 that goes on from there, turned by `angle`
// degrees from the direction in which the first one arrives.
Curve quarter(Point center, double radius, double begin) {
    return circular_arc(center, radius, {begin, 90.0}).value();
}
Curve arc_turned_by(double degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const Point center{2.0 * std::sin(angle), 1.0 - 2.0 * std::cos(angle)};
    return quarter(center, 2.0, 90.0 + degrees);
}

TEST(Join, of_two_arcs_bends_a_short_part_and_makes_no_corner) {
    const Curve first = quarter({0, 0}, 1.0, 0.0);
    for (const double turn : {-60.0, 0.0, 30.0, 90.0})
        for (const JoinContinuity continuity : all) {
            const Curve second = arc_turned_by(turn);
            const auto joined = join(first, second, continuity).value();
            SCOPED_TRACE(testing::Message() << turn << " degrees, " << name_of(continuity));
            EXPECT_EQ(joined.ends, forward);
            EXPECT_LE(jump_at(joined.curve, joined.joint, continuity), 1e-9);
            for (const JointContinuity& joint : joint_continuity(joined.curve))
                EXPECT_TRUE(joint.u == joined.joint || joint.geometric == 2) << joint.u;
            // Half an arc of length pi is left for a turn by 90 degrees and for the way back to the arc.
            EXPECT_LE(largest_curvature(joined.curve, joined.curve.domain()), turn == 0.0    ? 1.5
                                                                              : turn == 90.0 ? 16.0
                                                                                             : 9.0);
            EXPECT_LE(joined.error, 0.6);
            EXPECT_NEAR(*joined.before.angle, turn * std::numbers::pi / 180.0, 1e-12);
            EXPECT_NEAR(*joined.before.before, 1.0, 1e-12);
            EXPECT_NEAR(*joined.before.after, 0.5, 1e-12);
        }
}

TEST(Join, closes_a_gap) {
    const Curve first = quarter({0, 0}, 1.0, 0.0);
    for (const double gap : {1e-3, 0.1, 0.5})
        for (const JoinContinuity continuity : all) {
            const auto joined = join(first, moved(arc_turned_by(0.0), {-gap, 0.0}), continuity).value();
            SCOPED_TRACE(testing::Message() << gap << ", " << name_of(continuity));
            EXPECT_NEAR(joined.before.gap, gap, 1e-12);
            EXPECT_EQ(joined.after.gap, 0.0);
            EXPECT_GE(joined.error, gap * (1.0 - 1e-12));
            EXPECT_LE(joined.error, 1.2 * gap + 0.1);
            EXPECT_LE(largest_curvature(joined.curve, joined.changed), 3.0);
        }
}

TEST(Join, takes_the_ends_that_are_nearest) {
    // Two parts of one curve, in all four directions.
    RandomCurves random(377);
    const Curve curve = high_degree_curve(3, 6, random);
    const auto parts = split(curve, 2.0).value();
    const Curve turned = reverse(parts[1]).value();
    for (const bool is_turned : {false, true}) {
        const auto behind = join(parts[0], is_turned ? turned : parts[1], JoinContinuity::g2).value();
        EXPECT_EQ(behind.ends, (JoinedEnds{CurveEnd::end, is_turned ? CurveEnd::end : CurveEnd::start}));
        EXPECT_LE(behind.error, 1e-13);
        EXPECT_LE(shape_change(curve, behind.curve, random), 1e-13);
        const Curve other = is_turned ? reverse(parts[0]).value() : parts[0];
        const auto before = join(parts[1], other, JoinContinuity::g2).value();
        EXPECT_EQ(before.ends, (JoinedEnds{CurveEnd::start, is_turned ? CurveEnd::start : CurveEnd::end}));
        EXPECT_EQ(before.joint, 2.0);
        EXPECT_LE(shape_change(curve, before.curve, random), 1e-13);
    }
}

TEST(Join, of_ends_equally_near_takes_the_end_and_turns_nothing) {
    // The corners of a square.
    const Curve lower = line({0, 0}, {1, 0}).value();
    const Curve upper = line({0, 1}, {1, 1}).value();
    EXPECT_EQ(nearest_ends(lower, upper), (JoinedEnds{CurveEnd::end, CurveEnd::end}));
    EXPECT_EQ(nearest_ends(lower, line({0.5, 1}, {0.5, 2}).value()), forward);
    EXPECT_EQ(nearest_ends(lower, line({0.5, 2}, {0.5, 1}).value()), (JoinedEnds{CurveEnd::start, CurveEnd::end}));
}

TEST(Join, of_ends_equally_near_turns_no_curve_if_it_need_not) {
    const Curve second = line({0, 0}, {1, 1}).value();
    const JoinedEnds backward{CurveEnd::start, CurveEnd::end};
    EXPECT_EQ(nearest_ends(line({0, 1}, {1, 2}).value(), second), backward);
    EXPECT_EQ(nearest_ends(second, line({0, 1}, {1, 2}).value()), forward);
    // Rounding does not decide: a tenth of the way, thrice, is not 0.3.
    EXPECT_EQ(nearest_ends(line({0.1 + 0.2, 1}, {1.3, 2}).value(), line({0.3, 0}, {1.3, 1}).value()), backward);
    const auto joined = join(line({0, 1}, {1, 2}).value(), second, JoinContinuity::c0).value();
    EXPECT_EQ(joined.curve.control_points().front(), Point(0, 0));
    EXPECT_EQ(joined.curve.control_points().back(), Point(1, 2));
}

TEST(Join, of_two_lines_by_hand) {
    const Curve first = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {2, 0}}}).value();
    const Curve second = Curve::make({.degree = 1, .knots = {5, 5, 7, 7}, .points = {{3, 1}, {3, 5}}}).value();
    const auto touching = join(first, second, JoinContinuity::c0).value();
    EXPECT_EQ(touching.curve.control_points()[1], Point(2, 0));
    EXPECT_EQ(touching.curve.control_points()[2], Point(3, 5));
    EXPECT_NEAR(touching.error, std::sqrt(2.0), 2e-2);
    EXPECT_EQ(stored(touching.curve), (std::vector<double>{0, 0, 1, 3, 3}));
    // The direction is that of the line; the turn by a right angle makes the speed of 2 half as much again.
    const auto smooth = join(first, second, JoinContinuity::g1).value();
    EXPECT_EQ(smooth.curve.degree(), 3);
    const auto after = derivatives_at(smooth.curve, 1.0, 1);
    EXPECT_LE(distance(after.point, Point(2, 0)), 1e-15);
    EXPECT_LE(length(after[1] - Vector(3, 0)), 1e-14);
    EXPECT_EQ(join(first, second, JoinContinuity::c1)->curve.knots().multiplicity(1.0), 2);
}

TEST(Join, loses_no_line) {
    // Both lines end in (1, 0): the second one is turned, and nothing moves.
    const auto joined = join(line({0, 0}, {1, 0}).value(), line({2, 0}, {1, 0}).value(), JoinContinuity::c0).value();
    EXPECT_EQ(joined.error, 0.0);
    const auto points = joined.curve.control_points();
    EXPECT_EQ((std::vector<Point>(points.begin(), points.end())), (std::vector<Point>{{0, 0}, {1, 0}, {2, 0}}));
    EXPECT_EQ(joined.ends, (JoinedEnds{CurveEnd::end, CurveEnd::end}));
    EXPECT_EQ(joined.changed.length(), 0.0);
}

TEST(Join, of_polygons_turns_the_first_straight_part_and_makes_no_corner) {
    const Curve first = line({0, 0}, {1, 0}).value();
    const Curve second = polyline(std::vector<Point>{{2, 1}, {3, 1}, {6, 1}, {6, 5}}).value();
    const auto joined = join(first, second, JoinContinuity::c0).value();
    EXPECT_EQ(joined.curve.degree(), 1);
    // From (1, 0) to (6, 1), divided 1 to 3.
    EXPECT_LE(distance(joined.curve.control_points()[2], Point(2.25, 0.25)), 1e-15);
    EXPECT_EQ(joined.curve.control_points()[3], Point(6, 1));
    EXPECT_EQ(joined.curve.control_points()[4], Point(6, 5));
}

TEST(Join, of_curves_of_very_different_size_and_speed_does_not_lead_astray) {
    for (const double size : {1e-6, 1e-3, 1.0, 1e3, 1e6})
        for (const double span : {1e-3, 1.0, 1e3})
            for (const JoinContinuity continuity : all) {
                const Curve first = Curve::make({.degree = 3,
                                                 .knots = {0, 0, 0, 0, 1, 1, 1, 1},
                                                 .points = {{-3, -1}, {-2, 0}, {-1, 1}, {0, 0}}})
                                        .value();
                const Curve second = Curve::make({.degree = 2,
                                                  .knots = {0, 0, 0, span, span, span},
                                                  .points = {{0, 0}, {size, 0}, {2 * size, size}}})
                                         .value();
                const auto joined = join(first, second, continuity).value();
                SCOPED_TRACE(testing::Message() << size << ", " << span << ", " << name_of(continuity));
                EXPECT_EQ(joined.ends, forward);
                // Of a curve of a millionth the change of curvature is a large number.
                EXPECT_LE(jump_at(joined.curve, joined.joint, continuity),
                          continuity == JoinContinuity::g3 ? 1e-7 : 1e-8);
                EXPECT_LE(joined.error, 0.45 * size);
            }
}

TEST(Join, of_the_parts_of_a_curve_restores_it) {
    RandomCurves random(373);
    CurveDefinition definition = high_degree_curve(3, 7, random).definition();
    definition.weights.clear();
    const Curve curve = Curve::make(definition).value();
    const auto parts = split(curve, 0.37 * curve.domain().upper).value();
    for (const JoinContinuity continuity : all) {
        const auto joined = join(parts[0], parts[1], continuity, forward).value();
        EXPECT_LE(joined.error, 1e-13);
        EXPECT_EQ(joined.curve.domain(), curve.domain());
        EXPECT_LE(shape_change(curve, joined.curve, random), 1e-14);
    }
    const Curve smooth = join(parts[0], parts[1], JoinContinuity::c2, forward)->curve;
    EXPECT_EQ(smooth.knots().multiplicity(0.37 * curve.domain().upper), 1);
}

TEST(Join, keeps_its_continuity_far_away_and_in_high_degrees) {
    RandomCurves random(374);
    for (const int degree : {10, 24})
        for (const JoinContinuity continuity : all) {
            const Curve first = moved(high_degree_curve(degree, 3, random), {1e6, 1e6});
            const Curve second = moved(high_degree_curve(degree, 3, random), {1e6, 1e6});
            const auto joined = join(first, second, continuity, forward);
            ASSERT_TRUE(joined) << describe(joined.error());
            EXPECT_LE(jump_at(joined->curve, first.domain().upper, continuity), 1e-6);
        }
}

TEST(Join, tells_the_gap_of_ends_as_far_apart_as_doubles_reach) {
    const auto line = [](Point from, Point to) {
        return Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {from, to}}).value();
    };
    const Curve first = line({0, 0}, {1e300, 0});
    EXPECT_EQ(join(first, line({1e300, 1e300}, {0, 3e300}), JoinContinuity::c0).value().before.gap, 1e300);
    const Curve left = line({-1.5e308, 0}, {-1.5e308, 1e300});
    const Curve right = line({1.5e308, 0}, {1.5e308, 1e300});
    EXPECT_EQ(join(left, right, JoinContinuity::c0).error().code, CurveErrorCode::not_computable);
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
    const Curve triangle = polyline(std::vector<Point>{{0, 0}, {2, 0}, {1, 1}, {0, 0}}).value();
    EXPECT_EQ(join(triangle, line, JoinContinuity::c0).error().code, Code::curve_closed);
    EXPECT_EQ(join(line, triangle, JoinContinuity::c0).error().code, Code::curve_closed);
    const Curve back = core::line({2, 0}, {-5, 0}).value();
    EXPECT_EQ(join(line, back, JoinContinuity::g1).error().code, Code::joint_turns_back);
    EXPECT_TRUE(join(line, back, JoinContinuity::c0));
}

}  // namespace
}  // namespace batten::core
