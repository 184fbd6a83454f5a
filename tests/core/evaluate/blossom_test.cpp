#include "core/evaluate/blossom.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/evaluate/evaluate.h"
#include "tests/core/random_curves.h"
#include "tests/core/reference.h"

namespace batten::core {

namespace {

double largest_difference(HomogeneousPoint a, HomogeneousPoint b) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

}  // namespace

TEST(Blossom, on_the_diagonal_is_the_curve) {
    RandomCurves random(30);
    for (int k = 0; k < 200; ++k) {
        const Curve curve = random.curve();
        const double u = random.parameter(curve);
        const std::vector<double> arguments(static_cast<std::size_t>(curve.degree()), u);
        const auto point = blossom(curve, curve.knots().span_at(u), arguments);
        EXPECT_LE(reference::relative_distance(curve, project(point), reference::point_at(curve, u)), 1e-14);
    }
}

TEST(Blossom, at_consecutive_knots_is_a_control_point) {
    RandomCurves random(31);
    for (int k = 0; k < 200; ++k) {
        const Curve curve = random.curve();
        const auto p = static_cast<std::size_t>(curve.degree());
        const std::size_t s = curve.knots().span_at(random.parameter(curve));
        for (std::size_t i = s - p; i <= s; ++i) {
            const auto arguments = curve.knots().values().subspan(i + 1, p);
            EXPECT_LE(largest_difference(blossom(curve, s, arguments), curve.homogeneous_point(i)), 1e-10);
        }
    }
}

TEST(Blossom, is_symmetric_and_affine_in_each_argument) {
    RandomCurves random(32);
    for (int k = 0; k < 200; ++k) {
        const Curve curve = random.curve();
        const Interval domain = curve.domain();
        const std::size_t s = curve.knots().span_at(random.parameter(curve));
        std::vector<double> arguments;
        for (int j = 0; j < curve.degree(); ++j)
            arguments.push_back(random.number(curve.knots()[s], curve.knots()[s + 1]));
        auto shuffled = arguments;
        std::rotate(shuffled.begin(), shuffled.begin() + random.whole(0, curve.degree() - 1), shuffled.end());
        std::reverse(shuffled.begin(), shuffled.end());
        EXPECT_LE(largest_difference(blossom(curve, s, arguments), blossom(curve, s, shuffled)), 1e-12);

        auto at_lower = arguments;
        auto at_upper = arguments;
        at_lower[0] = domain.clamp(curve.knots()[s]);
        at_upper[0] = domain.clamp(curve.knots()[s + 1]);
        const double alpha = (arguments[0] - at_lower[0]) / (at_upper[0] - at_lower[0]);
        const auto mixed = (1 - alpha) * blossom(curve, s, at_lower) + alpha * blossom(curve, s, at_upper);
        EXPECT_LE(largest_difference(blossom(curve, s, arguments), mixed), 1e-12);
    }
}

TEST(Blossom, of_a_parabola_by_hand) {
    // C(u) = (u, u^2) has the blossom ((a + b) / 2, a b), also outside the domain.
    const Curve curve =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {0.5, 0}, {1, 1}}}).value();
    const double arguments[] = {3.0, -5.0};
    EXPECT_EQ(blossom(curve, 2, arguments), HomogeneousPoint(-1, -15, 1));
}

}  // namespace batten::core
