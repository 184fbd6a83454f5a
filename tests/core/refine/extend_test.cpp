#include "core/refine/extend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/make/conics.h"
#include "core/measure/arc_length.h"
#include "core/refine/detail/largest_possible.h"
#include "core/refine/split.h"
#include "tests/core/shape_check.h"

namespace batten::core {
namespace {

constexpr CurveEnd both[]{CurveEnd::start, CurveEnd::end};

TEST(Extend, goes_on_as_the_same_polynomial) {
    // The parabola (u, u²) over [0, 1], continued.
    const Curve parabola =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {0.5, 0}, {1, 1}}}).value();
    const Curve longer = extend_parameter(parabola, CurveEnd::end, 2.0).value();
    EXPECT_EQ(longer.domain(), (Interval{0, 3}));
    EXPECT_EQ(longer.control_points()[1], Point(1.5, 0));
    EXPECT_EQ(longer.control_points()[2], Point(3, 9));
    const Curve earlier = extend_parameter(parabola, CurveEnd::start, 1.0).value();
    EXPECT_EQ(earlier.domain(), (Interval{-1, 1}));
    EXPECT_EQ(earlier.control_points()[0], Point(-1, 1));
    EXPECT_EQ(earlier.control_points()[1], Point(0, -1));
}

TEST(Extend, keeps_what_was_there) {
    RandomCurves random(381);
    int extended = 0;
    for (int k = 0; k < 300; ++k) {
        const Curve curve = random.open_curve();
        for (const CurveEnd end : both) {
            const auto longer = extend_parameter(curve, end, 0.05);
            if (!longer) {
                EXPECT_EQ(longer.error().code, CurveErrorCode::extension_too_far);
                EXPECT_LT(longer.error().upper, 0.05);
                EXPECT_TRUE(longer.error().upper == 0.0 || extend_parameter(curve, end, longer.error().upper));
                continue;
            }
            ++extended;
            const Curve old_part = sub_curve(*longer, curve.domain().lower, curve.domain().upper).value();
            EXPECT_LE(shape_change(curve, old_part, random), 1e-11);
            EXPECT_NEAR(longer->domain().length(), curve.domain().length() + 0.05, 1e-14);
        }
    }
    EXPECT_GT(extended, 500);
}

TEST(Extend, by_arc_length_meets_it) {
    RandomCurves random(382);
    int extended = 0;
    for (int k = 0; k < 60; ++k) {
        const Curve curve = random.open_curve();
        for (const CurveEnd end : both) {
            const auto longer = extend_length(curve, end, 0.5);
            if (!longer) continue;
            ++extended;
            const double u = end == CurveEnd::start ? curve.domain().lower : curve.domain().upper;
            const double length = end == CurveEnd::start ? arc_length(*longer, longer->domain().lower, u).value
                                                         : arc_length(*longer, u, longer->domain().upper).value;
            EXPECT_NEAR(length, 0.5, 1e-10);
        }
    }
    EXPECT_GT(extended, 90);
}

TEST(Extend, goes_on_as_the_same_polynomial_of_high_degree) {
    // Exact fractions, rounded once.
    CurveDefinition definition{.degree = 18};
    for (int i = -18; i <= 21; ++i) definition.knots.push_back(i);
    definition.points = {{2, 3},   {-1, -1}, {-2, 1}, {-3, 1}, {0, 0},  {3, -3},  {3, 3},
                         {-3, 1},  {0, 0},   {2, -3}, {1, -3}, {-3, 1}, {-3, -1}, {1, 3},
                         {-2, -2}, {-2, -3}, {0, 2},  {3, 3},  {1, 1},  {-1, 1},  {-1, 0}};
    const Curve longer = extend_parameter(Curve::make(definition).value(), CurveEnd::end, 3.0).value();
    const auto points = longer.control_points();
    EXPECT_LE(distance(points[20], {-1.0277201234020805, -0.5991458765377873}), 1e-15);
    EXPECT_LE(distance(points[19], {-1.093478036093821, -0.5716775854919175}), 1e-15);
    EXPECT_LE(distance(points[12], {-2.1658609930714707, -0.5772258011596246}), 1e-15);
}

TEST(Extend, by_arc_length_from_a_short_span_among_weights_that_differ_by_much) {
    // Over thirty times the first span; where that ends is the root of the length of the exact polynomial.
    const Curve curve =
        Curve::make({.degree = 7,
                     .knots = {-2.2634060402261094,
                               -1.2255232459019718,
                               -1.1900258204972218,
                               -0.9182393996778004,
                               -0.6336272265268493,
                               -0.48912105782639037,
                               -0.11751220208230412,
                               0.0,
                               0.006727504805582276,
                               0.6342934388162748,
                               0.7632793405815307,
                               4.467463525789524,
                               5.0,
                               5.0,
                               5.0,
                               5.0,
                               5.0,
                               5.0,
                               5.256371979426131,
                               7.201842581136606},
                     .points = {{-0.006084260198579678, -1.0283090612850385},
                                {-0.4458516679863269, -1.4613715002682397},
                                {-1.3485800982012406, -2.5106302361557136},
                                {-1.5115268854699604, -2.8762276795149577},
                                {-1.8345858953745307, -3.0632972095680095},
                                {-2.492209515601846, -2.9366471300163184},
                                {-3.571546129759545, -2.9630383323460068},
                                {-4.278078944889436, -3.640050595506913},
                                {-4.452049230404756, -4.38602032785576},
                                {-5.158151861962873, -5.194931368798689},
                                {-5.525108375185663, -5.851258804727595},
                                {-4.668642963284679, -6.361484227205344}},
                     .weights = {0.08246989491122196, 38.09810958887369, 2.01630032876995, 1.0243860163940772,
                                 0.013785930230178255, 1.140805747756308, 0.005009924191719422, 0.08672998417988075,
                                 0.07763645747121829, 105.26059025960451, 0.011952775005329022, 0.21903489839185042}})
            .value();
    const Curve longer = extend_length(curve, CurveEnd::start, 0.5519024114987084).value();
    EXPECT_NEAR(longer.domain().lower, -0.20089149505665432, 1e-13);
    EXPECT_NEAR(arc_length(longer, longer.domain().lower, 0.0).value, 0.5519024114987084, 1e-11);
}

TEST(Extend, straight_by_the_length_and_in_the_direction_of_the_end) {
    RandomCurves random(383);
    for (int k = 0; k < 200; ++k) {
        const Curve curve = random.open_curve();
        for (const CurveEnd end : both) {
            const Curve longer = extend_straight(curve, end, 2.0).value();
            const bool at_start = end == CurveEnd::start;
            const double u = at_start ? curve.domain().lower : curve.domain().upper;
            const Point tip = point_at(longer, at_start ? longer.domain().lower : longer.domain().upper);
            const auto motion = derivatives_at(curve, u, 1);
            const Vector expected = (at_start ? -2.0 : 2.0) / length(motion[1]) * motion[1];
            EXPECT_LE(distance(tip, motion.point + expected), 1e-12);
            EXPECT_LE(
                shape_change(curve, sub_curve(longer, curve.domain().lower, curve.domain().upper).value(), random),
                1e-13);
            const auto outside = derivatives_at(longer, u, 1, at_start ? Side::left : Side::right);
            EXPECT_LE(length(outside[1] - motion[1]), 1e-9 * (1 + length(motion[1])));
        }
    }
}

TEST(Extend, refuses_rings_and_lengths_that_are_none) {
    using Code = CurveErrorCode;
    const Curve ring =
        Curve::make({.degree = 2, .knots = {0, 1, 2}, .points = {{0, 0}, {1, 2}}, .periodic = true}).value();
    const Curve line = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {2, 0}}}).value();
    const Curve point = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{1, 1}, {1, 1}}}).value();
    for (const CurveEnd end : both) {
        EXPECT_EQ(extend_parameter(ring, end, 1).error().code, Code::curve_periodic);
        EXPECT_EQ(extend_straight(ring, end, 1).error().code, Code::curve_periodic);
        for (const double length : {0.0, -1.0, std::nan("")}) {
            EXPECT_EQ(extend_parameter(line, end, length).error().code, Code::length_not_positive);
            EXPECT_EQ(extend_length(line, end, length).error().code, Code::length_not_positive);
            EXPECT_EQ(extend_straight(line, end, length).error().code, Code::length_not_positive);
        }
        EXPECT_EQ(extend_length(point, end, 1).error().code, Code::curve_stands_still);
        EXPECT_EQ(extend_straight(point, end, 1).error().code, Code::curve_stands_still);
    }
    EXPECT_EQ(extend_parameter(line, CurveEnd::end, 1e-30).error().code, Code::range_empty);
    // The denominator 1 - u of this arc runs out at 1.
    const Curve arc =
        Curve::make({.degree = 1, .knots = {0, 0, 0.5, 0.5}, .points = {{0, 0}, {1, 0}}, .weights = {1, 0.5}}).value();
    EXPECT_TRUE(extend_parameter(arc, CurveEnd::end, 0.4));
    EXPECT_EQ(extend_parameter(arc, CurveEnd::end, 0.5).error().code, Code::extension_too_far);
}

TEST(Extend, of_a_rational_curve_says_how_far_it_can_go) {
    // A quarter of the unit circle: over [0, 1 + b] the weight in the middle is 1 - (1 + b) (1 - sqrt(1/2)), positive
    // below b = 1 + sqrt(2), where the arc has become half a circle.
    const Curve arc = circular_arc({0, 0}, 1.0, {0.0, 90.0}).value();
    for (const CurveEnd end : both) {
        const auto far = extend_parameter(arc, end, 3.0);
        ASSERT_FALSE(far);
        EXPECT_EQ(describe(far.error()),
                  "the curve cannot go on by 3, because a weight would become 0 or a number too large before; at most "
                  "2.414 is possible");
        EXPECT_TRUE(extend_parameter(arc, end, far.error().upper));
        EXPECT_NEAR(arc_length(extend_length(arc, end, 1.5).value()).value, std::numbers::pi / 2 + 1.5, 1e-9);
        const auto longer = extend_length(arc, end, 2.0);
        ASSERT_FALSE(longer);
        EXPECT_EQ(longer.error().code, CurveErrorCode::extension_too_far);
        EXPECT_EQ(longer.error().value, 2.0);
        EXPECT_LE(longer.error().upper, std::numbers::pi / 2);
        EXPECT_GE(longer.error().upper, std::numbers::pi / 2 - 0.01);
        EXPECT_TRUE(extend_length(arc, end, longer.error().upper));
    }
}

// The end of the line goes on to 1e308 (1 + by), which is a double below by = 0.79769...; so do its weights.
TEST(Extend, goes_on_as_far_as_doubles_do) {
    const Curve line = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {1e308, 0}}}).value();
    const Curve heavy =
        Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {1, 0}}, .weights = {1, 1e308}}).value();
    for (const Curve& curve : {line, heavy}) {
        const auto far = extend_parameter(curve, CurveEnd::end, 10.0);
        ASSERT_FALSE(far);
        EXPECT_EQ(far.error().code, CurveErrorCode::extension_too_far);
        EXPECT_LE(far.error().upper, 0.79769);
        EXPECT_GE(far.error().upper, 0.797);
        EXPECT_TRUE(extend_parameter(curve, CurveEnd::end, far.error().upper));
    }
    EXPECT_EQ(extend_parameter(heavy, CurveEnd::end, 1e300).error().code, CurveErrorCode::not_computable);
}

TEST(Extend, writes_the_smallest_limits_in_full) {
    EXPECT_EQ(rounded_down(1.23456e-300), 1.234e-300);
    EXPECT_EQ(rounded_down(1.23456e-306), 1.23456e-306);
    EXPECT_EQ(rounded_down(5e-324), 5e-324);
    EXPECT_EQ(rounded_down(1.23456e308), 1.234e308);
}

}  // namespace
}  // namespace batten::core
