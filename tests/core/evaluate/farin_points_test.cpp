#include "core/evaluate/farin_points.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/edit/point_edit.h"
#include "core/evaluate/evaluate.h"
#include "tests/core/bezier_curve.h"
#include "tests/core/uniform_curves.h"

namespace batten::core {
namespace {

std::vector<double> weights(const Curve& curve) {
    return {curve.weights().begin(), curve.weights().end()};
}

Curve triangle(std::vector<double> weights) {
    CurveDefinition definition = closed_curve(2, {{0, 0}, {6, 0}, {0, 6}}).definition();
    definition.weights = std::move(weights);
    return Curve::make(std::move(definition)).value();
}

TEST(FarinPoint, divides_a_leg_in_the_inverse_ratio_of_its_weights) {
    const Curve curve = bezier({{0, 0}, {12, 0}, {12, 8}}, {1, 3, 1});
    ASSERT_EQ(leg_count(curve), 2U);
    EXPECT_EQ(farin_point(curve, 0).share, 0.75);
    EXPECT_EQ(farin_point(curve, 0).point, Point(9, 0));
    EXPECT_EQ(farin_point(curve, 1).share, 0.25);
    EXPECT_EQ(farin_point(curve, 1).point, Point(12, 2));
}

TEST(FarinPoint, is_the_middle_of_a_leg_between_equal_weights) {
    const Curve curve = bezier({{1e6, 1e6}, {1e6 + 1, 1e6}, {1e6 + 1, 1e6 + 4}}, {7, 7, 7});
    EXPECT_EQ(farin_point(curve, 1).share, 0.5);
    EXPECT_EQ(farin_point(curve, 1).point, Point(1e6 + 1, 1e6 + 2));
}

// The tangent at the middle of a quadratic Bézier curve joins both (Farin 2002).
TEST(FarinPoint, of_a_conic_is_on_the_tangent_at_its_shoulder) {
    const double w = std::sqrt(0.5);
    const Curve curve = bezier({{1, 0}, {1, 1}, {0, 1}}, {1, w, 1});
    // On the unit circle the tangent at 45 degrees is x + y = root of 2.
    for (const std::size_t leg : {0U, 1U}) {
        const Point point = farin_point(curve, leg).point;
        EXPECT_NEAR(point.x + point.y, std::sqrt(2.0), 1e-15);
    }
    EXPECT_NEAR(farin_point(curve, 0).point.y, std::sqrt(2.0) - 1, 1e-15);
    EXPECT_NEAR(farin_point(curve, 1).point.x, std::sqrt(2.0) - 1, 1e-15);
}

TEST(FarinPoint, of_a_periodic_curve_is_also_on_the_leg_that_closes_it) {
    const Curve curve = triangle({1, 1, 2});
    ASSERT_EQ(leg_count(curve), 3U);
    EXPECT_EQ(farin_point(curve, 1).point, Point(2, 4));
    EXPECT_EQ(farin_point(curve, 2).point, Point(0, 4));
    EXPECT_NEAR(farin_point(curve, 2).share, 1.0 / 3.0, 1e-16);
}

TEST(FarinPoint, stays_between_extreme_weights) {
    const Curve curve = bezier({{0, 0}, {1, 0}, {1, 1}, {2, 2}}, {1e-300, 1e300, 1e300, 1e-300});
    EXPECT_EQ(farin_point(curve, 0).share, 1.0);
    EXPECT_EQ(farin_point(curve, 0).point, Point(1, 0));
    EXPECT_EQ(farin_point(curve, 1).point, Point(1, 0.5));
    EXPECT_EQ(farin_point(curve, 2).share, 0.0);
    EXPECT_EQ(farin_point(curve, 2).point, Point(1, 1));
}

TEST(FarinPoint, is_known_on_a_leg_longer_than_a_double) {
    EXPECT_EQ(farin_point(bezier({{-1.5e308, 0}, {1.5e308, 4}}, {1, 3}), 0).point, Point(0.75e308, 3));
}

TEST(NearestFarinShare, is_that_of_the_foot_on_the_leg) {
    const Curve curve = bezier({{0, 0}, {4, 0}, {4, 8}});
    EXPECT_EQ(nearest_farin_share(curve, 0, {1, 5}).value(), 0.25);
    EXPECT_EQ(nearest_farin_share(curve, 1, {-3, 6}).value(), 0.75);
    EXPECT_EQ(nearest_farin_share(curve, 0, {-9, 0}).value(), farin_shares.lower);
    EXPECT_EQ(nearest_farin_share(curve, 0, {9, 0}).value(), farin_shares.upper);
    EXPECT_EQ(nearest_farin_share(triangle({1, 1, 1}), 2, {9, 4.5}).value(), 0.25);
}

TEST(NearestFarinShare, knows_legs_of_any_size_but_none_without_length) {
    EXPECT_NEAR(nearest_farin_share(bezier({{1e200, 0}, {5e200, 0}}), 0, {2e200, 0}).value(), 0.25, 1e-15);
    EXPECT_NEAR(nearest_farin_share(bezier({{1e-200, 0}, {5e-200, 0}}), 0, {2e-200, 0}).value(), 0.25, 1e-15);
    EXPECT_FALSE(nearest_farin_share(bezier({{3, 4}, {3, 4}}), 0, {0, 0}));
}

TEST(SetFarinShare, keeps_all_other_farin_points_of_an_open_curve) {
    const Curve curve = bezier({{0, 0}, {1, 3}, {4, 3}, {5, 0}}, {1, 2, 4, 3});
    const Curve result = set_farin_share(curve, 1, 0.5).value();
    EXPECT_EQ(weights(result), (std::vector<double>{1, 2, 2, 1.5}));
    EXPECT_EQ(farin_point(result, 0).point, farin_point(curve, 0).point);
    EXPECT_EQ(farin_point(result, 1).point, Point(2.5, 3));
    EXPECT_EQ(farin_point(result, 2).point, farin_point(curve, 2).point);
    EXPECT_EQ(result.knots(), curve.knots());
}

TEST(SetFarinShare, puts_the_point_where_it_was_asked_to_be) {
    const Curve curve = bezier({{0, 0}, {8, 0}, {8, 8}}, {2, 5, 3});
    for (const double share : {farin_shares.lower, 0.125, 0.5, 0.75, farin_shares.upper})
        for (const std::size_t leg : {0U, 1U})
            EXPECT_NEAR(farin_point(set_farin_share(curve, leg, share).value(), leg).share, share, 2e-16);
}

TEST(SetFarinShare, changes_one_weight_of_a_periodic_curve) {
    const Curve curve = triangle({1, 2, 4});
    EXPECT_EQ(weights(set_farin_share(curve, 0, 0.75).value()), (std::vector<double>{1, 3, 4}));
    EXPECT_EQ(weights(set_farin_share(curve, 2, 0.75).value()), (std::vector<double>{12, 2, 4}));
}

// Moving the point to where it is changes nothing.
TEST(SetFarinShare, keeps_the_curve_where_the_share_is_its_own) {
    const Curve curve = bezier({{0, 0}, {1, 3}, {4, 3}, {5, 0}}, {1, 2, 4, 3});
    const Curve result = set_farin_share(curve, 1, farin_point(curve, 1).share).value();
    for (const double u : {0.25, 0.5, 0.75}) EXPECT_LT(distance(point_at(result, u), point_at(curve, u)), 1e-15);
}

TEST(SetFarinShare, refuses_other_legs_and_shares) {
    const Curve curve = bezier({{0, 0}, {1, 3}, {4, 3}}, {1, 2, 1});
    EXPECT_EQ(set_farin_share(curve, 2, 0.5).error(),
              (CurveError{.code = CurveErrorCode::point_index_out_of_range, .index = 2, .upper = 1}));
    for (const double share : {0.0, 1.0, -0.5})
        EXPECT_EQ(set_farin_share(curve, 0, share).error(),
                  (CurveError{.code = CurveErrorCode::share_out_of_range, .value = share}));
    EXPECT_EQ(set_farin_share(curve, 0, std::nan("")).error().code, CurveErrorCode::share_out_of_range);
    const Curve extreme = bezier({{0, 0}, {1, 3}, {4, 3}}, {1, 1e-300, 1e300});
    EXPECT_EQ(set_farin_share(extreme, 0, 0.5).error().code, CurveErrorCode::weight_not_finite);
}

}  // namespace
}  // namespace batten::core
