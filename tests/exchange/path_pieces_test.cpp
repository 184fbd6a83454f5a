#include "exchange/path_pieces.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "core/evaluate/evaluate.h"
#include "core/make/conics.h"
#include "core/measure/nearest.h"
#include "tests/core/made_curve.h"

namespace batten::exchange {

namespace {

core::Curve curve_of(const PathPiece& piece) {
    const auto points = piece.control_points();
    core::CurveDefinition definition{.degree = piece.degree, .points = {points.begin(), points.end()}};
    definition.knots.assign(points.size(), 0.0);
    definition.knots.insert(definition.knots.end(), points.size(), 1.0);
    return core::made_curve(std::move(definition));
}

// The largest distance of places on the pieces from the curve, and of places on the curve from the pieces.
double seen_error(const core::Curve& curve, const PathPieces& made) {
    const core::NearestFinder on_curve(curve);
    double error = 0.0;
    for (const PathPiece& piece : made.pieces) {
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
        for (const PathPiece& piece : made.pieces)
            nearest = std::min(nearest, core::distance(point, core::nearest_point(curve_of(piece), point).point));
        error = std::max(error, nearest);
    }
    return error;
}

}  // namespace

TEST(PathPieces, AreTheControlPointsOfAPolynomialOfDegreeThree) {
    const core::Curve curve = core::made_curve(
        {.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{0, 0}, {1, 2}, {3, 2}, {4, -0.0}}});
    const PathPieces pieces = path_pieces(curve, 1e-3);
    ASSERT_EQ(pieces.pieces.size(), 1u);
    EXPECT_EQ(pieces.error, 0.0);
    EXPECT_FALSE(pieces.pieces[0].closes);
    EXPECT_TRUE(pieces.pieces[0].is_first);
    EXPECT_EQ(pieces.pieces[0].points, (std::array<core::Point, 4>{{{0, 0}, {1, 2}, {3, 2}, {4, 0}}}));
    EXPECT_TRUE(std::signbit(pieces.pieces[0].points[3].y));
}

TEST(PathPieces, KeepTheDegreeOfLinesAndParabolas) {
    // A uniform quadratic: the pieces of its spans begin and end in the middles of the legs.
    const core::Curve curve =
        core::made_curve({.degree = 2, .knots = {0, 1, 2, 3, 4, 5, 6}, .points = {{0, 0}, {2, 0}, {2, 2}, {6, 2}}});
    const PathPieces pieces = path_pieces(curve, 1e-3);
    ASSERT_EQ(pieces.pieces.size(), 2u);
    EXPECT_EQ(pieces.error, 0.0);
    EXPECT_EQ(pieces.pieces[1].degree, 2);
    EXPECT_EQ(pieces.pieces[1].points[0], (core::Point{2, 1}));
    EXPECT_EQ(pieces.pieces[1].points[1], (core::Point{2, 2}));
    EXPECT_EQ(pieces.pieces[1].points[2], (core::Point{4, 2}));
    EXPECT_FALSE(pieces.pieces[1].is_first);
    EXPECT_EQ(path_pieces(core::made_curve({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {2, 0}}}), 1.0)
                  .pieces[0]
                  .degree,
              1);
}

TEST(PathPieces, OfEqualWeightsAreExactAndOfOthersAreNot) {
    core::CurveDefinition definition{
        .degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{1, 0}, {1, 1}, {0, 1}}, .weights = {3, 3, 3}};
    EXPECT_EQ(path_pieces(core::made_curve(definition), 1e-3).error, 0.0);
    definition.weights = {1, std::sqrt(0.5), 1};
    EXPECT_GT(path_pieces(core::made_curve(definition), 1e-3).error, 0.0);
}

// One cubic for a quarter of the unit circle that meets it at its ends and middle has handles 4/3 (sqrt 2 - 1) and is
// beyond it by 2.7253e-4.
TEST(PathPieces, OfAQuarterCircleAreTheKnownCubic) {
    const core::Curve arc = core::made_curve({.degree = 2,
                                              .knots = {0, 0, 0, 1, 1, 1},
                                              .points = {{1, 0}, {1, 1}, {0, 1}},
                                              .weights = {1, std::sqrt(0.5), 1}});
    const PathPieces pieces = path_pieces(arc, 5e-3);
    ASSERT_EQ(pieces.pieces.size(), 1u);
    EXPECT_NEAR(pieces.pieces[0].points[1].y, 4.0 / 3.0 * (std::numbers::sqrt2 - 1.0), 1e-15);
    EXPECT_NEAR(pieces.pieces[0].points[2].x, 4.0 / 3.0 * (std::numbers::sqrt2 - 1.0), 1e-15);
    EXPECT_GE(pieces.error, 2.7253e-4);
    EXPECT_LE(pieces.error, 2.5e-3);
}

TEST(PathPieces, OfACircleAreFewAndWithinTheTolerance) {
    const core::Curve circle = core::circle({1e6, -3}, 2.0).value();
    for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
        const PathPieces pieces = path_pieces(circle, tolerance);
        EXPECT_TRUE(pieces.pieces.back().closes);
        EXPECT_LE(pieces.error, tolerance);
        EXPECT_LE(pieces.pieces.size(), 32u) << tolerance;
        for (const PathPiece& piece : pieces.pieces)
            for (int k = 0; k <= 20; ++k) {
                const core::Point point = core::point_at(curve_of(piece), k / 20.0);
                EXPECT_NEAR(std::hypot(point.x - 1e6, point.y + 3), 2.0, pieces.error + 1e-9);
            }
    }
}

TEST(PathPieces, OfHighDegreesAndUnequalWeightsAreWithinTheirBound) {
    const core::Curve quintic = core::made_curve({.degree = 5,
                                                  .knots = {0, 0, 0, 0, 0, 0, 0.3, 1, 1, 1, 1, 1, 1},
                                                  .points = {{0, 0}, {1, 3}, {2, -3}, {3, 4}, {5, 0}, {6, 2}, {4, 5}}});
    const core::Curve rational = core::made_curve({.degree = 3,
                                                   .knots = {0, 0, 0, 0, 1, 2, 2, 3, 3, 3, 3},
                                                   .points = {{0, 0}, {1, 3}, {2, -3}, {3, 4}, {5, 0}, {6, 2}, {4, 5}},
                                                   .weights = {1, 20, 0.05, 3, 1, 7, 2}});
    for (const core::Curve& curve : {quintic, rational}) {
        const PathPieces pieces = path_pieces(curve, 1e-3);
        EXPECT_LE(pieces.error, 1e-3);
        EXPECT_GT(pieces.error, 0.0);
        EXPECT_LE(seen_error(curve, pieces), pieces.error * 1.0001);
    }
}

// Curves of 16 units and of 1024 far from the origin, where doubles are an eighth apart. They are compared where they
// are moved back to the origin, which takes no rounding.
TEST(PathPieces, FarFromTheOriginAreWithinTheirBoundRoundingAndAll) {
    constexpr double far = 1e15;
    std::mt19937 engine(7);
    for (const int size : {16, 1024})
        for (int degree = 2; degree <= 6; ++degree) {
            const std::size_t order = static_cast<std::size_t>(degree) + 1;
            core::CurveDefinition near{.degree = degree, .knots = std::vector<double>(order, 0.0)};
            for (const double u : {0.1, 0.3, 0.7, 0.9}) near.knots.push_back(u);
            near.knots.insert(near.knots.end(), order, 1.0);
            std::uniform_int_distribution<int> place(0, size);
            std::uniform_real_distribution<double> weight(0.2, 5.0);
            for (std::size_t i = 0; i < order + 4; ++i) {
                near.points.push_back({place(engine) * 1.0, place(engine) * 1.0});
                near.weights.push_back(weight(engine));
            }
            core::CurveDefinition moved = near;
            for (core::Point& point : moved.points) point += core::Vector(far, -far);
            PathPieces pieces = path_pieces(core::made_curve(moved), 1e-6 * size);
            for (PathPiece& piece : pieces.pieces)
                for (core::Point& point : piece.points) point -= core::Vector(far, -far);
            EXPECT_LE(seen_error(core::made_curve(near), pieces), pieces.error) << size << ' ' << degree;
            EXPECT_LE(pieces.error, 1e-13 * far) << "which is not much more";
        }
}

TEST(PathPieces, OfDegreeTwentyFiveAreWithinTheTolerance) {
    core::CurveDefinition definition{.degree = 25};
    definition.knots.assign(26, 0.0);
    definition.knots.insert(definition.knots.end(), 26, 1.0);
    for (int i = 0; i <= 25; ++i) definition.points.push_back({i * 1.0, (i * 7 % 5) * 1.0});
    const core::Curve curve = core::made_curve(definition);
    const PathPieces pieces = path_pieces(curve, 1e-4);
    EXPECT_LE(pieces.error, 1e-4);
    EXPECT_LE(seen_error(curve, pieces), 1e-4);
}

TEST(PathPieces, OfAPeriodicCurveAreClosed) {
    const core::Curve curve = core::made_curve(
        {.degree = 3, .knots = {0, 1, 2, 3, 4.5}, .points = {{0, 0}, {2, 0}, {2, 2}, {0.1, 2}}, .periodic = true});
    const PathPieces pieces = path_pieces(curve, 1e-3);
    EXPECT_EQ(pieces.pieces.size(), 4u);
    EXPECT_EQ(pieces.error, 0.0);
    EXPECT_TRUE(pieces.pieces.back().closes);
}

TEST(PathPieces, BeginAnewWhereTheCurveComesApart) {
    const core::Curve torn = core::made_curve({.degree = 1,
                                               .knots = {0, 0, 1, 1, 2, 2},
                                               .points = {{0, 0}, {1, 0}, {1, 1}, {2, 1}},
                                               .tears = core::Tears::allow});
    const PathPieces pieces = path_pieces(torn, 1e-3);
    ASSERT_EQ(pieces.pieces.size(), 2u);
    EXPECT_TRUE(pieces.pieces[1].is_first);
    EXPECT_EQ(pieces.pieces[1].points[0], (core::Point{1, 1}));
}

TEST(PathPieces, OfTenThousandRationalPiecesTakeNoTime) {
    core::CurveDefinition definition{.degree = 3};
    for (int i = 0; i < 10000; ++i) {
        definition.points.push_back({i * 0.01, std::sin(i * 0.05)});
        definition.weights.push_back(1.0 + 0.5 * (i % 3));
        definition.knots.push_back(i);
    }
    for (int i = 0; i < 4; ++i) definition.knots.push_back(10000.0 + i);
    const PathPieces pieces = path_pieces(core::made_curve(std::move(definition)), 1e-4);
    EXPECT_LE(pieces.error, 1e-4);
    EXPECT_LT(pieces.pieces.size(), 40000u);
}

TEST(PathPieces, EndForHugeAndTinyNumbersAndCusps) {
    const std::vector<double> weights{1, 1e-300, 1e300, 1, 2};
    for (const double size : {1e300, 1e-300, 1.0}) {
        const core::Curve curve =
            core::made_curve({.degree = 4,
                              .knots = {0, 0, 0, 0, 0, 1, 1, 1, 1, 1},
                              .points = {{0, 0}, {size, size}, {-size, size}, {size, 0}, {0, size}},
                              .weights = weights});
        const PathPieces pieces = path_pieces(curve, 1e-3 * size);
        EXPECT_LT(pieces.pieces.size(), 200u) << size;
        EXPECT_LE(pieces.error, 1e-3 * size) << size;
        EXPECT_GT(pieces.error, 0.0) << size;
        // It goes to the third point and back, whose weight outdoes all others.
        double nearest = HUGE_VAL;
        for (const PathPiece& piece : pieces.pieces)
            for (const core::Point point : piece.control_points())
                nearest = std::min(nearest, core::robust_length(point - core::Point(-size, size)));
        EXPECT_LT(nearest, 1e-3 * size);
    }
    // Sums of coordinates and weights are beyond doubles.
    const core::Curve beyond =
        core::made_curve({.degree = 4,
                          .knots = {0, 0, 0, 0, 0, 1, 1, 1, 1, 1},
                          .points = {{0, 0}, {8.9e307, 0}, {8.9e307, 8.9e307}, {0, 8.9e307}, {-8.9e307, 0}},
                          .weights = {1, 1e100, 1e200, 1e300, 1e308}});
    const PathPieces rough = path_pieces(beyond, 1e300);
    EXPECT_LE(rough.error, 1e300);
    EXPECT_GT(rough.error, 0.0);
    for (const PathPiece& piece : rough.pieces)
        for (const core::Point point : piece.control_points()) EXPECT_TRUE(core::is_finite(point));
    const core::Curve cusp = core::made_curve(
        {.degree = 4, .knots = {0, 0, 0, 0, 0, 1, 1, 1, 1, 1}, .points = {{0, 0}, {1, 1}, {0.5, 1}, {0, 1}, {1, 0}}});
    const PathPieces pieces = path_pieces(cusp, 1e-6);
    EXPECT_LE(pieces.error, 1e-6);
    EXPECT_LT(pieces.pieces.size(), 500u);
}

// Weights from a thousandth to a thousand: the bound is as near to what is seen as asked for, and is not exceeded.
TEST(PathPieces, OfWildWeightsAreWithinTheTolerance) {
    const core::Curve curve = core::made_curve({.degree = 4,
                                                .knots = {0, 0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5, 5},
                                                .points = {{-3.2, -2.2},
                                                           {3.1, 1.4},
                                                           {3.1, -1.5},
                                                           {-3.7, -2.1},
                                                           {2.9, -2.3},
                                                           {-1.5, -0.8},
                                                           {-0.8, -0.9},
                                                           {4.2, -3.4},
                                                           {-5, 4.4}},
                                                .weights = {0.001, 1000, 1, 1, 1000, 0.001, 1, 5, 1}});
    for (const double tolerance : {1e-2, 1e-5}) {
        const PathPieces pieces = path_pieces(curve, tolerance);
        EXPECT_LE(pieces.error, tolerance);
        EXPECT_LT(pieces.pieces.size(), 1000u);
        const double seen = seen_error(curve, pieces);
        EXPECT_LE(seen, pieces.error * 1.0001);
        EXPECT_GE(seen, pieces.error * 0.01);
    }
    for (const double tolerance : {1.0, 1e-3, 1e-6, 1e-9, 1e-12}) {
        EXPECT_LE(path_pieces(curve, tolerance).error, std::max(tolerance, 1e-11)) << "what rounding can add";
        EXPECT_LT(path_pieces(curve, tolerance).pieces.size(), 5000u);
    }
}

TEST(PathPieces, EndWhereRoundingDoes) {
    const core::Curve arc = core::made_curve(
        {.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{1, 0}, {1, 1}, {0, 1}}, .weights = {1, 3, 1}});
    for (const double tolerance : {1e-300, std::nan("")}) {
        const PathPieces pieces = path_pieces(arc, tolerance);
        EXPECT_LT(pieces.pieces.size(), 2000u);
        EXPECT_LT(pieces.error, 1e-12) << "most of which is what rounding can add";
        EXPECT_GT(pieces.error, 0.0);
    }
}

TEST(PathPieces, AreBounded) {
    core::CurveDefinition definition{.degree = 2};
    for (int i = 0; i < 100; ++i) {
        definition.points.push_back({i % 7 * 1.0, i % 11 * 1.0});
        definition.weights.push_back(1.0 + i % 3);
    }
    for (int i = 0; i < 103; ++i) definition.knots.push_back(i);
    const core::Curve curve = core::made_curve(std::move(definition));
    EXPECT_EQ(path_pieces(curve, 1e-9, Arcs::as_cubics, 200).pieces.size(), 298u);
    EXPECT_EQ(path_pieces(curve, 1e-9, Arcs::as_cubics, 0).pieces.size(), 98u);
    EXPECT_GT(path_pieces(curve, 1e-9, Arcs::as_cubics, 200).error, 1e-9);
    EXPECT_LE(path_pieces(curve, 1e-9).error, 1e-9);
}

TEST(PathPieces, AreArcsOnRequest) {
    const core::Curve circle = core::circle({3, 4}, 2.0).value();
    const PathPieces arcs = path_pieces(circle, 1e-3, Arcs::as_arcs);
    EXPECT_EQ(arcs.error, 0.0);
    for (const PathPiece& piece : arcs.pieces) {
        EXPECT_EQ(piece.degree, 0);
        EXPECT_DOUBLE_EQ(piece.radius, 2.0);
        EXPECT_TRUE(piece.is_counterclockwise);
    }
    EXPECT_TRUE(arcs.pieces.back().closes);
    EXPECT_EQ(path_pieces(circle, 1e-3).pieces[0].degree, 3);
}

// Where doubles are 1/8 apart no one knows that this conic is no circle, but how far it may be from one.
TEST(PathPieces, TellWhatRoundingHidesOfArcs) {
    const double far = 1e15;
    const core::Curve conic = core::made_curve({.degree = 2,
                                                .knots = {0, 0, 0, 1, 1, 1},
                                                .points = {{far, far}, {far + 1, far}, {far + 1, far + 1}},
                                                .weights = {1, 0.5, 1}});
    const PathPieces pieces = path_pieces(conic, 1e-3, Arcs::as_arcs);
    EXPECT_EQ(pieces.pieces[0].degree, 3) << "0.7 would be a circle";
    const core::Curve circle = core::circle({1e9, 1e9}, 2.0).value();
    const PathPieces arcs = path_pieces(circle, 1e-3, Arcs::as_arcs);
    ASSERT_EQ(arcs.pieces[0].degree, 0);
    EXPECT_GT(arcs.error, 2 * std::abs(arcs.pieces[0].radius - 2.0));
    EXPECT_LT(arcs.error, 1e-4);
}

TEST(PathPieces, CloseWhereTheyEndBitEqual) {
    // Fourths of thirds, whose end over the seam is rounded otherwise than the start.
    const core::Curve periodic =
        core::made_curve({.degree = 3,
                          .knots = {0, 1, 2, 3, 4, 5},
                          .points = {{0.1, 0.3}, {2.7, 0.1}, {2.2, 2.9}, {0.1, 2.3}, {-1.7, 1.1}},
                          .periodic = true});
    const PathPieces closed = path_pieces(periodic, 1e-3);
    EXPECT_TRUE(closed.pieces.back().closes);
    EXPECT_EQ(closed.pieces.back().end(), closed.pieces.front().start());
    const core::Curve clamped = core::made_curve(
        {.degree = 2, .knots = {0, 0, 0, 1, 1, 2, 2, 2}, .points = {{0, 0}, {1, 2}, {2, 0}, {1, -2}, {0, 0}}});
    EXPECT_FALSE(path_pieces(clamped, 1e-3).pieces[0].closes);
    EXPECT_TRUE(path_pieces(clamped, 1e-3).pieces[1].closes);
}

// Two triangles, the first of which ends where it began, and a curve that only touches itself at its tear.
TEST(PathPieces, AreJoinedAndClosedRunByRun) {
    const core::Curve torn = core::made_curve({.degree = 1,
                                               .knots = {0, 0, 1, 2, 3, 3, 4, 5, 5},
                                               .points = {{0, 0}, {1, 0}, {0, 1}, {0, 0}, {5, 5}, {6, 5}, {6, 7}},
                                               .tears = core::Tears::allow});
    const PathPieces pieces = path_pieces(torn, 1e-3);
    ASSERT_EQ(pieces.pieces.size(), 5u);
    std::string marks;
    for (const PathPiece& piece : pieces.pieces) {
        marks += piece.is_first ? 'M' : '-';
        marks += piece.closes ? 'Z' : '-';
    }
    EXPECT_EQ(marks, "M----ZM---");
    const core::Curve whole = core::made_curve({.degree = 1,
                                                .knots = {0, 0, 1, 1, 2, 2},
                                                .points = {{0, 0}, {1, 0}, {1, 0}, {2, 1}},
                                                .tears = core::Tears::allow});
    EXPECT_FALSE(path_pieces(whole, 1e-3).pieces[1].is_first);
}

// Differences of points are beyond doubles.
TEST(PathPieces, OfPointsTooFarApartAreNotExact) {
    const core::Curve curve = core::made_curve(
        {.degree = 3,
         .knots = {0, 1, 2, 3, 4, 5},
         .points = {{1.7e308, 0}, {-1.7e308, 1.7e308}, {-1.7e308, -1.7e308}, {1.7e308, -1e308}, {0, 1.7e308}},
         .periodic = true});
    EXPECT_EQ(path_pieces(curve, 1e300).error, HUGE_VAL);
}

}  // namespace batten::exchange
