#include "core/refine/trim.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/evaluate/evaluate.h"
#include "core/make/conics.h"
#include "core/make/shapes.h"
#include "core/measure/continuity.h"
#include "core/measure/nearest.h"
#include "core/refine/periodic.h"
#include "core/refine/reverse.h"
#include "tests/core/shape_check.h"

namespace batten::core {
namespace {

TEST(Trim, finds_where_curves_cross) {
    for (const double size : {1e-6, 1.0, 1e6}) {
        const Curve horizontal = line({-4 * size, 0}, {4 * size, 0}).value();
        const Curve ring = circle({0, 0}, size).value();
        const Curve upright = line({3 * size, -size}, {3 * size, size}).value();
        const std::vector<const Curve*> others{&ring, &upright};
        const auto cuts = crossing_parameters(horizontal, others);
        ASSERT_EQ(cuts.size(), 3u);
        EXPECT_NEAR(cuts[0], 3.0 / 8, 1e-13);
        EXPECT_NEAR(cuts[1], 5.0 / 8, 1e-13);
        EXPECT_NEAR(cuts[2], 7.0 / 8, 1e-13);
    }
    // A loop: (t^2 - 1, t^3 - t) passes (0, 0) at -1 and 1.
    const Curve loop =
        Curve::make({.degree = 3,
                     .knots = {-2, -2, -2, -2, 2, 2, 2, 2},
                     .points = {{3, -6}, {3 - 16.0 / 3, -6 + 44.0 / 3}, {3 - 16.0 / 3, 6 - 44.0 / 3}, {3, 6}}})
            .value();
    const auto cuts = crossing_parameters(loop, {});
    ASSERT_EQ(cuts.size(), 2u);
    EXPECT_NEAR(cuts[0], -1, 1e-12);
    EXPECT_NEAR(cuts[1], 1, 1e-12);
}

TEST(Trim, removes_the_part_between_the_crossings_around_a_place) {
    const Curve curve = line({0, 0}, {8, 0}).value();
    const std::vector<double> cuts{0.25, 0.5, 0.75};
    EXPECT_EQ(part_around(curve, 0.6, cuts).value(), (Interval{0.5, 0.75}));
    EXPECT_EQ(part_around(curve, 0.1, cuts).value(), (Interval{0.0, 0.25}));
    EXPECT_EQ(part_around(curve, 1.0, cuts).value(), (Interval{0.75, 1.0}));
    const auto inside = without_part(curve, {0.5, 0.75}).value();
    ASSERT_EQ(inside.size(), 2u);
    EXPECT_EQ(inside[0].control_points().back(), Point(4, 0));
    EXPECT_EQ(inside[1].control_points().front(), Point(6, 0));
    EXPECT_EQ(inside[1].control_points().back(), Point(8, 0));
    EXPECT_EQ(without_part(curve, {0.0, 0.25}).value().size(), 1u);
    EXPECT_EQ(part_around(curve, 0.5, {}).error().code, CurveErrorCode::nothing_crosses);
}

TEST(Trim, of_a_periodic_curve_goes_round_the_seam) {
    const Curve ring = to_periodic(circle({0, 0}, 1).value(), 1e-9).value().curve;
    const Curve upright = line({0.5, -2}, {0.5, 2}).value();
    const std::vector<const Curve*> others{&upright};
    const auto cuts = crossing_parameters(ring, others);
    ASSERT_EQ(cuts.size(), 2u);
    // The right part, around the seam at (1, 0), goes: what is left runs from +60 to -60 degrees.
    for (const double u : {0.0, 0.01, 0.99, 1.0}) {
        const auto left = without_part(ring, part_around(ring, u, cuts).value()).value();
        ASSERT_EQ(left.size(), 1u);
        EXPECT_NEAR(left[0].control_points().front().y, std::sqrt(0.75), 1e-12);
        EXPECT_NEAR(left[0].control_points().back().y, -std::sqrt(0.75), 1e-12);
        EXPECT_NEAR(point_at(left[0], left[0].domain().lower + 0.5 * left[0].domain().length()).x, -1, 1e-9);
    }
    const auto right = without_part(ring, part_around(ring, 0.5, cuts).value()).value();
    EXPECT_NEAR(right[0].control_points().front().y, -std::sqrt(0.75), 1e-12);
    EXPECT_EQ(part_around(ring, 0.5, std::vector{0.3}).error().code, CurveErrorCode::nothing_crosses);
    EXPECT_EQ(split_at(ring, cuts).value().size(), 2u);
}

// The ends of the circle meet at (1, 0), where nothing crosses.
TEST(Trim, of_a_curve_whose_ends_meet_goes_round_the_seam_too) {
    const Curve ring = circle({0, 0}, 1).value();
    const Curve upright = line({-0.5, -2}, {-0.5, 2}).value();
    const std::vector<const Curve*> others{&upright};
    const auto cuts = crossing_parameters(ring, others);
    ASSERT_EQ(cuts.size(), 2u);
    // The left part goes: what is left runs from 240 degrees over the seam to 120 degrees.
    const auto left = without_part(ring, part_around(ring, 0.5, cuts).value()).value();
    ASSERT_EQ(left.size(), 1u);
    EXPECT_LE(distance(left[0].control_points().front(), Point(-0.5, -std::sqrt(0.75))), 1e-14);
    EXPECT_LE(distance(left[0].control_points().back(), Point(-0.5, std::sqrt(0.75))), 1e-14);
    EXPECT_LE(distance(point_at(left[0], 1.0), Point(1, 0)), 1e-14);
    for (int i = 0; i <= 40; ++i) {
        const double u = left[0].domain().lower + left[0].domain().length() * i / 40.0;
        const Point p = point_at(left[0], u);
        EXPECT_NEAR(std::hypot(p.x, p.y), 1.0, 1e-14);
        EXPECT_GE(p.x, -0.5 - 1e-14);
    }
    // The right part goes, picked on either side of the seam.
    for (const double u : {0.0, 0.1, 0.9, 1.0}) {
        const auto rest = without_part(ring, part_around(ring, u, cuts).value()).value();
        ASSERT_EQ(rest.size(), 1u);
        EXPECT_LE(distance(rest[0].control_points().front(), Point(-0.5, std::sqrt(0.75))), 1e-14);
        EXPECT_LE(distance(rest[0].control_points().back(), Point(-0.5, -std::sqrt(0.75))), 1e-14);
    }
    const auto halves = split_at(ring, cuts).value();
    ASSERT_EQ(halves.size(), 2u);
    EXPECT_EQ(halves[0], left[0]) << "the one over the seam";
    EXPECT_EQ(halves[1].domain(), (Interval{cuts[0], cuts[1]}));
    EXPECT_EQ(part_around(ring, 0.5, std::vector{0.3}).error().code, CurveErrorCode::nothing_crosses);
}

TEST(Trim, at_the_seam_itself_cuts_there) {
    const Curve ring = circle({0, 0}, 1).value();
    const Curve level = line({-2, 0}, {2, 0}).value();
    const std::vector<const Curve*> others{&level};
    const auto cuts = crossing_parameters(ring, others);
    ASSERT_EQ(cuts.size(), 2u);
    EXPECT_EQ(cuts[0], 0.0);
    EXPECT_NEAR(cuts[1], 0.5, 1e-13);
    for (const double u : {0.2, 0.8}) {
        const auto rest = without_part(ring, part_around(ring, u, cuts).value()).value();
        ASSERT_EQ(rest.size(), 1u);
        const double half = rest[0].domain().lower + 0.5 * rest[0].domain().length();
        EXPECT_LE(distance(point_at(rest[0], half), Point(0, u < 0.5 ? -1 : 1)), 1e-12);
    }
    EXPECT_EQ(split_at(ring, cuts).value().size(), 2u);
}

TEST(Trim, splits_at_crossings_and_keeps_the_shape) {
    RandomCurves random(771);
    for (int k = 0; k < 30; ++k) {
        const Curve curve = random.curve();
        const Curve other = random.open_curve();
        const std::vector<const Curve*> others{&other};
        const auto cuts = crossing_parameters(curve, others);
        const auto parts = split_at(curve, cuts).value();
        EXPECT_EQ(parts.size(), is_closed(curve) ? std::max<std::size_t>(1, cuts.size()) : cuts.size() + 1);
        for (const Curve& part : parts)
            for (int i = 0; i <= 10; ++i) {
                const double u = part.domain().lower + part.domain().length() * i / 10.0;
                EXPECT_LE(distance(point_at(part, u), point_at(curve, u)), 1e-11);
            }
    }
}

TEST(ExtendTo, ends_on_the_other_curve) {
    for (const double size : {1e-6, 1.0, 1e6})
        for (const bool is_turned : {false, true}) {
            Curve side = line({0, 0}, {size, size}).value();
            if (is_turned) side = reverse(side).value();
            const Curve ring = circle({5 * size, 5 * size}, size).value();
            const CurveEnd end = is_turned ? CurveEnd::start : CurveEnd::end;
            for (const Onward onward : {Onward::natural, Onward::straight}) {
                const Curve longer = extend_to(side, end, ring, onward).value();
                const Point tip = point_at(longer, parameter_of(longer.domain(), end));
                EXPECT_NEAR(tip.x / size, 5 - std::sqrt(0.5), 1e-12);
                EXPECT_NEAR(tip.y / size, 5 - std::sqrt(0.5), 1e-12);
                EXPECT_LE(distance(point_at(longer, 0.5), point_at(side, 0.5)), 1e-15 * size);
            }
        }
}

TEST(ExtendTo, goes_on_as_the_curve_does_or_straight) {
    // A sixth of the unit circle from the top on: naturally it comes down to the wall, straight on it passes above.
    const Curve arc = circular_arc({0, 0}, 1, {30, 60}).value();
    const Curve wall = line({-0.5, -3}, {-0.5, 0.95}).value();
    const Curve axis = line({-3, 0}, {-0.5, 0}).value();
    const Curve round = extend_to(arc, CurveEnd::end, wall, Onward::natural).value();
    EXPECT_LE(distance(point_at(round, round.domain().upper), Point(-0.5, std::sqrt(0.75))), 1e-12);
    EXPECT_EQ(extend_to(arc, CurveEnd::end, wall, Onward::straight).error().code, CurveErrorCode::other_not_reached);
    // One that ends there stays.
    const Curve touching = line({-1, 1}, {-1, 0}).value();
    EXPECT_EQ(extend_to(touching, CurveEnd::end, axis, Onward::natural).value(), touching);
    const Curve ring = to_periodic(circle({0, 0}, 1).value(), 1e-9).value().curve;
    EXPECT_EQ(extend_to(ring, CurveEnd::end, axis, Onward::natural).error().code, CurveErrorCode::curve_periodic);
}

}  // namespace
}  // namespace batten::core
