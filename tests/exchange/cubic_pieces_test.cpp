#include "exchange/cubic_pieces.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/evaluate/evaluate.h"
#include "core/make/conics.h"
#include "core/measure/nearest.h"

namespace batten::exchange {

namespace {

core::Curve made(core::CurveDefinition definition) {
    return core::Curve::make(std::move(definition)).value();
}

// The largest distance of places on the pieces from the curve, and of places on the curve from the pieces.
double seen_error(const core::Curve& curve, const CubicPieces& made) {
    const core::NearestFinder on_curve(curve);
    double error = 0.0;
    for (const CubicPiece& piece : made.pieces) {
        const core::Curve drawn = curve_of(piece);
        for (int k = 0; k <= 20; ++k) {
            const core::Point point = core::point_at(drawn, k / 20.0);
            error = std::max(error, core::distance(point, on_curve.nearest(point).point));
        }
    }
    const core::Interval domain = curve.domain();
    for (int k = 0; k <= 200; ++k) {
        const core::Point point = core::point_at(curve, domain.lower + k / 200.0 * (domain.upper - domain.lower));
        double nearest = INFINITY;
        for (const CubicPiece& piece : made.pieces)
            nearest = std::min(nearest, core::distance(point, core::nearest_point(curve_of(piece), point).point));
        error = std::max(error, nearest);
    }
    return error;
}

}  // namespace

TEST(CubicPieces, AreTheControlPointsOfAPolynomialOfDegreeThree) {
    const core::Curve curve =
        made({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{0, 0}, {1, 2}, {3, 2}, {4, -0.0}}});
    const CubicPieces pieces = cubic_pieces(curve, 1e-3);
    ASSERT_EQ(pieces.pieces.size(), 1u);
    EXPECT_EQ(pieces.error, 0.0);
    EXPECT_FALSE(pieces.is_closed);
    EXPECT_TRUE(pieces.pieces[0].is_first);
    EXPECT_EQ(pieces.pieces[0].points, (std::array<core::Point, 4>{{{0, 0}, {1, 2}, {3, 2}, {4, 0}}}));
    EXPECT_TRUE(std::signbit(pieces.pieces[0].points[3].y));
}

TEST(CubicPieces, KeepTheDegreeOfLinesAndParabolas) {
    // A uniform quadratic: the pieces of its spans begin and end in the middles of the legs.
    const core::Curve curve =
        made({.degree = 2, .knots = {0, 1, 2, 3, 4, 5, 6}, .points = {{0, 0}, {2, 0}, {2, 2}, {6, 2}}});
    const CubicPieces pieces = cubic_pieces(curve, 1e-3);
    ASSERT_EQ(pieces.pieces.size(), 2u);
    EXPECT_EQ(pieces.error, 0.0);
    EXPECT_EQ(pieces.pieces[1].degree, 2);
    EXPECT_EQ(pieces.pieces[1].points[0], (core::Point{2, 1}));
    EXPECT_EQ(pieces.pieces[1].points[1], (core::Point{2, 2}));
    EXPECT_EQ(pieces.pieces[1].points[2], (core::Point{4, 2}));
    EXPECT_FALSE(pieces.pieces[1].is_first);
    EXPECT_EQ(
        cubic_pieces(made({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {2, 0}}}), 1.0).pieces[0].degree, 1);
}

TEST(CubicPieces, OfEqualWeightsAreExactAndOfOthersAreNot) {
    core::CurveDefinition definition{
        .degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{1, 0}, {1, 1}, {0, 1}}, .weights = {3, 3, 3}};
    EXPECT_EQ(cubic_pieces(made(definition), 1e-3).error, 0.0);
    definition.weights = {1, std::sqrt(0.5), 1};
    EXPECT_GT(cubic_pieces(made(definition), 1e-3).error, 0.0);
}

// One cubic for a quarter of the unit circle that meets it at its ends and middle has handles 4/3 (sqrt 2 - 1) and is
// beyond it by 2.7253e-4.
TEST(CubicPieces, OfAQuarterCircleAreTheKnownCubic) {
    const core::Curve arc = made({.degree = 2,
                                  .knots = {0, 0, 0, 1, 1, 1},
                                  .points = {{1, 0}, {1, 1}, {0, 1}},
                                  .weights = {1, std::sqrt(0.5), 1}});
    const CubicPieces pieces = cubic_pieces(arc, 5e-3);
    ASSERT_EQ(pieces.pieces.size(), 1u);
    EXPECT_NEAR(pieces.pieces[0].points[1].y, 4.0 / 3.0 * (std::numbers::sqrt2 - 1.0), 1e-15);
    EXPECT_NEAR(pieces.pieces[0].points[2].x, 4.0 / 3.0 * (std::numbers::sqrt2 - 1.0), 1e-15);
    EXPECT_GE(pieces.error, 2.7253e-4);
    EXPECT_LE(pieces.error, 2.5e-3);
}

TEST(CubicPieces, OfACircleAreFewAndWithinTheTolerance) {
    const core::Curve circle = core::circle({1e6, -3}, 2.0).value();
    for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
        const CubicPieces pieces = cubic_pieces(circle, tolerance);
        EXPECT_TRUE(pieces.is_closed);
        EXPECT_LE(pieces.error, tolerance);
        EXPECT_LE(pieces.pieces.size(), 32u) << tolerance;
        for (const CubicPiece& piece : pieces.pieces)
            for (int k = 0; k <= 20; ++k) {
                const core::Point point = core::point_at(curve_of(piece), k / 20.0);
                EXPECT_NEAR(std::hypot(point.x - 1e6, point.y + 3), 2.0, pieces.error + 1e-9);
            }
    }
}

TEST(CubicPieces, OfHighDegreesAndUnequalWeightsAreWithinTheirBound) {
    const core::Curve quintic = made({.degree = 5,
                                      .knots = {0, 0, 0, 0, 0, 0, 0.3, 1, 1, 1, 1, 1, 1},
                                      .points = {{0, 0}, {1, 3}, {2, -3}, {3, 4}, {5, 0}, {6, 2}, {4, 5}}});
    const core::Curve rational = made({.degree = 3,
                                       .knots = {0, 0, 0, 0, 1, 2, 2, 3, 3, 3, 3},
                                       .points = {{0, 0}, {1, 3}, {2, -3}, {3, 4}, {5, 0}, {6, 2}, {4, 5}},
                                       .weights = {1, 20, 0.05, 3, 1, 7, 2}});
    for (const core::Curve& curve : {quintic, rational}) {
        const CubicPieces pieces = cubic_pieces(curve, 1e-3);
        EXPECT_LE(pieces.error, 1e-3);
        EXPECT_GT(pieces.error, 0.0);
        EXPECT_LE(seen_error(curve, pieces), pieces.error * 1.0001);
    }
}

TEST(CubicPieces, OfDegreeTwentyFiveAreWithinTheTolerance) {
    core::CurveDefinition definition{.degree = 25};
    definition.knots.assign(26, 0.0);
    definition.knots.insert(definition.knots.end(), 26, 1.0);
    for (int i = 0; i <= 25; ++i) definition.points.push_back({i * 1.0, (i * 7 % 5) * 1.0});
    const core::Curve curve = made(definition);
    const CubicPieces pieces = cubic_pieces(curve, 1e-4);
    EXPECT_LE(pieces.error, 1e-4);
    EXPECT_LE(seen_error(curve, pieces), 1e-4);
}

TEST(CubicPieces, OfAPeriodicCurveAreClosed) {
    const core::Curve curve =
        made({.degree = 3, .knots = {0, 1, 2, 3, 4.5}, .points = {{0, 0}, {2, 0}, {2, 2}, {0.1, 2}}, .periodic = true});
    const CubicPieces pieces = cubic_pieces(curve, 1e-3);
    EXPECT_EQ(pieces.pieces.size(), 4u);
    EXPECT_EQ(pieces.error, 0.0);
    EXPECT_TRUE(pieces.is_closed);
}

TEST(CubicPieces, BeginAnewWhereTheCurveComesApart) {
    const core::Curve torn = made({.degree = 1,
                                   .knots = {0, 0, 1, 1, 2, 2},
                                   .points = {{0, 0}, {1, 0}, {1, 1}, {2, 1}},
                                   .tears = core::Tears::allow});
    const CubicPieces pieces = cubic_pieces(torn, 1e-3);
    ASSERT_EQ(pieces.pieces.size(), 2u);
    EXPECT_TRUE(pieces.pieces[1].is_first);
    EXPECT_EQ(pieces.pieces[1].points[0], (core::Point{1, 1}));
}

TEST(CubicPieces, OfTenThousandRationalPiecesTakeNoTime) {
    core::CurveDefinition definition{.degree = 3};
    for (int i = 0; i < 10000; ++i) {
        definition.points.push_back({i * 0.01, std::sin(i * 0.05)});
        definition.weights.push_back(1.0 + 0.5 * (i % 3));
        definition.knots.push_back(i);
    }
    for (int i = 0; i < 4; ++i) definition.knots.push_back(10000.0 + i);
    const CubicPieces pieces = cubic_pieces(made(std::move(definition)), 1e-4);
    EXPECT_LE(pieces.error, 1e-4);
    EXPECT_LT(pieces.pieces.size(), 40000u);
}

TEST(CubicPieces, EndForHugeAndTinyNumbersAndCusps) {
    const std::vector<double> weights{1, 1e-300, 1e300, 1, 2};
    for (const double size : {1e300, 1e-300, 1.0}) {
        const core::Curve curve = made({.degree = 4,
                                        .knots = {0, 0, 0, 0, 0, 1, 1, 1, 1, 1},
                                        .points = {{0, 0}, {size, size}, {-size, size}, {size, 0}, {0, size}},
                                        .weights = weights});
        EXPECT_LT(cubic_pieces(curve, 1e-3 * size).pieces.size(), 5000u);
    }
    // Sums of coordinates and weights are beyond doubles.
    const core::Curve beyond = made({.degree = 4,
                                     .knots = {0, 0, 0, 0, 0, 1, 1, 1, 1, 1},
                                     .points = {{0, 0}, {8.9e307, 0}, {8.9e307, 8.9e307}, {0, 8.9e307}, {-8.9e307, 0}},
                                     .weights = {1, 1e100, 1e200, 1e300, 1e308}});
    const CubicPieces rough = cubic_pieces(beyond, 1e300);
    EXPECT_GT(rough.error, 0.0);
    for (const CubicPiece& piece : rough.pieces)
        for (const core::Point point : piece.control_points()) EXPECT_TRUE(core::is_finite(point));
    const core::Curve cusp = made(
        {.degree = 4, .knots = {0, 0, 0, 0, 0, 1, 1, 1, 1, 1}, .points = {{0, 0}, {1, 1}, {0.5, 1}, {0, 1}, {1, 0}}});
    const CubicPieces pieces = cubic_pieces(cusp, 1e-6);
    EXPECT_LE(pieces.error, 1e-6);
    EXPECT_LT(pieces.pieces.size(), 500u);
}

}  // namespace batten::exchange
