#include "core/edit/circular.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/evaluate/evaluate.h"
#include "core/make/conics.h"
#include "tests/core/bezier_curve.h"
#include "tests/core/uniform_curves.h"

namespace batten::core {
namespace {

const double half_root = std::sqrt(0.5);

void expect_circle(const Curve& curve, Interval range, Point center, double radius) {
    const double rounding = std::numeric_limits<double>::epsilon() * std::abs(center.x) / radius;
    for (int k = 0; k <= 32; ++k) {
        const Point point = point_at(curve, range.lower + range.length() * k / 32);
        EXPECT_NEAR(distance(point, center) / radius, 1, 1e-14 + rounding);
    }
}

TEST(MakeCircular, gives_the_corner_the_sine_of_half_its_angle) {
    const Curve curve = bezier({{3, 0}, {3, 3}, {0, 3}}, {1, 7, 1});
    const Curve result = make_circular(curve, 0.3).value();
    EXPECT_DOUBLE_EQ(result.weights()[1], half_root);
    EXPECT_EQ(result.weights()[0], 1);
    EXPECT_EQ(result.weights()[2], 1);
    expect_circle(result, {0, 1}, {0, 0}, 3);
}

TEST(MakeCircular, heeds_the_weights_of_the_ends) {
    const Curve curve = bezier({{1e6 + 3, 0}, {1e6 + 3, 3}, {1e6, 3}}, {4, 1, 9});
    const Curve result = make_circular(curve, 0.3).value();
    EXPECT_NEAR(result.weights()[1], 6 * half_root, 1e-9);
    expect_circle(result, {0, 1}, {1e6, 0}, 3);
}

TEST(MakeCircular, changes_the_piece_at_the_parameter_only) {
    CurveDefinition definition = circle({0, 0}, 2.0).value().definition();
    for (const std::size_t i : {1U, 3U, 5U, 7U}) definition.weights[i] = 2;
    const Curve curve = Curve::make(definition).value();
    const Curve result = make_circular(curve, 0.6).value();
    for (std::size_t i = 0; i < 9; ++i) {
        if (i == 5)
            EXPECT_DOUBLE_EQ(result.weights()[i], half_root);
        else
            EXPECT_EQ(result.weights()[i], curve.weights()[i]) << i;
    }
    expect_circle(result, {0.5, 0.75}, {0, 0}, 2);
}

// The last piece ends in the first point.
TEST(MakeCircular, works_across_the_seam_of_a_periodic_curve) {
    const Curve curve = Curve::make({.degree = 2,
                                     .knots = {0, 0, 1, 1, 2, 2, 3, 3, 4},
                                     .points = {{1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}},
                                     .periodic = true})
                            .value();
    for (const double u : {0.5, 1.5, 2.5, 3.5}) {
        const auto result = make_circular(curve, u);
        ASSERT_TRUE(result) << describe(result.error());
        expect_circle(*result, {u - 0.5, u + 0.5}, {0, 0}, 1);
    }
}

TEST(MakeCircular, says_why_it_cannot) {
    const auto code_for = [](const Curve& curve, double u = 0.5) { return make_circular(curve, u).error().code; };
    const Curve unequal = bezier({{4, 0}, {4, 3}, {0, 3}});
    EXPECT_EQ(make_circular(unequal, 0.5).error(),
              (CurveError{.code = CurveErrorCode::legs_unequal, .value = 3, .upper = 4}));
    EXPECT_EQ(code_for(bezier({{0, 0}, {1, 1}, {2, 2}})), CurveErrorCode::points_collinear);
    EXPECT_EQ(code_for(bezier({{0, 0}, {1, 1}, {2, 0}, {3, 0}})), CurveErrorCode::degree_unsuitable);
    EXPECT_EQ(code_for(unequal, 1.5), CurveErrorCode::parameter_outside_domain);
    EXPECT_EQ(code_for(unequal, std::numeric_limits<double>::infinity()), CurveErrorCode::parameter_not_finite);
    EXPECT_EQ(code_for(open_curve(2, {{3, 0}, {3, 3}, {0, 3}})), CurveErrorCode::piece_not_bezier);
}

}  // namespace
}  // namespace batten::core
