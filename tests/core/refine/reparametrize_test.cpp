#include "core/refine/reparametrize.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/curve/knot_kinds.h"
#include "core/edit/knot_merging.h"
#include "core/measure/deviation.h"
#include "tests/core/shape_check.h"

namespace batten::core {
namespace {

using Knots = std::vector<double>;

TEST(Reparametrize, keeps_the_shape_over_any_domain) {
    RandomCurves random(361);
    for (int k = 0; k < 300; ++k) {
        const Curve curve = random.curve();
        for (const Interval range : {Interval{0, 1}, Interval{-1e9, 1e9}, Interval{5, 5.25}, Interval{1e6, 1e6 + 1}}) {
            const auto result = reparametrize(curve, range);
            ASSERT_TRUE(result) << describe(result.error());
            EXPECT_EQ(result->domain(), range);
            EXPECT_EQ(result->is_periodic(), curve.is_periodic());
            EXPECT_TRUE(std::ranges::equal(result->control_points(), curve.control_points()));
            const double rounding = std::max(std::abs(range.lower), std::abs(range.upper)) / range.length();
            EXPECT_LE(largest_deviation(curve, *result), 1e-12 * std::max(1.0, rounding));
        }
    }
}

// The knots outside would go to -2e308 and 3e308.
TEST(Reparametrize, refuses_knots_beyond_doubles) {
    const Curve curve =
        Curve::make({.degree = 2, .knots = {0, 1, 2, 3, 4, 5}, .points = {{0, 0}, {1, 1}, {2, 0}}}).value();
    EXPECT_EQ(reparametrize(curve, {0.0, 1e308}).error().code, CurveErrorCode::not_computable);
}

TEST(Reparametrize, maps_knots_affinely) {
    const Curve curve =
        Curve::make({.degree = 1, .knots = {1, 1, 2, 5, 5}, .points = {{0, 0}, {1, 1}, {2, 0}}}).value();
    EXPECT_EQ(stored(reparametrize(curve, {0, 1}).value()), (Knots{0, 0, 0.25, 1, 1}));
    EXPECT_EQ(stored(reparametrize(curve, {-8, 8}).value()), (Knots{-8, -8, -4, 8, 8}));
    EXPECT_EQ(stored(shift_domain(curve, -1).value()), (Knots{-1, -1, 0, 3, 3}));
    const Curve unclamped =
        Curve::make({.degree = 2, .knots = {0, 1, 2, 3, 5, 6}, .points = {{0, 0}, {1, 1}, {2, 0}}}).value();
    EXPECT_EQ(stored(reparametrize(unclamped, {0, 10}).value()), (Knots{-20, -10, 0, 10, 30, 40}));
}

TEST(Reparametrize, keeps_the_kind) {
    const std::vector<Point> points{{0, 0}, {1, 5}, {2, -3}, {3, 4}, {4, 4}, {5, -5}, {6, 2}};
    for (const KnotKind kind :
         {KnotKind::uniform, KnotKind::clamped_uniform, KnotKind::periodic, KnotKind::piecewise_bezier}) {
        const Curve curve = Curve::make(make_knots(kind, 3, 7).value(), points, {}).value();
        EXPECT_EQ(reparametrize(curve, {0.1, 77.7})->knots().kind(), kind);
    }
}

TEST(Reparametrize, refuses_what_is_no_interval_or_too_coarse) {
    using Code = CurveErrorCode;
    const Curve curve =
        Curve::make({.degree = 1, .knots = {0, 0, 1e-9, 1, 1}, .points = {{0, 0}, {1, 1}, {2, 0}}}).value();
    EXPECT_EQ(reparametrize(curve, {1, 1}).error(), (CurveError{.code = Code::range_empty, .lower = 1, .upper = 1}));
    EXPECT_EQ(reparametrize(curve, {2, 1}).error().code, Code::range_empty);
    EXPECT_EQ(reparametrize(curve, {0, std::nan("")}).error().code, Code::parameter_not_finite);
    EXPECT_EQ(reparametrize(curve, {1e9, 1e9 + 1}).error(),
              (CurveError{.code = Code::knots_coincide, .index = 2, .value = 1e9}));
    EXPECT_EQ(shift_domain(curve, 1e9).error().code, Code::knots_coincide);
}

TEST(MergeKnots, makes_near_knots_equal_and_reports_the_error) {
    const Curve curve = Curve::make({.degree = 3,
                                     .knots = {0, 0, 0, 0, 0.5, 0.5 + 1e-7, 0.8, 1, 1, 1, 1},
                                     .points = {{0, 0}, {1, 5}, {2, -3}, {3, 4}, {4, 4}, {5, -5}, {6, 2}}})
                            .value();
    const auto merged = merge_knots(curve, 1e-6).value();
    EXPECT_EQ(stored(merged.curve), (Knots{0, 0, 0, 0, 0.5, 0.5, 0.8, 1, 1, 1, 1}));
    EXPECT_EQ(merged.count, 1);
    EXPECT_GT(merged.error, 1e-8);
    EXPECT_LT(merged.error, 1e-6);
    EXPECT_EQ(merged.error, largest_deviation(curve, merged.curve));
    const auto untouched = merge_knots(curve, 1e-8).value();
    EXPECT_EQ(untouched.curve, curve);
    EXPECT_EQ(untouched.count, 0);
    EXPECT_EQ(untouched.error, 0.0);
}

TEST(MergeKnots, takes_the_longest_run_and_never_more_than_fit) {
    const Curve curve = Curve::make({.degree = 2,
                                     .knots = {0, 0, 0, 0.5, 0.501, 0.501, 0.502, 1, 1, 1},
                                     .points = {{0, 0}, {1, 5}, {2, -3}, {3, 4}, {4, 4}, {5, -5}, {6, 2}}})
                            .value();
    // 0.5 and the double 0.501 would be three; 0.501, 0.501 with 0.502 too.
    EXPECT_EQ(merge_knots(curve, 0.01)->curve, curve);
    CurveDefinition cubic = curve.definition();
    cubic.degree = 3;
    cubic.knots = {0, 0, 0, 0, 0.5, 0.501, 0.501, 1, 1, 1, 1};
    EXPECT_EQ(stored(merge_knots(Curve::make(cubic).value(), 0.01)->curve),
              (Knots{0, 0, 0, 0, 0.501, 0.501, 0.501, 1, 1, 1, 1}));
    // Fully clamped ends have no room; others take in what is near.
    cubic.knots = {0, 0, 0, 0, 0.001, 0.5, 0.999, 1, 1, 1, 1};
    EXPECT_EQ(merge_knots(Curve::make(cubic).value(), 0.01)->count, 0);
    cubic.knots = {-2, -1, 0, 0, 0.001, 0.5, 0.999, 1, 2, 3, 4};
    EXPECT_EQ(stored(merge_knots(Curve::make(cubic).value(), 0.01)->curve),
              (Knots{-2, -1, 0, 0, 0, 0.5, 1, 1, 2, 3, 4}));
}

TEST(MergeKnots, keeps_every_curve_valid) {
    RandomCurves random(362);
    for (int k = 0; k < 500; ++k) {
        const Curve curve = random.curve();
        const auto merged = merge_knots(curve, std::pow(10.0, random.number(-3, 0.5)));
        ASSERT_TRUE(merged) << describe(merged.error());
        EXPECT_EQ(merged->curve.domain(), curve.domain());
    }
    EXPECT_EQ(merge_knots(random.curve(), 0.0).error().code, CurveErrorCode::tolerance_not_positive);
}

}  // namespace
}  // namespace batten::core
