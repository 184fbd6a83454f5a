#include "core/refine/reverse.h"

#include <gtest/gtest.h>

#include "core/curve/knot_kinds.h"
#include "tests/core/shape_check.h"

namespace batten::core {
namespace {

double change_by_reversing(const Curve& curve, const Curve& reversed, RandomCurves& random) {
    double largest = 0.0;
    const Interval domain = curve.domain();
    for (int k = 0; k < 40; ++k) {
        const double u = random.number(domain.lower, domain.upper);
        largest =
            std::max(largest, distance(point_at(curve, u), point_at(reversed, domain.lower + (domain.upper - u))));
    }
    return largest / golden::largest_coordinate(curve.control_points());
}

TEST(Reverse, runs_backwards_over_the_same_domain) {
    RandomCurves random(341);
    for (int k = 0; k < 500; ++k) {
        const Curve curve = random.curve();
        const Curve reversed = reverse(curve).value();
        EXPECT_EQ(reversed.domain(), curve.domain());
        EXPECT_EQ(reversed.is_periodic(), curve.is_periodic());
        EXPECT_LE(change_by_reversing(curve, reversed, random), 1e-13);
    }
}

TEST(Reverse, twice_is_the_identity_for_points_weights_and_almost_for_knots) {
    RandomCurves random(342);
    for (int k = 0; k < 500; ++k) {
        const Curve curve = random.curve();
        const Curve twice = reverse(reverse(curve).value()).value();
        EXPECT_TRUE(std::ranges::equal(twice.control_points(), curve.control_points()));
        EXPECT_TRUE(std::ranges::equal(twice.weights(), curve.weights()));
        EXPECT_LE(golden::largest_difference(stored(twice), stored(curve)), 4e-15);
    }
}

TEST(Reverse, twice_gives_typed_and_representable_knots_back_bit_by_bit) {
    for (const std::vector<double>& inside :
         std::vector<std::vector<double>>{{0.1, 0.2, 0.35}, {0.25, 0.5, 0.75}, {0.2, 0.3, 0.7}, {0.1, 0.1, 0.9}}) {
        std::vector<double> knots(3, 0.0);
        knots.insert(knots.end(), inside.begin(), inside.end());
        knots.insert(knots.end(), 3, 1.0);
        const Curve curve =
            Curve::make({.degree = 2, .knots = knots, .points = {{0, 0}, {1, 1}, {2, 0}, {3, 1}, {4, 0}, {5, 1}}})
                .value();
        EXPECT_EQ(reverse(reverse(curve).value()).value(), curve) << inside[0];
    }
}

TEST(Reverse, reflects_knots_and_points) {
    const Curve curve =
        Curve::make({.degree = 2, .knots = {1, 1, 1, 1.25, 3, 3, 3}, .points = {{0, 0}, {1, 1}, {2, 0}, {3, 1}}})
            .value();
    const Curve reversed = reverse(curve).value();
    EXPECT_EQ(stored(reversed), (std::vector<double>{1, 1, 1, 2.75, 3, 3, 3}));
    EXPECT_EQ(reversed.control_points()[0], Point(3, 1));
    EXPECT_EQ(reversed.control_points()[1], Point(2, 0));
}

TEST(Reverse, keeps_equally_spaced_knots_as_they_are) {
    std::vector<Point> points{{0, 0}, {1, 5}, {2, -3}, {3, 4}, {4, 4}, {5, -5}, {6, 2}};
    for (const KnotKind kind :
         {KnotKind::uniform, KnotKind::clamped_uniform, KnotKind::periodic, KnotKind::piecewise_bezier}) {
        const Curve curve = Curve::make(make_knots(kind, 3, 7, {0.1, 0.7}).value(), points, {}).value();
        EXPECT_EQ(reverse(curve)->knots().kind(), kind);
        EXPECT_EQ(reverse(reverse(curve).value()).value(), curve);
    }
}

TEST(Reverse, keeps_short_spans_exactly) {
    const double e = 0x1p-30;
    const Curve curve =
        Curve::make({.degree = 1, .knots = {0, 0, 1 - 2 * e, 1 - e, 1, 1}, .points = {{0, 0}, {1, 1}, {2, 0}, {3, 1}}})
            .value();
    EXPECT_EQ(stored(reverse(curve).value()), (std::vector<double>{0, 0, e, 2 * e, 1, 1}));
}

TEST(Reverse, refuses_to_let_knots_fall_together) {
    const Curve curve =
        Curve::make({.degree = 1, .knots = {0, 0, 1e-20, 1, 1}, .points = {{0, 0}, {1, 1}, {2, 0}}}).value();
    EXPECT_EQ(reverse(curve).error().code, CurveErrorCode::knots_coincide);
}

}  // namespace
}  // namespace batten::core
