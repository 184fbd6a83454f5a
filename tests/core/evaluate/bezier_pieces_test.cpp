#include "core/evaluate/bezier_pieces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/curve/knot_analysis.h"
#include "tests/core/random_curves.h"
#include "tests/core/reference.h"

namespace batten::core {

namespace {

// sum B_j(t) P_j, with the Bernstein polynomials written out.
HomogeneousPoint bernstein(const BezierPiece& piece, double t) {
    const auto p = piece.points.size() - 1;
    HomogeneousPoint sum(0.0);
    double binomial = 1.0;
    for (std::size_t j = 0; j <= p; ++j) {
        sum += binomial * std::pow(t, static_cast<double>(j)) * std::pow(1 - t, static_cast<double>(p - j)) *
               piece.points[j];
        binomial *= static_cast<double>(p - j) / static_cast<double>(j + 1);
    }
    return sum;
}

}  // namespace

TEST(BezierPieces, draw_the_curve) {
    RandomCurves random(40);
    for (int k = 0; k < 200; ++k) {
        const Curve curve = random.curve();
        for (const BezierPiece& piece : bezier_pieces(curve)) {
            const double u = random.number(piece.interval.lower, piece.interval.upper);
            const double t = (u - piece.interval.lower) / piece.interval.length();
            const Point point = project(bernstein(piece, t));
            EXPECT_LE(reference::relative_distance(curve, point, reference::point_at(curve, u)), 1e-13);
        }
    }
}

TEST(BezierPieces, cover_the_domain_without_gaps) {
    RandomCurves random(41);
    for (int k = 0; k < 200; ++k) {
        const Curve curve = random.curve();
        const auto pieces = bezier_pieces(curve);
        ASSERT_EQ(pieces.size(), segment_count(curve.knots()));
        EXPECT_EQ(pieces.front().interval.lower, curve.domain().lower);
        EXPECT_EQ(pieces.back().interval.upper, curve.domain().upper);
        for (std::size_t i = 1; i < pieces.size(); ++i) {
            EXPECT_EQ(pieces[i].interval.lower, pieces[i - 1].interval.upper);
            EXPECT_EQ(pieces[i].points.front(), pieces[i - 1].points.back());
            EXPECT_EQ(curve.knots()[pieces[i].span], pieces[i].interval.lower);
        }
    }
}

TEST(BezierPieces, are_the_blossoms_of_the_ends_of_each_span) {
    RandomCurves random(42);
    for (int k = 0; k < 500; ++k) {
        const Curve curve = random.curve();
        const BezierPieces pieces = bezier_pieces(curve);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const BezierPiece expected = bezier_piece(curve, pieces.span(i));
            EXPECT_EQ(pieces.interval(i), expected.interval);
            EXPECT_EQ(pieces[i].span, expected.span);
            EXPECT_EQ(pieces.weights(i).empty(), !curve.is_rational());
            ASSERT_EQ(pieces.points(i).size(), expected.points.size());
            for (std::size_t j = 0; j < expected.points.size(); ++j) {
                const Point found = pieces.points(i)[j];
                const double weight = pieces.weights(i).empty() ? curve.weights()[0] : pieces.weights(i)[j];
                EXPECT_LE(distance(found, project(expected.points[j])), 1e-13);
                EXPECT_NEAR(weight, expected.points[j].z, 1e-14);
                EXPECT_EQ(lift(found, weight), pieces[i].points[j]);
            }
        }
    }
}

TEST(BezierPieces, of_a_bezier_curve_is_itself) {
    const Curve curve = Curve::make({.degree = 3,
                                     .knots = {0, 0, 0, 0, 1, 1, 1, 1},
                                     .points = {{0.1, 0}, {1, 2}, {3, 2}, {4, 0.3}},
                                     .weights = {0.3, 1, 2, 0.7}})
                            .value();
    const auto pieces = bezier_pieces(curve);
    ASSERT_EQ(pieces.size(), 1u);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(pieces[0].points[i], curve.homogeneous_point(i));
}

TEST(BezierPieces, of_a_uniform_cubic_are_the_known_combinations) {
    // One span of the uniform cubic: Bezier points (P0 + 4 P1 + P2)/6, (2 P1 + P2)/3, (P1 + 2 P2)/3, (P1 + 4 P2 +
    // P3)/6.
    const Curve curve =
        Curve::make({.degree = 3, .knots = {0, 1, 2, 3, 4, 5, 6, 7}, .points = {{0, 6}, {6, 0}, {12, 18}, {18, 6}}})
            .value();
    const BezierPiece piece = bezier_piece(curve, 3);
    const std::vector<Point> expected{{6, 4}, {8, 6}, {10, 12}, {12, 13}};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(piece.points[i].x, expected[i].x, 1e-14);
        EXPECT_NEAR(piece.points[i].y, expected[i].y, 1e-14);
    }
}

}  // namespace batten::core
