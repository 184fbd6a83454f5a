#include "core/refine/corner_bridge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/make/conics.h"
#include "core/make/shapes.h"
#include "core/make/through_points.h"
#include "core/measure/continuity.h"
#include "core/measure/intersect_curves.h"
#include "core/refine/periodic.h"
#include "core/refine/reverse.h"
#include "tests/core/joint_jumps.h"
#include "tests/core/known_curves.h"
#include "tests/core/shape_check.h"

namespace batten::core {
namespace {

const double root = std::sqrt(2.0);

// Every point of the bridge is so far from the center.
void expect_circular(const Curve& arc, Point center, double radius, double accuracy) {
    for (int k = 0; k <= 50; ++k)
        EXPECT_NEAR(distance(point_at(arc, k / 50.0), center), radius, accuracy * radius) << k;
}

// Both ends lie on the curves, and the directions there agree with those in which the kept parts run.
void expect_tangent(const Curve& first, const Curve& second, const CornerBridge& bridge) {
    const auto onward = [](const Curve& curve, double u, CurveEnd kept, bool leaves) {
        const Vector along = derivatives_at(curve, u, 1)[1] / length(derivatives_at(curve, u, 1)[1]);
        return (kept == CurveEnd::start) == leaves ? along : -along;
    };
    EXPECT_EQ(bridge.bridge.control_points().front(), point_at(first, bridge.u));
    EXPECT_EQ(bridge.bridge.control_points().back(), point_at(second, bridge.v));
    const Vector leaves = derivatives_at(bridge.bridge, 0.0, 1)[1];
    const Vector arrives = derivatives_at(bridge.bridge, 1.0, 1)[1];
    EXPECT_LE(length(leaves / length(leaves) - onward(first, bridge.u, bridge.kept_of_first, true)), 1e-11);
    EXPECT_LE(length(arrives / length(arrives) - onward(second, bridge.v, bridge.kept_of_second, false)), 1e-11);
}

TEST(Fillet, of_two_lines_is_the_one_in_the_quadrant_that_is_picked) {
    const Curve horizontal = line({-5, 0}, {5, 0}).value();
    const Curve vertical = line({0, -5}, {0, 5}).value();
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
            // Nearer to the crossing than the arc, on it and beyond it.
            for (const double pick : {0.3, 2.0, 4.5}) {
                const auto bridge =
                    fillet({horizontal, 0.5 + 0.1 * x * pick}, {vertical, 0.5 + 0.1 * y * pick}, 2.0).value();
                EXPECT_NEAR(bridge.u, 0.5 + 0.2 * x, 1e-15);
                EXPECT_NEAR(bridge.v, 0.5 + 0.2 * y, 1e-15);
                expect_circular(bridge.bridge, {2 * x, 2 * y}, 2.0, 1e-14);
                expect_tangent(horizontal, vertical, bridge);
                EXPECT_EQ(bridge.kept_of_first, x > 0 ? CurveEnd::end : CurveEnd::start);
                EXPECT_EQ(bridge.kept_of_second, y > 0 ? CurveEnd::end : CurveEnd::start);
                // It turns by 90 degrees: the middle is nearest to the crossing.
                EXPECT_NEAR(point_at(bridge.bridge, 0.5).x, x * (2 - root), 1e-14);
            }
}

TEST(Fillet, of_two_circles_touches_both_from_outside) {
    // Centers 4 apart, radii 1, and 2 for the fillet: its center is 3 from both, at height sqrt(5).
    for (const double size : {1e-6, 1.0, 1e6}) {
        const Curve left = circular_arc({-2 * size, 0}, size, {0, 180}).value();
        const Curve right = circular_arc({2 * size, 0}, size, {180, -180}).value();
        const auto bridge = fillet({left, 0.3}, {right, 0.3}, 2.0 * size).value();
        expect_circular(bridge.bridge, {0, size * std::sqrt(5.0)}, 2.0 * size, 1e-13);
        expect_tangent(left, right, bridge);
        const Curve joined = joined_by_bridge(left, right, bridge).value();
        for (const JointContinuity& joint : joint_continuity(joined)) EXPECT_GE(joint.geometric, 1);
    }
}

TEST(Fillet, far_away_is_as_exact) {
    const Vector far(1e6, -3e6);
    const Curve first = moved(line({-5, 1}, {5, -1}).value(), far);
    const Curve second = moved(circular_arc({0, 2}, 3, {200, 140}).value(), far);
    const auto bridge = fillet({first, 0.2}, {second, 0.2}, 0.5).value();
    const Point center =
        point_at(bridge.bridge, 0.0) +
        0.5 * (bridge.kept_of_first == CurveEnd::start ? 1.0 : -1.0) * Vector(0.2, 1.0) / std::hypot(0.2, 1.0) *
            (cross(derivatives_at(bridge.bridge, 0.0, 2)[1], derivatives_at(bridge.bridge, 0.0, 2)[2]) *
                         (bridge.kept_of_first == CurveEnd::start ? 1.0 : -1.0) >
                     0
                 ? 1.0
                 : -1.0);
    for (int k = 0; k <= 50; ++k) EXPECT_NEAR(distance(point_at(bridge.bridge, k / 50.0), center), 0.5, 4e-9);
    EXPECT_GE(smoothness_of(
                  meeting_of(passing_at(second, bridge.v, Side::left), passing_at(second, bridge.v, Side::right)), 3.0),
              1);
}

TEST(Fillet, between_free_curves_is_an_arc_that_touches_both) {
    RandomCurves random(671);
    int found = 0;
    for (int k = 0; k < 60; ++k) {
        const Curve first = high_degree_curve(3, 3, random);
        const Curve second = high_degree_curve(1 + k % 4, 3, random);
        const auto crossings = intersect_curves(first, second).contacts;
        if (crossings.empty()) continue;
        const double u = crossings.front().u;
        const double v = crossings.front().v;
        const auto bridge = fillet({first, u}, {second, v}, 0.05);
        if (!bridge) continue;
        ++found;
        expect_tangent(first, second, *bridge);
        const auto bent = curvature_at(bridge->bridge, 0.5).value();
        EXPECT_NEAR(std::abs(bent), 20.0, 1e-9);
    }
    EXPECT_GE(found, 20);
}

TEST(Fillet, rounds_the_corner_of_a_polygon_and_keeps_the_others) {
    const Curve polygon = polyline(std::vector<Point>{{0, 0}, {4, 0}, {4, 3}, {0, 3}}).value();
    const auto bridge = fillet({polygon, 0.5}, {polygon, 1.5}, 1.0).value();
    EXPECT_NEAR(bridge.u, 0.75, 1e-15);
    EXPECT_NEAR(bridge.v, 1.0 + 1.0 / 3, 1e-15);
    const Curve rounded = with_corner_bridged(polygon, bridge).value();
    EXPECT_EQ(rounded.degree(), 2);
    EXPECT_EQ(rounded.control_points().front(), Point(0, 0));
    EXPECT_EQ(rounded.control_points().back(), Point(0, 3));
    int corners = 0;
    for (const JointContinuity& joint : joint_continuity(rounded)) corners += joint.geometric < 1 ? 1 : 0;
    EXPECT_EQ(corners, 1);
    // 4 + 3 + 4, less two sides of the corner, and a quarter turn.
    double length = 0.0;
    for (int k = 0; k < 3000; ++k) {
        const Interval domain = rounded.domain();
        length += distance(point_at(rounded, domain.lower + domain.length() * k / 3000.0),
                           point_at(rounded, domain.lower + domain.length() * (k + 1) / 3000.0));
    }
    EXPECT_NEAR(length, 11 - 2 + 0.5 * std::numbers::pi, 1e-3);
}

TEST(Fillet, of_a_closed_polygon_leaves_it_closed) {
    const std::vector<Point> corners{{0, 0}, {4, 0}, {4, 3}, {0, 3}};
    std::vector<Point> closing = corners;
    closing.push_back({0, 0});
    for (const bool is_periodic : {false, true}) {
        Curve polygon = polyline(closing).value();
        if (is_periodic) polygon = to_periodic(polygon, 1e-9).value().curve;
        // A corner inside, and that at the seam.
        for (const auto& [u, v] : {std::pair{0.5, 1.5}, std::pair{3.5, 0.5}}) {
            const auto bridge = fillet({polygon, u}, {polygon, v}, 1.0);
            ASSERT_TRUE(bridge) << describe(bridge.error());
            const auto rounded = with_corner_bridged(polygon, *bridge);
            ASSERT_TRUE(rounded) << describe(rounded.error());
            EXPECT_EQ(rounded->is_periodic(), is_periodic);
            EXPECT_TRUE(is_closed(*rounded));
            int left = 0;
            for (const JointContinuity& joint : joint_continuity(*rounded)) left += joint.geometric < 1 ? 1 : 0;
            EXPECT_EQ(left, 3) << is_periodic << u;
            EXPECT_LE(distance(point_at(bridge->bridge, 0.5),
                               u < 1 ? Point(4 - 1 + 1 / root, 1 - 1 / root) : Point(1 - 1 / root, 1 - 1 / root)),
                      1e-14);
        }
    }
}

TEST(Fillet, says_which_radii_there_are) {
    // The shorter side is 2 long, the corner has a right angle.
    const Curve corner = polyline(std::vector<Point>{{0, 0}, {4, 0}, {4, 2}}).value();
    const auto too_large = fillet({corner, 0.5}, {corner, 1.5}, 2.5);
    ASSERT_FALSE(too_large);
    EXPECT_EQ(describe(too_large.error()),
              "the radius 2.5 is too large for an arc that touches both sides here; 1.999 is the most");
    EXPECT_TRUE(fillet({corner, 0.5}, {corner, 1.5}, 1.999));
    // Two lines apart, 6 and 8 from the corner that they would make: from 8 on.
    const Curve first = line({0, 0}, {4, 0}).value();
    const Curve second = line({10, 8}, {10, 100}).value();
    const auto too_small = fillet({first, 0.5}, {second, 0.1}, 3.0);
    ASSERT_FALSE(too_small);
    EXPECT_EQ(describe(too_small.error()), "no arc of radius 3 touches both sides here; a radius from 8 to 9.999 does");
    const Curve side = line({0, 0}, {0, 1}).value();
    const Curve parallel = line({5, 0}, {5, 1}).value();
    EXPECT_EQ(fillet({side, 0.5}, {parallel, 0.5}, 1.0).error().code, CurveErrorCode::no_fillet);
    EXPECT_EQ(fillet({side, 0.5}, {parallel, 0.5}, 0.0).error().code, CurveErrorCode::length_not_positive);
    EXPECT_EQ(fillet({side, 0.5}, {parallel, 0.5}, NAN).error().code, CurveErrorCode::length_not_positive);
    // Where all points are one there are no sizes to try.
    const Curve still =
        Curve::make({.degree = 1, .knots = {0, 0, 1, 2, 2}, .points = {{2, 3}, {2, 3}, {2, 3}}}).value();
    EXPECT_EQ(fillet({still, 0.5}, {still, 1.5}, 1.0).error().code, CurveErrorCode::no_fillet);
}

// A smooth curve with a double knot is no corner, although circles touch both of its sides there.
TEST(Fillet, of_a_smooth_knot_is_refused) {
    const std::vector<Point> points{{0, 0}, {3, 4}, {6, 0}, {9, 4}};
    const Curve curve = fit_points_at(points, {.kind = FitKind::local})
                            .and_then([](const FitPoints& fit) { return through_points(fit); })
                            .value();
    const double u = curve.knots().values()[5];
    ASSERT_EQ(curve.knots().multiplicity(u), 2);
    const auto tiny = fillet({curve, u}, {curve, u}, 1e-3);
    ASSERT_FALSE(tiny) << tiny->u << " to " << tiny->v;
    EXPECT_EQ(tiny.error().code, CurveErrorCode::fillet_not_possible);
    // The bend beside the knot is narrower than this circle, which rounds it.
    const CornerBridge wide = fillet({curve, u}, {curve, u}, 0.5).value();
    EXPECT_GT(distance(wide.bridge.control_points().front(), wide.bridge.control_points().back()), 0.1);
}

TEST(Fillet, joins_in_every_direction) {
    for (const bool first_is_turned : {false, true})
        for (const bool second_is_turned : {false, true}) {
            Curve first = line({-5, 0}, {0, 0}).value();
            Curve second = line({0, 0}, {0, 5}).value();
            if (first_is_turned) first = reverse(first).value();
            if (second_is_turned) second = reverse(second).value();
            const auto bridge = fillet({first, 0.5}, {second, 0.5}, 1.0).value();
            const Curve joined = joined_by_bridge(first, second, bridge).value();
            const Point begin = joined.control_points().front();
            const Point end = joined.control_points().back();
            EXPECT_EQ(begin, first_is_turned ? Point(0, 5) : Point(-5, 0));
            EXPECT_EQ(end, first_is_turned ? Point(-5, 0) : Point(0, 5));
            for (const JointContinuity& joint : joint_continuity(joined)) EXPECT_EQ(joint.geometric, 1);
        }
}

TEST(Chamfer, cuts_lengths_from_both_sides) {
    const Curve corner = polyline(std::vector<Point>{{0, 0}, {4, 0}, {4, 2}}).value();
    const auto bridge = chamfer({corner, 0.5}, {corner, 1.5}, 1.0, 0.5).value();
    EXPECT_LE(distance(bridge.bridge.control_points()[0], Point(3, 0)), 1e-14);
    EXPECT_LE(distance(bridge.bridge.control_points()[1], Point(4, 0.5)), 1e-14);
    const Curve cut = with_corner_bridged(corner, bridge).value();
    EXPECT_EQ(cut.degree(), 1);
    EXPECT_EQ(cut.control_points().size(), 4u);
    EXPECT_EQ(chamfer({corner, 0.5}, {corner, 1.5}, 1.0, 2.5).error().code, CurveErrorCode::chamfer_too_long);
    EXPECT_EQ(chamfer({corner, 0.5}, {corner, 1.5}, 1.0, 2.5).error().upper, 2.0);
    EXPECT_EQ(chamfer({corner, 0.1}, {corner, 0.5}, 1.0, 0.5).error().code, CurveErrorCode::no_corner);
    EXPECT_EQ(chamfer({corner, 0.5}, {corner, 1.5}, 0.0, 0.5).error().code, CurveErrorCode::length_not_positive);
}

TEST(Chamfer, of_curves_that_cross_keeps_the_sides_picked) {
    const Curve horizontal = line({-5, 0}, {5, 0}).value();
    const Curve arc = circular_arc({0, 0}, 2, {-60, 120}).value();
    for (const double u : {0.6, 0.8}) {
        const auto bridge = chamfer({horizontal, u}, {arc, 0.9}, 0.5, 1.0).value();
        EXPECT_NEAR(point_at(horizontal, bridge.u).x, u < 0.7 ? 1.5 : 2.5, 1e-12);
        // A length of 1 on the circle of radius 2 is half a radian.
        EXPECT_NEAR(point_at(arc, bridge.v).y, 2 * std::sin(0.5), 1e-12);
        EXPECT_EQ(bridge.kept_of_first, u < 0.7 ? CurveEnd::start : CurveEnd::end);
        EXPECT_EQ(bridge.kept_of_second, CurveEnd::end);
    }
    EXPECT_EQ(chamfer({horizontal, 0.5}, {line({0, 1}, {1, 2}).value(), 0.5}, 1, 1).error().code,
              CurveErrorCode::no_corner);
}

}  // namespace
}  // namespace batten::core
