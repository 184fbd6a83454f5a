#include "core/refine/match.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/make/conics.h"
#include "core/make/shapes.h"
#include "core/measure/intersect_curves.h"
#include "core/refine/reverse.h"
#include "core/refine/split.h"
#include "tests/core/joint_jumps.h"
#include "tests/core/shape_check.h"

namespace batten::core {
namespace {

using enum GeometricContinuity;
constexpr GeometricContinuity all[]{g0, g1, g2, g3};
constexpr CurveEnd both_ends[]{CurveEnd::start, CurveEnd::end};

double jump_after(const Curve& matched, CurveEnd end, const Passing& target, GeometricContinuity continuity,
                  double size) {
    return difference_of(run_back(measured_beyond(matched, end)), target, continuity, size);
}

TEST(Match, meets_the_other_curve_at_every_end) {
    RandomCurves random(471);
    for (int k = 0; k < 60; ++k) {
        const Curve curve = random.open_curve();
        const Curve other = random.open_curve();
        for (const CurveEnd end : both_ends)
            for (const CurveEnd target_end : both_ends)
                for (const GeometricContinuity continuity : all) {
                    const auto matched = match(curve, end, passing_beyond(other, target_end), continuity);
                    ASSERT_TRUE(matched) << describe(matched.error());
                    EXPECT_LE(jump_after(matched->curve, end, measured_beyond(other, target_end), continuity, 10.0),
                              2e-8)
                        << k << name_of(continuity);
                    EXPECT_EQ(matched->curve.domain(), curve.domain());
                    EXPECT_GE(smoothness_of(matched->after, 10.0), order_of(continuity)) << k;
                }
    }
}

TEST(Match, keeps_what_lies_behind_the_part_that_changes) {
    RandomCurves random(472);
    for (int k = 0; k < 60; ++k) {
        const Curve curve = high_degree_curve(4, 6, random);
        const Curve other = random.open_curve();
        for (const CurveEnd end : both_ends)
            for (const GeometricContinuity continuity : all) {
                const auto matched = match(curve, end, passing_beyond(other, CurveEnd::end), continuity).value();
                const bool is_start = end == CurveEnd::start;
                const double edge = is_start ? matched.changed.upper : matched.changed.lower;
                EXPECT_EQ(is_start ? matched.changed.lower : matched.changed.upper, parameter_of(curve.domain(), end));
                if (!(curve.domain().lower < edge && edge < curve.domain().upper)) continue;
                const auto rest = is_start ? sub_curve(matched.curve, edge, curve.domain().upper)
                                           : sub_curve(matched.curve, curve.domain().lower, edge);
                EXPECT_LE(shape_change(curve, *rest, random), 1e-13);
                EXPECT_TRUE(matched.lost.empty());
                // The far end point keeps its bits.
                const CurveEnd far = is_start ? CurveEnd::end : CurveEnd::start;
                EXPECT_EQ(point_at(matched.curve, parameter_of(curve.domain(), far)),
                          point_at(curve, parameter_of(curve.domain(), far)));
            }
    }
}

TEST(Match, to_the_middle_of_an_arc_takes_its_curvature) {
    // A circle of radius 2; at its top it runs to the left, and a line that leads away to the right goes on against it.
    const Curve arc = circular_arc({0, 0}, 2.0, {0, 180}).value();
    for (const double side : {1.0, -1.0}) {
        const Curve line = core::line({side * 0.2, 2.1}, {side * 5, 2.0}).value();
        const Passing target = passing_toward(arc, 0.5, line, CurveEnd::start);
        EXPECT_NEAR(target.direction->x, side, 1e-15);
        EXPECT_NEAR(*target.curvature, -side * 0.5, 1e-14);
        const auto matched = match(line, CurveEnd::start, target, g3).value();
        const Passing found = passing_at(matched.curve, CurveEnd::start);
        EXPECT_LE(distance(found.point, Point(0, 2)), 1e-15);
        EXPECT_NEAR(found.direction->x, side, 1e-14);
        EXPECT_NEAR(*found.curvature, -side * 0.5, 1e-12);
        EXPECT_NEAR(change_by_differences(matched.curve, 0.0, Side::right), 0.0, 1e-5);
        EXPECT_EQ(matched.curve.control_points().back(), line.control_points().back());
        EXPECT_NEAR(matched.before.gap, std::sqrt(0.04 + 0.01), 1e-14);
        EXPECT_EQ(matched.after.gap, 0.0);
    }
}

TEST(Match, of_what_matches_changes_nothing) {
    RandomCurves random(473);
    const Curve curve = high_degree_curve(4, 5, random);
    const auto parts = split(curve, 0.4 * curve.domain().upper).value();
    for (const GeometricContinuity continuity : {g0, g1, g2}) {
        const auto matched =
            match(parts[1], CurveEnd::start, passing_beyond(parts[0], CurveEnd::end), continuity).value();
        EXPECT_LE(matched.error, 1e-12) << name_of(continuity);
    }
    const auto still = match(parts[1], CurveEnd::start, passing_beyond(parts[0], CurveEnd::end), g0).value();
    EXPECT_EQ(still.curve, parts[1]);
    EXPECT_EQ(still.changed.length(), 0.0);
}

TEST(Match, has_the_same_shape_in_micrometers_and_in_kilometers) {
    RandomCurves random(474);
    const Curve curve = high_degree_curve(3, 4, random);
    const Curve other = high_degree_curve(3, 4, random);
    const auto scaled = [](const Curve& old, double by) {
        CurveDefinition definition = old.definition();
        for (Point& point : definition.points) point = {by * point.x, by * point.y};
        return Curve::make(definition).value();
    };
    for (const GeometricContinuity continuity : all) {
        const auto plain = match(curve, CurveEnd::end, passing_beyond(other, CurveEnd::start), continuity).value();
        for (const double by : {0x1p-20, 0x1p30}) {
            const auto matched =
                match(scaled(curve, by), CurveEnd::end, passing_beyond(scaled(other, by), CurveEnd::start), continuity)
                    .value();
            EXPECT_LE(point_difference(scaled(plain.curve, by), matched.curve), 1e-12);
            EXPECT_EQ(smoothness_of(matched.after, 16.0 * by), smoothness_of(plain.after, 16.0));
        }
    }
}

TEST(Match, of_neighbors_makes_no_loop) {
    const Curve arc = circular_arc({0, 0}, 1.0, {0, 90}).value();
    for (const double turn : {-60.0, 0.0, 45.0})
        for (const double gap : {0.0, 0.1})
            for (const GeometricContinuity continuity : all) {
                const double angle = turn * std::numbers::pi / 180.0;
                const Curve second =
                    circular_arc({2.0 * std::sin(angle) - gap, 1.0 - 2.0 * std::cos(angle)}, 2.0, {90.0 + turn, 90.0})
                        .value();
                const auto matched =
                    match(second, CurveEnd::start, passing_beyond(arc, CurveEnd::end), continuity).value();
                SCOPED_TRACE(testing::Message() << turn << ' ' << gap << ' ' << name_of(continuity));
                EXPECT_TRUE(self_intersections(matched.curve).contacts.empty());
                EXPECT_LE(matched.error, 0.6);
            }
}

TEST(Match, refuses_what_has_no_end_or_no_direction) {
    using Code = CurveErrorCode;
    const Curve line = core::line({0, 0}, {1, 0}).value();
    const Curve ring =
        Curve::make({.degree = 2, .knots = {0, 1, 2}, .points = {{0, 0}, {1, 2}}, .periodic = true}).value();
    const Curve point = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{1, 1}, {1, 1}}}).value();
    const auto error = [&](const Curve& curve, const Passing& target, GeometricContinuity continuity) {
        return match(curve, CurveEnd::start, target, continuity).error().code;
    };
    EXPECT_EQ(error(ring, passing_beyond(line, CurveEnd::end), g1), Code::curve_periodic);
    EXPECT_EQ(error(circle({0, 0}, 1).value(), passing_beyond(line, CurveEnd::end), g1), Code::curve_closed);
    EXPECT_EQ(error(line, passing_beyond(point, CurveEnd::end), g1), Code::curve_stands_still);
    EXPECT_EQ(error(point, passing_beyond(line, CurveEnd::end), g1), Code::curve_stands_still);
    EXPECT_EQ(error(core::line({1, 0}, {-3, 0}).value(), passing_beyond(line, CurveEnd::end), g1),
              Code::joint_turns_back);
    // A ring can be met, though.
    EXPECT_TRUE(match(line, CurveEnd::end, passing_toward(ring, 0.3, line, CurveEnd::end), g2));
}

}  // namespace
}  // namespace batten::core
