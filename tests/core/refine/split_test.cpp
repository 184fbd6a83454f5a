#include "core/refine/split.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/curve/knot_analysis.h"
#include "core/refine/clamping.h"
#include "tests/core/known_curves.h"
#include "tests/core/shape_check.h"

namespace batten::core {
namespace {

TEST(Split, keeps_the_shape_and_the_outer_ends) {
    RandomCurves random(331);
    for (int k = 0; k < 400; ++k) {
        const Curve curve = random.open_curve();
        const double u = random.parameter(curve);
        const auto parts = split(curve, u);
        if (u == curve.domain().lower || u == curve.domain().upper) {
            EXPECT_EQ(parts.error().code, CurveErrorCode::parameter_at_end);
            continue;
        }
        ASSERT_EQ(parts->size(), 2U);
        const Curve& left = parts->front();
        const Curve& right = parts->back();
        EXPECT_EQ(left.domain(), (Interval{curve.domain().lower, u}));
        EXPECT_EQ(right.domain(), (Interval{u, curve.domain().upper}));
        EXPECT_EQ(left.control_points().back(), right.control_points().front());
        EXPECT_EQ(left.control_points().front(), curve.control_points().front());
        EXPECT_EQ(right.control_points().back(), curve.control_points().back());
        EXPECT_EQ(is_clamped_at(left.knots(), CurveEnd::start), is_clamped_at(curve.knots(), CurveEnd::start));
        EXPECT_TRUE(is_clamped_at(left.knots(), CurveEnd::end));
        EXPECT_LE(shape_change(curve, left, random), 1e-14);
        EXPECT_LE(shape_change(curve, right, random), 1e-14);
    }
}

TEST(Split, opens_a_periodic_curve_into_one) {
    RandomCurves random(332);
    for (int k = 0; k < 300; ++k) {
        const Curve curve = random.periodic_curve();
        const double u = random.parameter(curve);
        const auto parts = split(curve, u).value();
        ASSERT_EQ(parts.size(), 1U);
        EXPECT_TRUE(is_clamped(parts[0].knots()));
        EXPECT_EQ(parts[0].domain().lower, u);
        EXPECT_NEAR(parts[0].domain().length(), curve.domain().length(), 1e-14);
        EXPECT_EQ(parts[0].control_points().front(), parts[0].control_points().back());
        EXPECT_LE(shape_change(curve, parts[0], random), 1e-13);
    }
}

TEST(Split, at_a_tear_gives_both_sides_of_it) {
    const Curve torn = Curve::make({.degree = 2,
                                    .knots = {0, 0, 0, 1, 1, 1, 2, 2, 2},
                                    .points = {{0, 0}, {1, 2}, {2, 0}, {5, 0}, {6, 2}, {7, 0}},
                                    .tears = Tears::allow})
                           .value();
    const auto parts = split(torn, 1.0).value();
    EXPECT_EQ(parts[0].control_points().back(), Point(2, 0));
    EXPECT_EQ(parts[1].control_points().front(), Point(5, 0));
    EXPECT_EQ(split(torn, 0.5)->back().control_points().size(), 6U);
}

TEST(SubCurve, is_the_part_it_says) {
    RandomCurves random(333);
    for (int k = 0; k < 400; ++k) {
        const Curve curve = random.curve();
        const double a = random.parameter(curve);
        const double b = random.parameter(curve);
        const auto part = sub_curve(curve, a, b);
        if (!curve.is_periodic() && !(a < b)) {
            EXPECT_EQ(part.error(), (CurveError{.code = CurveErrorCode::range_empty, .lower = a, .upper = b}));
            continue;
        }
        ASSERT_TRUE(part) << describe(part.error());
        EXPECT_EQ(part->domain().lower, a);
        double end = b > a ? b : b + curve.domain().length();
        if (a == curve.domain().upper && b == curve.domain().lower) end = a + curve.domain().length();
        EXPECT_NEAR(part->domain().upper, end, 1e-13);
        EXPECT_FALSE(part->is_periodic());
        EXPECT_LE(shape_change(curve, *part, random), 1e-13);
    }
}

TEST(SubCurve, of_the_whole_domain_is_the_curve) {
    RandomCurves random(334);
    const Curve curve = random.open_curve();
    EXPECT_EQ(sub_curve(curve, curve.domain().lower, curve.domain().upper).value(), curve);
}

TEST(SubCurve, refuses_parameters_outside) {
    using Code = CurveErrorCode;
    RandomCurves random(335);
    const Curve open = random.open_curve();
    EXPECT_EQ(sub_curve(open, open.domain().lower - 1, open.domain().upper).error().code,
              Code::parameter_outside_domain);
    EXPECT_EQ(split(open, std::nan("")).error().code, Code::parameter_not_finite);
    EXPECT_EQ(split(open, open.domain().upper + 1).error().code, Code::parameter_outside_domain);
    const Curve ring = random.periodic_curve();
    EXPECT_EQ(sub_curve(ring, ring.domain().lower, ring.domain().upper + 1).error().code,
              Code::parameter_outside_domain);
    EXPECT_TRUE(sub_curve(ring, ring.domain().upper, ring.domain().upper + 0.5 * ring.domain().length()));
}

TEST(Split, a_part_of_one_span_is_no_longer_piecewise) {
    const auto pieces_of = [](KnotKind kind) {
        return Curve::make({.degree = 2,
                            .knots = {0, 0, 0, 1, 1, 2, 2, 3, 3, 3},
                            .points = {{0, 0}, {1, 2}, {2, 0}, {3, -2}, {4, 0}, {5, 3}, {6, 0}},
                            .kind = kind})
            .value();
    };
    const auto kinds = [](const Curve& curve, double u) {
        const auto parts = split(curve, u).value();
        return std::pair(parts.front().knots().kind(), parts.back().knots().kind());
    };
    using enum KnotKind;
    const Curve curve = pieces_of(piecewise_bezier);
    EXPECT_EQ(kinds(curve, 1.0), std::pair(bezier, piecewise_bezier));
    EXPECT_EQ(kinds(curve, 2.0), std::pair(piecewise_bezier, bezier));
    EXPECT_EQ(kinds(curve, 1.5), std::pair(piecewise_bezier, piecewise_bezier));
    EXPECT_EQ(kinds(curve, 0.5), std::pair(bezier, piecewise_bezier));
    EXPECT_EQ(kinds(pieces_of(custom), 1.0), std::pair(custom, custom)) << "which was chosen";
    EXPECT_EQ(sub_curve(curve, 1.0, 2.0)->knots().kind(), bezier);
    EXPECT_EQ(sub_curve(curve, 1.25, 1.5)->knots().kind(), bezier);
}

TEST(Split, works_far_away_in_high_degrees_and_next_to_knots) {
    RandomCurves random(336);
    for (const int degree : {9, 17, 25}) {
        const Curve curve = moved(high_degree_curve(degree, 5, random), {1e6, 1e6});
        for (const double u : {1e-9, curve.knots()[static_cast<std::size_t>(degree) + 2] + 1e-9}) {
            const auto parts = split(curve, u).value();
            EXPECT_LE(shape_change(curve, parts[0], random), 1e-15);
            EXPECT_LE(shape_change(curve, parts[1], random), 1e-15);
        }
    }
}

}  // namespace
}  // namespace batten::core
