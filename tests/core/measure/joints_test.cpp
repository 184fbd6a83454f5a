#include "core/measure/joints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/make/conics.h"
#include "core/make/shapes.h"
#include "core/refine/reverse.h"

namespace batten::core {
namespace {

TEST(Joints, of_a_rounded_path_are_its_ends_and_corners) {
    // Two lines with a quarter of a circle between them, and an angle that meets nothing.
    const Curve first = line({-3, -1}, {0, -1}).value();
    const Curve arc = circular_arc({0, 0}, 1, {270, 90}).value();
    const Curve second = line({1, 3}, {1, 0}).value();
    const Curve angle = polyline(std::vector<Point>{{10, 0}, {12, 0}, {12, 5}}).value();
    const std::vector<const Curve*> curves{&first, &arc, &second, &angle};
    const auto joints = joints_of(curves, 1e-6);
    ASSERT_EQ(joints.size(), 3u);
    EXPECT_EQ(joints[0].first.curve, 0u);
    EXPECT_EQ(joints[0].second.curve, 1u);
    EXPECT_EQ(joints[0].level, 1);
    EXPECT_EQ(*joints[0].meeting.before, 0.0);
    EXPECT_NEAR(*joints[0].meeting.after, 1.0, 1e-14);
    // End to end: run through into the line its curvature is 0 behind that of the arc.
    EXPECT_EQ(joints[1].first.curve, 1u);
    EXPECT_EQ(joints[1].first.u, 1.0);
    EXPECT_EQ(joints[1].second.curve, 2u);
    EXPECT_EQ(joints[1].second.u, 1.0);
    EXPECT_NEAR(*joints[1].meeting.before, 1.0, 1e-14);
    EXPECT_NEAR(*joints[1].meeting.angle, 0.0, 1e-14);
    EXPECT_EQ(joints[1].level, 1);
    EXPECT_FALSE(joints[2].first.is_end);
    EXPECT_EQ(joints[2].level, 0);
    EXPECT_NEAR(*joints[2].meeting.angle, 0.5 * std::numbers::pi, 1e-15);
}

TEST(Joints, are_told_within_the_tolerance_only) {
    const Curve first = line({0, 0}, {1, 0}).value();
    const Curve second = line({1.01, 0}, {2, 0}).value();
    const std::vector<const Curve*> curves{&first, &second};
    EXPECT_TRUE(joints_of(curves, 0.009).empty());
    const auto joints = joints_of(curves, 0.011);
    ASSERT_EQ(joints.size(), 1u);
    EXPECT_NEAR(joints[0].meeting.gap, 0.01, 1e-15);
    EXPECT_EQ(joints[0].level, -1);
}

TEST(Joints, of_many_curves_are_found_in_all_of_them) {
    std::vector<Curve> chain;
    for (int k = 0; k < 500; ++k) {
        const double x = 0.01 * k;
        const Curve piece = line({x, 1e6}, {x + 0.01, 1e6}).value();
        chain.push_back(k % 3 == 0 ? reverse(piece).value() : piece);
    }
    std::vector<const Curve*> curves;
    for (const Curve& curve : chain) curves.push_back(&curve);
    const auto joints = joints_of(curves, 1e-9);
    ASSERT_EQ(joints.size(), 499u);
    for (const Joint& joint : joints) EXPECT_EQ(joint.level, 3);
}

TEST(Joints, of_one_ring_is_where_its_ends_meet) {
    const Curve ring = circle({2, 3}, 5).value();
    const auto joints = joints_of(std::vector<const Curve*>{&ring}, 1e-6);
    ASSERT_EQ(joints.size(), 1u);
    EXPECT_EQ(joints[0].level, 3);
    EXPECT_EQ(joints[0].first.u, 1.0);
    EXPECT_EQ(joints[0].second.u, 0.0);
    const Curve teeth =
        Curve::make({.degree = 1, .knots = {0, 1, 2, 3}, .points = {{0, 0}, {1, 0}, {0, 1}}, .periodic = true}).value();
    EXPECT_EQ(joints_of(std::vector<const Curve*>{&teeth}, 1e-6).size(), 3u);
}

TEST(Joints, are_those_of_each_end_with_the_nearest_one_and_with_all_that_it_meets) {
    // Three lines end in (0, 0), a fourth 0.25 above, a fifth 1 to the right of that.
    std::vector<Curve> lines;
    for (const Point far : {Point(-9, 0), Point(0, -9), Point(-9, -9)}) lines.push_back(line(far, {0, 0}).value());
    lines.push_back(line({0, 0.25}, {0, 90}).value());
    lines.push_back(line({1, 0.25}, {90, 0.25}).value());
    std::vector<const Curve*> curves;
    for (const Curve& curve : lines) curves.push_back(&curve);
    const auto pairs = [&](double tolerance) {
        std::vector<std::pair<std::size_t, std::size_t>> found;
        for (const Joint& joint : joints_of(curves, tolerance))
            found.emplace_back(joint.first.curve, joint.second.curve);
        return found;
    };
    using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
    EXPECT_EQ(pairs(1e-6), (Pairs{{0, 1}, {0, 2}, {1, 2}}));
    const Pairs near = pairs(1.0);
    EXPECT_EQ(near.size(), 5U);
    EXPECT_TRUE(std::ranges::find(near, std::pair<std::size_t, std::size_t>(3, 4)) != near.end());
    EXPECT_EQ(std::ranges::count_if(near, [](auto pair) { return pair.first < 3 && pair.second == 3; }), 1);
}

TEST(Joints, of_a_thousand_curves_within_any_distance_are_no_more_than_ends) {
    std::vector<Curve> lines;
    for (int k = 0; k < 1000; ++k) {
        const Point from(std::fmod(k * 0.618033988749895, 1.0), std::fmod(k * 0.754877666246693, 1.0));
        lines.push_back(line(from, {from.x + 1e-3, from.y + 2e-3}).value());
    }
    std::vector<const Curve*> curves;
    for (const Curve& curve : lines) curves.push_back(&curve);
    const auto joints = joints_of(curves, 1e9);
    EXPECT_LE(joints.size(), 2000U);
    EXPECT_GE(joints.size(), 1000U);
    for (const Joint& joint : joints) EXPECT_LT(joint.meeting.gap, 0.1);
}

}  // namespace
}  // namespace batten::core
