#include "core/refine/clamping.h"

#include <gtest/gtest.h>

#include "core/curve/knot_analysis.h"
#include "core/curve/knot_kinds.h"
#include "tests/core/shape_check.h"

namespace batten::core {
namespace {

using Knots = std::vector<double>;

TEST(Clamping, keeps_the_shape_and_the_other_end) {
    RandomCurves random(321);
    for (int k = 0; k < 300; ++k) {
        const Curve curve = random.open_curve();
        const Curve start = clamp(curve, CurveEnd::start).value();
        EXPECT_TRUE(is_clamped_at(start.knots(), CurveEnd::start));
        EXPECT_EQ(is_clamped_at(start.knots(), CurveEnd::end), is_clamped_at(curve.knots(), CurveEnd::end));
        EXPECT_EQ(start.domain(), curve.domain());
        EXPECT_EQ(start.control_points().back(), curve.control_points().back());
        EXPECT_LE(shape_change(curve, start, random), 1e-14);
        const Curve both = clamp(start, CurveEnd::end).value();
        EXPECT_TRUE(is_clamped(both.knots()));
        EXPECT_LE(shape_change(curve, both, random), 1e-14);
        EXPECT_EQ(clamp(both, CurveEnd::end).value(), both);
    }
}

TEST(Clamping, of_a_uniform_cubic_by_hand) {
    // The end of a uniform cubic is (P0 + 4 P1 + P2) / 6, and its Bézier legs are (2 P1 + P2) / 3, (P1 + 2 P2) / 3.
    const Curve curve =
        Curve::make(make_knots(KnotKind::uniform, 3, 5).value(), {{0, 0}, {6, 12}, {12, 0}, {18, 6}, {24, 0}}, {})
            .value();
    const Curve clamped = clamp(curve, CurveEnd::start).value();
    EXPECT_EQ(clamped.control_points()[0], Point(6, 8));
    EXPECT_NEAR(clamped.control_points()[1].x, 8, 1e-14);
    EXPECT_NEAR(clamped.control_points()[1].y, 8, 1e-14);
    // Over two spans the third point is the mean of (P1 + 2 P2) / 3 and (2 P2 + P3) / 3 moved to the knots 0, 1, 2.
    EXPECT_NEAR(clamped.control_points()[2].x, 12, 1e-14);
    EXPECT_EQ(clamped.control_points()[3], Point(18, 6));
    EXPECT_EQ(clamp_ends(curve)->knots().kind(), KnotKind::clamped_uniform);
}

TEST(Unclamping, keeps_the_shape) {
    RandomCurves random(322);
    int kept = 0;
    for (int k = 0; k < 300; ++k) {
        const Curve curve = random.open_curve();
        for (const CurveEnd end : {CurveEnd::start, CurveEnd::end}) {
            const auto result = unclamp(curve, end);
            if (!result) {
                EXPECT_EQ(result.error().code, CurveErrorCode::outer_knots_too_far);
                continue;
            }
            ++kept;
            EXPECT_EQ(result->domain(), curve.domain());
            EXPECT_FALSE(is_clamped_at(result->knots(), end));
            EXPECT_LE(shape_change(curve, *result, random), 1e-11);
        }
    }
    EXPECT_GT(kept, 250);
}

TEST(Unclamping, makes_a_clamped_uniform_vector_uniform_and_back) {
    std::vector<Point> points{{0, 0}, {1, 5}, {2, -3}, {3, 4}, {4, 4}, {5, -5}, {6, 2}};
    const Curve uniform = Curve::make(make_knots(KnotKind::uniform, 3, 7, {0, 4}).value(), points, {}).value();
    const auto clamped = clamp_ends(uniform);
    EXPECT_EQ(clamped->knots().kind(), KnotKind::clamped_uniform);
    const auto back = unclamp_ends(*clamped);
    EXPECT_EQ(back->knots().kind(), KnotKind::uniform);
    EXPECT_EQ(stored(*back), (Knots{-3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 7}));
    EXPECT_LE(point_difference(uniform, *back), 1e-15);
}

TEST(Unclamping, leaves_an_even_curve_of_high_degree_as_it_is) {
    CurveDefinition definition{.degree = 18, .kind = KnotKind::uniform};
    for (int i = -18; i <= 21; ++i) definition.knots.push_back(i);
    for (int i = 0; i < 21; ++i) definition.points.emplace_back(i % 3, i % 4);
    const Curve curve = Curve::make(definition).value();
    for (const CurveEnd end : {CurveEnd::start, CurveEnd::end}) {
        const Curve same = unclamp(curve, end).value();
        EXPECT_EQ(stored(same), stored(curve));
        EXPECT_EQ(same.knots().kind(), KnotKind::uniform);
        EXPECT_LE(point_difference(curve, same), 1e-15);
    }
}

TEST(Unclamping, repeats_the_spans_of_the_domain_outside) {
    const Curve curve =
        Curve::make(
            {.degree = 2, .knots = {0, 0, 0, 1, 4, 6, 6, 6}, .points = {{0, 0}, {1, 1}, {2, 0}, {3, 1}, {4, 0}}})
            .value();
    EXPECT_EQ(stored(unclamp(curve, CurveEnd::start).value()), (Knots{-5, -2, 0, 1, 4, 6, 6, 6}));
    EXPECT_EQ(stored(unclamp(curve, CurveEnd::end).value()), (Knots{0, 0, 0, 1, 4, 6, 7, 10}));
}

TEST(Clamping, refuses_periodic_curves) {
    const Curve ring =
        Curve::make({.degree = 2, .knots = {0, 1, 2}, .points = {{0, 0}, {1, 2}}, .periodic = true}).value();
    EXPECT_EQ(clamp(ring, CurveEnd::start).error().code, CurveErrorCode::curve_periodic);
    EXPECT_EQ(unclamp(ring, CurveEnd::end).error().code, CurveErrorCode::curve_periodic);
}

TEST(Unclamping, of_a_rational_curve_says_how_far_the_knots_can_lie) {
    // The weight before the start is 1 + s (1 - w) for a knot s before it; the spans repeated outside are 1 long.
    const Curve curve =
        Curve::make(
            {.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {1, 1}, {2, 0}}, .weights = {1, 3, 1}})
            .value();
    for (const CurveEnd end : {CurveEnd::start, CurveEnd::end}) {
        const auto error = unclamp(curve, end).error();
        EXPECT_EQ(error.code, CurveErrorCode::outer_knots_too_far);
        EXPECT_EQ(error.value, 1.0);
        EXPECT_LE(error.upper, 0.5);
        EXPECT_NEAR(error.upper, 0.5, 2e-4);
    }
}

}  // namespace
}  // namespace batten::core
