#include "core/shape/offset_shape.h"

#include <gtest/gtest.h>

#include "core/edit/offset.h"
#include "core/measure/arc_length.h"
#include "core/measure/continuity.h"
#include "core/measure/nearest.h"
#include "core/refine/reverse.h"
#include "tests/core/point_at_share.h"
#include "tests/core/shape/shapes_to_combine.h"

namespace batten::core {
namespace {

using std::numbers::pi;

Curve wave() {
    return interpolate(std::vector<Point>{{0, 0}, {2, 1.5}, {4, -1}, {6, 2}, {9, 0}, {11, 1}}).value().curve;
}

double distance_to(const std::vector<Curve>& curves, Point place) {
    double least = Box::infinity;
    for (const Curve& curve : curves) least = std::min(least, distance(nearest_point(curve, place).point, place));
    return least;
}

// Every place of the result is at the distance from the source, within `near`.
void expect_at_distance(const Curve& source, const std::vector<Curve>& result, double d, double near) {
    const NearestFinder finder(source);
    for (const Curve& curve : result)
        for (int k = 0; k <= 400; ++k) {
            const Point place = at_share(curve, k / 400.0);
            EXPECT_NEAR(distance(finder.nearest(place).point, place), d, near);
        }
}

// Every place on the left of the source that has no nearer part of it is on the result.
void expect_complete(const Curve& source, const std::vector<Curve>& result, double d, double near) {
    const NearestFinder finder(source);
    for (int k = 1; k < 300; ++k) {
        const double u = source.domain().lower + source.domain().length() * k / 300.0;
        const Jet jet = derivatives_at(source, u, 1);
        const Point place = jet.point + d / length(jet[1]) * turned_left(jet[1]);
        if (distance(finder.nearest(place).point, place) < std::abs(d) * (1 - 1e-9)) continue;
        EXPECT_LE(distance_to(result, place), near) << u;
    }
}

OffsetCurves offset_of(const Curve& curve, double d, double tolerance, OffsetSide side = OffsetSide::left,
                       OffsetCorners corners = OffsetCorners::mitre, OffsetCaps caps = OffsetCaps::none) {
    return offset_shape(curve, {d, tolerance, side, corners, caps}).value();
}

TEST(OffsetShape, has_few_points_and_is_c2) {
    const Curve source = wave();
    for (const double d : {0.2, -0.2}) {
        const OffsetCurves result = offset_of(source, d, 1e-4);
        ASSERT_EQ(result.curves.size(), 1u);
        const Curve& curve = result.curves[0];
        EXPECT_EQ(curve.degree(), 3);
        for (const JointContinuity& joint : joint_continuity(curve)) EXPECT_GE(joint.promised, 2);
        expect_at_distance(source, result.curves, 0.2, 1e-4);
        expect_complete(source, result.curves, d, 1e-4);
        EXPECT_LE(result.error, 1e-4);
        const auto knots_doubled = offset(source, d, 1e-4);
        ASSERT_TRUE(knots_doubled);
        EXPECT_LT(curve.control_points().size(), knots_doubled->curve.control_points().size());
        // It goes the same way.
        EXPECT_LT(at_share(curve, 0).x, at_share(curve, 1).x);
        EXPECT_GT(d * (at_share(curve, 0.5).y - nearest_point(source, at_share(curve, 0.5)).point.y), 0.0);
    }
}

TEST(OffsetShape, refuses_tolerances_below_rounding_before_it_tries) {
    const Curve source = rounded({1e3, -5}, {2, 2.3, 2.1, 1.9, 2.2, 2});
    for (const auto& [d, tolerance] : {std::pair(0.3, 1e-320), std::pair(0.3, 1e-17), std::pair(1e20, 1.0)}) {
        const auto result = offset_shape(source, {.distance = d, .tolerance = tolerance});
        ASSERT_FALSE(result);
        EXPECT_EQ(result.error().code, CurveErrorCode::tolerance_not_reached);
        EXPECT_EQ(result.error().value, tolerance);
        // Doubles about 1000 are 1.1e-13 apart, those about 1e20 16384.
        EXPECT_GE(result.error().lower, d < 1.0 ? 1e-13 : 16384.0);
        EXPECT_LT(result.error().lower, d < 1.0 ? 1e-10 : 1e7);
    }
}

TEST(OffsetShape, of_a_smooth_closed_curve_is_periodic) {
    const Curve source = rounded({1e3, -5}, {2, 2.3, 2.1, 1.9, 2.2, 2});
    for (const auto& [d, sign] : {std::pair(0.3, -1.0), std::pair(-0.3, 1.0)}) {
        const OffsetCurves result = offset_of(source, d, 1e-5);
        ASSERT_EQ(result.curves.size(), 1u);
        EXPECT_TRUE(result.curves[0].is_periodic());
        expect_at_distance(source, result.curves, 0.3, 1e-5);
        // Steiner: A -+ L d + pi d^2
        const double area = enclosed_area(source)->signed_area;
        EXPECT_NEAR(enclosed_area(result.curves[0])->signed_area,
                    area + sign * 0.3 * arc_length(source).value + pi * 0.09, 2e-4);
        EXPECT_LT(result.curves[0].control_points().size(), 100u);
    }
    EXPECT_EQ(offset_of(source, 0.3, 1e-5, OffsetSide::both).curves.size(), 2u);
}

TEST(OffsetShape, lines_circles_and_polygons_stay_exact) {
    const OffsetCurves inside = offset_of(disc({3, -2}, 2), 0.5, 1e-6);
    ASSERT_EQ(inside.curves.size(), 1u);
    EXPECT_EQ(inside.curves[0].degree(), 2);
    EXPECT_EQ(inside.curves[0].control_points().size(), 9u);
    for (int k = 0; k < 100; ++k) EXPECT_NEAR(distance(at_share(inside.curves[0], k / 100.0), {3, -2}), 1.5, 4e-15);
    const OffsetCurves square = offset_of(rectangle({0, 0}, {4, 2}), 0.5, 1e-6);
    ASSERT_EQ(square.curves.size(), 1u);
    EXPECT_EQ(square.curves[0].control_points().size(), 5u);
    EXPECT_NEAR(area_of(square.curves), 3.0, 1e-14);
    const OffsetCurves outside = offset_of(rectangle({0, 0}, {4, 2}), -0.5, 1e-6);
    EXPECT_EQ(outside.curves[0].control_points().size(), 5u);
    EXPECT_NEAR(area_of(outside.curves), 15.0, 1e-14);
}

TEST(OffsetShape, corners) {
    const Curve source = rectangle({0, 0}, {4, 2});
    EXPECT_NEAR(area_of(offset_of(source, 0.5, 1e-6, OffsetSide::right, OffsetCorners::round).curves), 8 + 6 + pi / 4,
                1e-12);
    EXPECT_NEAR(area_of(offset_of(source, 0.5, 1e-6, OffsetSide::right, OffsetCorners::bevel).curves), 8 + 6 + 0.5,
                1e-12);
    // The tip of a needle is farther than 4 distances away.
    const Curve needle = closed_polygon({{0, 0}, {10, 0}, {0, 1}});
    const auto beveled = offset_of(needle, 0.1, 1e-6, OffsetSide::right).curves;
    ASSERT_EQ(beveled.size(), 1u);
    EXPECT_EQ(beveled[0].control_points().size(), 5u);
}

TEST(OffsetShape, comes_apart_and_vanishes) {
    // Two rooms of 4 x 4 with a passage of 1 x 2 between them.
    const Curve dumbbell = closed_polygon(
        {{0, 0}, {4, 0}, {4, 1.5}, {6, 1.5}, {6, 0}, {10, 0}, {10, 4}, {6, 4}, {6, 2.5}, {4, 2.5}, {4, 4}, {0, 4}});
    EXPECT_EQ(offset_of(dumbbell, 0.4, 1e-6).curves.size(), 1u);
    const auto rooms = offset_of(dumbbell, 0.75, 1e-6).curves;
    ASSERT_EQ(rooms.size(), 2u);
    EXPECT_NEAR(area_of(rooms), 2 * (2.5 * 2.5), 0.2);
    expect_at_distance(dumbbell, offset_of(dumbbell, 0.75, 1e-6, OffsetSide::left, OffsetCorners::round).curves, 0.75,
                       1e-9);
    const auto gone = offset_shape(dumbbell, {2.5, 1e-6});
    ASSERT_FALSE(gone);
    EXPECT_EQ(describe(gone.error()),
              "nothing is left at the distance 2.5; it must be less than half of the width of the shape");
    EXPECT_FALSE(offset_shape(disc({0, 0}, 1), {1.5, 1e-6}));
    EXPECT_FALSE(offset_shape(rectangle({0, 0}, {4, 2}), {1.0, 1e-6}));
}

// Beyond the radius of curvature the offset has swallowtails, which are cut away.
TEST(OffsetShape, beyond_the_radius_of_curvature) {
    const Curve source = wave();
    for (const double d : {0.8, 1.5, 3.0})
        for (const OffsetSide side : {OffsetSide::left, OffsetSide::right}) {
            const OffsetCurves result = offset_of(source, d, 1e-4, side);
            expect_at_distance(source, result.curves, d, 1e-4);
            expect_complete(source, result.curves, side == OffsetSide::left ? d : -d, 2e-4);
        }
    const Curve flower = rounded({0, 0}, {3, 1.2, 3, 1.2, 3, 1.2, 3, 1.2, 3, 1.2});
    for (const double d : {0.2, 0.5, -0.5, -1.5}) {
        const OffsetCurves result = offset_of(flower, d, 1e-4);
        expect_at_distance(flower, result.curves, std::abs(d), 1e-4);
        expect_complete(flower, result.curves, d, 2e-4);
        for (const Curve& curve : result.curves) EXPECT_GT(enclosed_area(curve)->signed_area, 0.0);
    }
}

TEST(OffsetShape, caps_close_both_sides) {
    const Curve straight = line({0, 0}, {5, 0}).value();
    const auto area = [&](OffsetCaps caps) {
        const auto curves = offset_of(straight, 1, 1e-6, OffsetSide::both, OffsetCorners::round, caps).curves;
        EXPECT_EQ(curves.size(), 1u);
        return area_of(curves);
    };
    EXPECT_NEAR(area(OffsetCaps::flat), 10.0, 1e-13);
    EXPECT_NEAR(area(OffsetCaps::round), 10.0 + pi, 1e-12);
    EXPECT_EQ(offset_of(straight, 1, 1e-6, OffsetSide::both).curves.size(), 2u);
    const auto around = offset_of(wave(), 0.7, 1e-4, OffsetSide::both, OffsetCorners::round, OffsetCaps::round).curves;
    expect_at_distance(wave(), around, 0.7, 1e-4);
    expect_complete(wave(), around, 0.7, 2e-4);
    expect_complete(wave(), around, -0.7, 2e-4);
    double whole = 0.0;
    for (const Curve& curve : around) whole += enclosed_area(curve)->signed_area;
    EXPECT_GT(whole, 0.0);
}

TEST(OffsetShape, of_curves_with_corners_that_are_round_elsewhere) {
    // Half a disc: an arc and its chord.
    const Curve half = combine({{disc({0, 0}, 2)}}, {{rectangle({-3, 0}, {3, 3})}}, ShapeOperation::intersect)->front();
    const auto inner = offset_of(half, 0.5, 1e-7).curves;
    ASSERT_EQ(inner.size(), 1u);
    // A segment of the circle of radius 1.5 above y = 0.5.
    const double angle = std::acos(0.5 / 1.5);
    EXPECT_NEAR(area_of(inner), 2.25 * (angle - std::sin(angle) * std::cos(angle)), 1e-9);
    EXPECT_NEAR(area_of(offset_of(half, 0.5, 1e-7, OffsetSide::right, OffsetCorners::round).curves),
                2 * pi + 0.5 * (4 + 2 * pi) + 0.25 * pi, 1e-9);
}

// A cusp is a corner that turns back: an arc goes around it.
TEST(OffsetShape, goes_around_a_cusp) {
    const Curve cusp =
        Curve::make({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{0, 0}, {2, 2}, {0, 2}, {2, 0}}})
            .value();
    for (const OffsetSide side : {OffsetSide::left, OffsetSide::right}) {
        const auto result = offset_of(cusp, 0.2, 1e-5, side, OffsetCorners::round).curves;
        expect_at_distance(cusp, result, 0.2, 1e-5);
        const bool is_outside = side == OffsetSide::left;
        EXPECT_EQ(distance_to(result, {1.0, 1.7}) < 1e-5, is_outside);
    }
}

TEST(OffsetShape, at_any_size_and_place) {
    for (const double size : {1e-6, 1e6})
        for (const double away : {0.0, 1e3}) {
            std::vector<Point> points;
            for (const Point p : {Point(0, 0), Point(2, 1.5), Point(4, -1), Point(6, 2), Point(9, 0)})
                points.push_back({size * (p.x + away), size * (p.y - away)});
            const Curve source = interpolate(points).value().curve;
            const OffsetCurves result = offset_of(source, 0.9 * size, 1e-5 * size);
            expect_at_distance(source, result.curves, 0.9 * size, 1.1e-5 * size);
        }
}

TEST(OffsetShape, refuses) {
    EXPECT_EQ(offset_shape(wave(), {0.1, 0.0}).error().code, CurveErrorCode::tolerance_not_positive);
    EXPECT_EQ(offset_shape(wave(), {Box::infinity, 1e-3}).error().code, CurveErrorCode::vector_not_finite);
    EXPECT_EQ(offset_shape(wave(), {0.0, 1e-3})->curves, std::vector{wave()});
}

}  // namespace
}  // namespace batten::core
