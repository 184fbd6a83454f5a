#include "app/editor/words/continuity_words.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/curve/control_box.h"
#include "core/refine/knot_insertion.h"

namespace batten::editor {
namespace {

using core::Curve;
using core::JointContinuity;
using core::Point;

JointContinuity first_joint(const Curve& curve) {
    return core::joint_continuity(curve).front();
}

// Two cubics that meet in (3, 1), arriving from the left with the speed 6.
JointContinuity joint_of(Point next, Point next_but_one) {
    return first_joint(Curve::make({.degree = 3,
                                    .knots = {0, 0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1, 1},
                                    .points = {{0, 0}, {1, 2}, {2, 1}, {3, 1}, next, next_but_one, {7, 0}}})
                           .value());
}

TEST(ContinuityWords, of_a_knot_of_full_multiplicity) {
    const auto corner = joint_of({3, 2}, {6, 3});
    EXPECT_EQ(continuity_verdict(corner), "C⁰ by its knots, a corner by its shape");
    EXPECT_EQ(continuity_reason(corner, {}), "the direction turns by 90°");
    const auto bent = joint_of({5, 1}, {6, 3});
    EXPECT_EQ(continuity_verdict(bent), "C⁰ by its knots, G¹ by its shape");
    EXPECT_EQ(continuity_reason(bent, {}), "the same direction; 2 times as fast beyond it");
    const auto round = joint_of({5, 1}, {6, 5});
    EXPECT_EQ(continuity_verdict(round), "C⁰ by its knots, G² by its shape");
    EXPECT_EQ(continuity_reason(round, {}), "the same direction and curvature; 2 times as fast beyond it");
    const auto quick = joint_of({4, 1}, {5, 3});
    EXPECT_EQ(continuity_verdict(quick), "C⁰ by its knots, C¹ by its shape");
    EXPECT_EQ(continuity_reason(quick, {}), "C′ agrees; the curvature jumps from 2/3 to 4/3");
    const auto smooth = joint_of({4, 1}, {5, 2});
    EXPECT_EQ(continuity_verdict(smooth), "C⁰ by its knots, C² by its shape");
    EXPECT_EQ(continuity_reason(smooth, {}), "C′ and C″ agree");
    const auto slow = joint_of({3, 1}, {5, 1});
    EXPECT_EQ(continuity_verdict(slow), "C⁰ by its knots, G¹ by its shape");
    EXPECT_EQ(continuity_reason(slow, {}), "the same direction; the speed is zero on one side");
}

TEST(ContinuityWords, of_the_circle_of_nine_points) {
    const double w = std::sqrt(0.5);
    const Curve circle =
        Curve::make({.degree = 2,
                     .knots = {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1},
                     .points = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}},
                     .weights = {1, w, 1, w, 1, w, 1, w, 1}})
            .value();
    EXPECT_EQ(continuity_verdict(first_joint(circle)), "C⁰ by its knots, C¹ and G² by its shape");
    EXPECT_EQ(continuity_reason(first_joint(circle), {}), "C′ and the curvature agree; C″ jumps along the tangent");
    EXPECT_EQ(continuity_verdict(core::continuity_of_ends(circle)), "the ends meet with C¹ and G²");
    // With quarters that take different times the speed jumps, and the shape is the same.
    core::CurveDefinition uneven = circle.definition();
    uneven.knots = {0, 0, 0, 0.125, 0.125, 0.5, 0.5, 0.75, 0.75, 1, 1, 1};
    const auto joint = first_joint(Curve::make(uneven).value());
    EXPECT_EQ(continuity_verdict(joint), "C⁰ by its knots, G² by its shape");
    EXPECT_EQ(continuity_reason(joint, {}), "the same direction and curvature; 1/3 times as fast beyond it");
}

TEST(ContinuityWords, of_simple_knots_and_cusps) {
    const Curve cubic =
        Curve::make(
            {.degree = 3, .knots = {0, 0, 0, 0, 1, 2, 2, 2, 2}, .points = {{0, 0}, {1, 2}, {2, 1}, {3, 1}, {5, 0}}})
            .value();
    EXPECT_EQ(continuity_verdict(first_joint(cubic)), "C² by its knots");
    EXPECT_EQ(continuity_reason(first_joint(cubic), {}), "C′ and C″ agree");
    const Curve cusp = Curve::make({.degree = 3,
                                    .knots = {-1, -1, -1, -1, 1, 1, 1, 1},
                                    .points = {{1, -1}, {-1.0 / 3, 1}, {-1.0 / 3, -1}, {1, 1}}})
                           .value();
    const auto joint = first_joint(core::insert_knot(cusp, 0.0).value());
    EXPECT_EQ(continuity_verdict(joint), "C² by its knots, a cusp by its shape");
    EXPECT_EQ(continuity_reason(joint, {}), "the speed falls to zero, and the curve turns back");
}

TEST(ContinuityWords, of_tears_that_gape_and_that_do_not) {
    const auto torn = [](Point after) {
        return first_joint(Curve::make({.degree = 1,
                                        .knots = {0, 0, 1, 1, 2, 2},
                                        .points = {{0, 0}, {1, 0}, after, {2, 0}},
                                        .tears = core::Tears::allow})
                               .value());
    };
    EXPECT_EQ(continuity_verdict(torn({1, 3})), "torn by its knots, a gap by its shape");
    EXPECT_EQ(continuity_reason(torn({1, 3}), {}), "a gap of 3");
    EXPECT_EQ(continuity_verdict(torn({1, 0})), "torn by its knots, C² by its shape");
}

TEST(ContinuityWords, of_two_curves) {
    const auto between = [](Point beside) {
        const Curve first = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {1, 0}}}).value();
        const Curve second =
            Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{1, 0}, beside, {4, 1}}}).value();
        return core::continuity_between(first, second, {}, {{0, 0}, {4, 3}});
    };
    EXPECT_EQ(continuity_verdict(between({1, 3})), "the curves meet in a corner");
    EXPECT_EQ(continuity_verdict(between({3, 0})), "the curves meet with G¹");
    EXPECT_EQ(continuity_reason(between({3, 0}), {}), "the same direction; 4 times as fast beyond it");
    EXPECT_EQ(continuity_verdict(between({1.5, 0})), "the curves meet with C¹");
    EXPECT_EQ(continuity_verdict(between({0, 0})), "the curves meet in a cusp");
}

}  // namespace
}  // namespace batten::editor
