#include "core/measure/smoothness.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/edit/point_edit.h"
#include "core/refine/knot_insertion.h"

namespace batten::core {
namespace {

// Two cubic pieces that meet at (3, 1), u = 1/2, straight on and without curvature.
Curve keel() {
    return Curve::make({.degree = 3,
                        .knots = {0, 0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1, 1},
                        .points = {{0, 0}, {1, 1}, {2, 1}, {3, 1}, {4, 1}, {5, 1}, {6, 0}}})
        .value();
}

TEST(SmoothnessLosses, of_the_same_curve_are_none) {
    EXPECT_TRUE(smoothness_losses(keel(), keel()).empty());
    EXPECT_TRUE(smoothness_losses(keel(), insert_knot(keel(), 0.25).value()).empty());
}

TEST(SmoothnessLosses, tell_a_corner) {
    const auto losses = smoothness_losses(keel(), set_control_point(keel(), 4, {4, 2}).value());
    ASSERT_EQ(losses.size(), 1U);
    EXPECT_EQ(losses[0].after.u, 0.5);
    EXPECT_EQ(losses[0].before, 2);
    EXPECT_EQ(losses[0].after.geometric, 0);
    EXPECT_NEAR(*losses[0].after.angle, std::numbers::pi / 4, 1e-15);
    // What is a corner already loses nothing.
    const Curve corner = set_control_point(keel(), 4, {4, 2}).value();
    EXPECT_TRUE(smoothness_losses(corner, set_control_point(keel(), 4, {4, 3}).value()).empty());
}

TEST(SmoothnessLosses, tell_a_jump_of_the_curvature) {
    const auto losses = smoothness_losses(keel(), set_control_point(keel(), 5, {5, 1.5}).value());
    ASSERT_EQ(losses.size(), 1U);
    EXPECT_EQ(losses[0].after.geometric, 1);
    EXPECT_NEAR(*losses[0].after.before, 0.0, 1e-15);
    // 2/3 h / l^2 of a cubic, h being how far P2 is off the tangent.
    EXPECT_NEAR(*losses[0].after.after, 2.0 / 3.0 * 0.5, 1e-15);
}

// A square with rounded corners: four cubic pieces that begin and end straight in (1, 0).
Curve ring() {
    return Curve::make({.degree = 3,
                        .knots = {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4, 4},
                        .points = {{1, 0},
                                   {1, 0.5},
                                   {0.5, 1},
                                   {0, 1},
                                   {-0.5, 1},
                                   {-1, 0.5},
                                   {-1, 0},
                                   {-1, -0.5},
                                   {-0.5, -1},
                                   {0, -1},
                                   {0.5, -1},
                                   {1, -0.5},
                                   {1, 0}}})
        .value();
}

TEST(SmoothnessLosses, tell_a_corner_where_the_ends_meet) {
    const auto losses = smoothness_losses(ring(), set_control_point(ring(), 11, {1.5, -0.5}).value());
    ASSERT_EQ(losses.size(), 1U);
    EXPECT_EQ(losses[0].after.kind, JointKind::ends);
    EXPECT_EQ(losses[0].after.u, 0.0);
    EXPECT_EQ(losses[0].after.geometric, 0);
    EXPECT_NEAR(std::abs(*losses[0].after.angle), std::numbers::pi / 4, 1e-15);
}

TEST(SmoothnessLosses, tell_that_ends_no_longer_meet) {
    const Curve torn = set_control_point(ring(), 12, {1, 0.25}).value();
    const auto losses = smoothness_losses(ring(), torn);
    ASSERT_EQ(losses.size(), 1U);
    EXPECT_EQ(losses[0].after.geometric, -1);
    EXPECT_EQ(losses[0].after.position.size, 0.25);
    // Ends that are apart have nothing to lose.
    EXPECT_TRUE(smoothness_losses(torn, set_control_point(ring(), 12, {1, 0.375}).value()).empty());
}

}  // namespace
}  // namespace batten::core
