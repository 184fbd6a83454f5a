#include "core/measure/closing.h"

#include <gtest/gtest.h>

#include "core/make/conics.h"
#include "core/refine/periodic.h"
#include "tests/core/random_curves.h"

namespace batten::core {

namespace {

Curve ring(std::vector<double> knots = {0, 1, 2, 3, 4}) {
    return Curve::make(
               {.degree = 3, .knots = std::move(knots), .points = {{0, 0}, {4, 0}, {4, 4}, {0, 5}}, .periodic = true})
        .value();
}

Curve moved_end(const Curve& curve, double by) {
    CurveDefinition definition = curve.definition();
    definition.points.back().x += by;
    return Curve::make(std::move(definition)).value();
}

}  // namespace

TEST(Closing, tells_the_three_kinds_apart) {
    EXPECT_EQ(closing_of(ring()).closing, Closing::periodic);
    EXPECT_EQ(closing_of(ring()).continuity, 2);
    EXPECT_EQ(closing_of(ring({0, 0, 2, 3, 4})).continuity, 1);
    const Curve wrapped = to_wrapped(ring(), 1e-9)->curve;
    EXPECT_EQ(closing_of(wrapped).closing, Closing::wrapped);
    EXPECT_EQ(closing_of(wrapped).continuity, 2);
    const Curve clamped = to_clamped(ring()).value();
    EXPECT_EQ(closing_of(clamped).closing, Closing::ends_meet);
    EXPECT_EQ(closing_of(clamped).continuity, 2);
    EXPECT_EQ(closing_of(clamped).gap, 0.0);
    EXPECT_EQ(closing_of(moved_end(clamped, 0.5)).closing, Closing::open);
    EXPECT_NEAR(closing_of(moved_end(clamped, 0.5)).gap, 0.5, 1e-15);
    EXPECT_EQ(closing_of(moved_end(clamped, 0.5)).continuity, -1);
}

TEST(Closing, tolerance_is_relative_to_the_size) {
    const Curve clamped = to_clamped(ring()).value();
    EXPECT_EQ(closing_of(moved_end(clamped, 4e-9)).closing, Closing::ends_meet);
    EXPECT_EQ(closing_of(moved_end(clamped, 6e-9)).closing, Closing::open);
    EXPECT_EQ(closing_of(moved_end(clamped, 6e-9), 1e-8).closing, Closing::ends_meet);
}

TEST(Closing, wrapped_points_over_other_knots_are_not_wrapped) {
    CurveDefinition definition = to_wrapped(ring(), 1e-9)->curve.definition();
    definition.knots[0] -= 0.5;
    // The first knot of an unclamped curve acts on nothing, but the copy does not repeat.
    EXPECT_NE(closing_of(Curve::make(definition).value()).closing, Closing::wrapped);
    definition = to_wrapped(ring(), 1e-9)->curve.definition();
    definition.weights[1] = 2.0;
    EXPECT_NE(closing_of(Curve::make(definition).value()).closing, Closing::wrapped);
}

TEST(Closing, measures_a_corner_and_a_circle) {
    const auto drop =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 2, 2, 2}, .points = {{0, 0}, {2, 1}, {-2, 1}, {0, 0}}}).value();
    EXPECT_EQ(closing_of(drop).closing, Closing::ends_meet);
    EXPECT_EQ(closing_of(drop).continuity, 0);
    EXPECT_EQ(closing_of(circle({0, 0}, 1).value()).continuity, 1);
}

TEST(Closing, is_found_on_huge_and_tiny_domains_and_far_away) {
    RandomCurves random(321);
    for (int k = 0; k < 100; ++k) {
        CurveDefinition definition = random.periodic_curve().definition();
        const double scale = k % 2 == 0 ? 1e-9 : 1e9;
        for (double& knot : definition.knots) knot *= scale;
        for (Point& point : definition.points) point += Vector(1e6, -1e6);
        const Curve curve = Curve::make(std::move(definition)).value();
        EXPECT_EQ(closing_of(to_wrapped(curve, 1e-6)->curve).closing, Closing::wrapped) << k;
        EXPECT_NE(closing_of(to_clamped(curve).value()).closing, Closing::open) << k;
    }
}

}  // namespace batten::core
