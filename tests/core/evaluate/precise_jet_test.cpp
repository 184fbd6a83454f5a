#include "core/evaluate/detail/precise_jet.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/evaluate/evaluate.h"
#include "tests/core/random_curves.h"

namespace batten::core {

TEST(DoubleDouble, keeps_what_a_double_would_round_away) {
    const DoubleDouble sum = DoubleDouble(1.0) + std::ldexp(1.0, -80);
    EXPECT_EQ(sum.rounded(), 1.0);
    EXPECT_EQ((sum - 1.0).rounded(), std::ldexp(1.0, -80));
    EXPECT_EQ((exact_sum(1e16, 1.0) - 1e16).rounded(), 1.0);
}

TEST(DoubleDouble, products_and_quotients_have_some_30_digits) {
    // (1 + 2^-30)^2 = 1 + 2^-29 + 2^-60
    const DoubleDouble square = exact_product(1 + std::ldexp(1.0, -30), 1 + std::ldexp(1.0, -30));
    EXPECT_EQ((square - 1.0 - std::ldexp(1.0, -29)).rounded(), std::ldexp(1.0, -60));
    const DoubleDouble third = DoubleDouble(1.0) / 3.0;
    EXPECT_LE(std::abs((third * 3.0 - 1.0).rounded()), std::ldexp(1.0, -104));
    EXPECT_NE((third - third.rounded()).rounded(), 0.0);
}

TEST(PreciseJet, agrees_with_the_derivatives_of_polynomial_curves) {
    RandomCurves random(130);
    for (int k = 0; k < 200; ++k) {
        auto definition = random.curve().definition();
        definition.weights.clear();
        const Curve curve = Curve::make(std::move(definition)).value();
        const double u = random.parameter(curve);
        const Location at = located(curve.knots(), u, Side::right);
        const auto expected = derivatives_at(curve, u, 2);
        const auto jet = precise_jet(curve, at.at, at.u, Point{});
        for (std::size_t r = 0; r < 3; ++r) {
            const Vector wanted = r == 0 ? vector_to(expected.point) : expected[r];
            const double size = std::max({8.0, std::abs(wanted.x), std::abs(wanted.y)});
            EXPECT_NEAR(jet[r].x.rounded(), wanted.x, 1e-12 * size);
            EXPECT_NEAR(jet[r].y.rounded(), wanted.y, 1e-12 * size);
            EXPECT_NEAR(jet[r].w.rounded(), r == 0 ? 1.0 : 0.0, 1e-30);
        }
    }
}

TEST(PreciseJet, makes_the_curvature_beside_a_cusp_right) {
    // C(u) = (3 u^2, 3 u^3) on [-1, 1], all numbers exact: kappa = 6 / (3 u (4 + 9 u^2)^(3/2)).
    const Curve curve =
        Curve::make(
            {.degree = 3, .knots = {-1, -1, -1, -1, 1, 1, 1, 1}, .points = {{3, -3}, {-1, 3}, {-1, -3}, {3, 3}}})
            .value();
    for (int k = 2; k <= 40; ++k) {
        const double u = std::ldexp(1.25, -k);
        const double expected = 2 / (u * std::pow(4 + 9 * u * u, 1.5));
        EXPECT_NEAR(curvature_at(curve, u).value() / expected, 1.0, 1e-15) << k;
    }
}

}  // namespace batten::core
