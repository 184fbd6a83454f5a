#include "exchange/written_curves.h"

#include <gtest/gtest.h>

#include <cmath>

namespace batten::exchange {

namespace {

core::Curve closed_quadratic(std::vector<double> knots, std::vector<core::Point> points,
                             std::vector<double> weights = {}) {
    return core::Curve::make({.degree = 2,
                              .knots = std::move(knots),
                              .points = std::move(points),
                              .weights = std::move(weights),
                              .periodic = true})
        .value();
}

}  // namespace

TEST(UnrollingError, IsNothingWhereNoKnotIsRounded) {
    const std::vector<core::Point> points{{0, 0}, {4, 1}, {2, 3}};
    EXPECT_EQ(unrolling_error(closed_quadratic({0, 1, 2.5, 4}, points)), 0.0);
    EXPECT_EQ(
        unrolling_error(core::Curve::make({.degree = 2, .knots = {0, 0, 0, 0.1, 0.1, 0.1}, .points = points}).value()),
        0.0);
}

// The period is 2^53 + 2, so that the knot behind the domain, half beyond its end, is rounded to the end. There the
// curve is A + (B - A) / (2^54 + 3) for the points A and B of its last leg, unrolled it is A.
TEST(UnrollingError, BoundsWhatRoundedKnotsMove) {
    const double period = std::ldexp(1.0, 53) + 2.0;
    const std::vector<core::Point> points{{0, 0}, {std::ldexp(1.0, 54), 0}, {0, 0}};
    const core::Curve curve = closed_quadratic({0, 0.5, 1, period}, points);
    const core::Curve unrolled = core::Curve::make(full_definition(curve)).value();
    const core::Curve weighted = closed_quadratic({0, 0.5, 1, period}, points, {2, 2, 2});
    EXPECT_EQ(unrolled.knots()[unrolled.knots().size() - 2], period);
    EXPECT_GE(unrolling_error(curve), 1.0);
    EXPECT_LE(unrolling_error(curve), 10.0);
    EXPECT_EQ(unrolling_error(weighted), unrolling_error(curve));
}

// Thirds are no doubles; 1/3 - 1 is off by 2^-55 at most, and the curve moves along legs of length 3 within a span of
// 2/3.
TEST(UnrollingError, IsOfTheSizeOfTheRounding) {
    const double error = unrolling_error(closed_quadratic({0, 1.0 / 3, 2.0 / 3, 1}, {{0, 0}, {3, 0}, {0, 3}}));
    EXPECT_GT(error, 0.0);
    EXPECT_LT(error, 1e-14);
}

}  // namespace batten::exchange
