#include "core/evaluate/basis_pieces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/curve/knot_kinds.h"
#include "core/evaluate/basis_triangle.h"
#include "tests/core/random_curves.h"

namespace batten::core {

namespace {

using Fractions = std::vector<Fraction>;

// numerators / denominator in lowest terms, the constant first.
Fractions over(std::int64_t denominator, const std::vector<std::int64_t>& numerators) {
    Fractions fractions;
    for (const std::int64_t numerator : numerators) {
        const std::int64_t common = std::gcd(numerator, denominator);
        fractions.push_back({numerator / common, denominator / common});
    }
    return fractions;
}

double at(const PowerForm& form, double x) {
    double value = 0.0;
    for (std::size_t k = form.coefficients.size(); k-- > 0;) value = value * x + form.coefficients[k];
    return value;
}

void expect_rounded_fractions(const PowerForm& form, double allowed) {
    ASSERT_EQ(form.fractions.size(), form.coefficients.size());
    for (std::size_t k = 0; k < form.fractions.size(); ++k)
        EXPECT_NEAR(form.fractions[k].value(), form.coefficients[k], allowed);
}

}  // namespace

TEST(BasisPieces, of_the_uniform_cubic_are_those_of_every_lecture) {
    const auto knots = KnotVector::make(3, {0, 1, 2, 3, 4, 5, 6, 7}).value();
    for (std::size_t i = 0; i < 4; ++i) {
        const auto pieces = basis_pieces(knots, i, 3);
        ASSERT_EQ(pieces.size(), 4u);
        EXPECT_EQ(pieces[0].in_t.fractions, over(6, {0, 0, 0, 1}));
        EXPECT_EQ(pieces[1].in_t.fractions, over(6, {1, 3, 3, -3}));
        EXPECT_EQ(pieces[2].in_t.fractions, over(6, {4, 0, -6, 3}));
        EXPECT_EQ(pieces[3].in_t.fractions, over(6, {1, -3, 3, -1}));
        for (std::size_t s = 0; s < 4; ++s) {
            EXPECT_EQ(pieces[s].span, i + s);
            EXPECT_EQ(pieces[s].interval, (Interval{static_cast<double>(i + s), static_cast<double>(i + s + 1)}));
            expect_rounded_fractions(pieces[s].in_t, 1e-15);
        }
    }
    const auto first = basis_pieces(knots, 0, 3);
    EXPECT_EQ(first[0].in_u.fractions, over(6, {0, 0, 0, 1}));
    EXPECT_EQ(first[1].in_u.fractions, over(6, {4, -12, 12, -3}));
    EXPECT_EQ(first[2].in_u.fractions, over(6, {-44, 60, -24, 3}));
    EXPECT_EQ(first[3].in_u.fractions, over(6, {64, -48, 12, -1}));
}

TEST(BasisPieces, of_lower_degree_are_those_on_the_way) {
    const auto knots = KnotVector::make(3, {0, 1, 2, 3, 4, 5, 6, 7}).value();
    const auto constant = basis_pieces(knots, 2, 0);
    ASSERT_EQ(constant.size(), 1u);
    EXPECT_EQ(constant[0].interval, (Interval{2, 3}));
    EXPECT_EQ(constant[0].in_u.fractions, over(1, {1}));
    const auto hat = basis_pieces(knots, 1, 1);
    ASSERT_EQ(hat.size(), 2u);
    EXPECT_EQ(hat[0].in_u.fractions, over(1, {-1, 1}));
    EXPECT_EQ(hat[1].in_u.fractions, over(1, {3, -1}));
    const auto parabolas = basis_pieces(knots, 0, 2);
    ASSERT_EQ(parabolas.size(), 3u);
    EXPECT_EQ(parabolas[0].in_u.fractions, over(2, {0, 0, 1}));
    EXPECT_EQ(parabolas[1].in_u.fractions, over(2, {-3, 6, -2}));
    EXPECT_EQ(parabolas[2].in_u.fractions, over(2, {9, -6, 1}));
}

TEST(BasisPieces, of_a_clamped_cubic_have_one_two_and_three_pieces) {
    const auto knots = KnotVector::make(3, {0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4}).value();
    const auto first = basis_pieces(knots, 0, 3);
    ASSERT_EQ(first.size(), 1u);
    EXPECT_EQ(first[0].in_u.fractions, over(1, {1, -3, 3, -1}));
    const auto second = basis_pieces(knots, 1, 3);
    ASSERT_EQ(second.size(), 2u);
    EXPECT_EQ(second[0].in_u.fractions, over(4, {0, 12, -18, 7}));
    EXPECT_EQ(second[1].in_u.fractions, over(4, {8, -12, 6, -1}));
    const auto third = basis_pieces(knots, 2, 3);
    ASSERT_EQ(third.size(), 3u);
    EXPECT_EQ(third[0].span, 3u);
    EXPECT_EQ(third[0].in_u.fractions, over(12, {0, 0, 18, -11}));
    EXPECT_EQ(third[1].in_u.fractions, over(12, {-18, 54, -36, 7}));
    EXPECT_EQ(third[2].in_u.fractions, over(6, {27, -27, 9, -1}));
}

TEST(BasisPieces, of_knots_that_are_fractions) {
    // The quadratic Bernstein polynomials over [1/4, 3/4]: t = 2 u - 1/2.
    const auto knots = KnotVector::make(2, {0.25, 0.25, 0.25, 0.75, 0.75, 0.75}).value();
    const auto pieces = basis_pieces(knots, 1, 2);
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_EQ(pieces[0].in_t.fractions, over(1, {0, 2, -2}));
    EXPECT_EQ(pieces[0].in_u.fractions, over(2, {-3, 16, -16}));
    // Doubles that stand for thirds.
    const auto thirds = KnotVector::make(1, {0, 0, 1.0 / 3, 1, 1}).value();
    EXPECT_EQ(basis_pieces(thirds, 1, 1)[1].in_u.fractions, over(2, {3, -3}));
}

TEST(BasisPieces, of_one_knot_alone_there_are_none) {
    const auto knots = KnotVector::make(2, {0, 0, 0, 1, 1, 1}).value();
    EXPECT_TRUE(basis_pieces(knots, 0, 0).empty());
    EXPECT_TRUE(basis_pieces(knots, 0, 1).empty());
    EXPECT_EQ(basis_pieces(knots, 1, 1).size(), 1u);
}

TEST(BasisPieces, have_no_fractions_where_knots_are_none) {
    const auto irrational = KnotVector::make(2, {0, 0, 0, std::sqrt(0.5), 1, 1, 1}).value();
    const auto piece = basis_pieces(irrational, 0, 2)[0];
    EXPECT_TRUE(piece.in_u.fractions.empty());
    EXPECT_TRUE(piece.in_t.fractions.empty());
    EXPECT_NEAR(piece.in_u.coefficients[2], 2.0, 1e-15);
    EXPECT_NEAR(piece.in_u.coefficients[1], -2.0 * std::sqrt(2.0), 1e-15);
    // Two knots that stand for the same fraction are not one.
    const auto near = KnotVector::make(1, {0, 0, 1e-17, 1, 1}).value();
    EXPECT_TRUE(basis_pieces(near, 1, 1)[0].in_t.fractions.empty());
    EXPECT_EQ(basis_pieces(near, 1, 1)[0].in_t.coefficients, (std::vector<double>{0, 1}));
}

TEST(BasisPieces, of_degree_25_overflow_into_doubles) {
    const auto knots = make_knots(KnotKind::uniform, 25, 27).value();
    const auto pieces = basis_pieces(knots, 0, 25);
    ASSERT_EQ(pieces.size(), 26u);
    for (const BasisPiece& piece : pieces) {
        EXPECT_TRUE(piece.in_u.fractions.empty());
        const double middle = piece.interval.lower + 0.5 * piece.interval.length();
        EXPECT_NEAR(at(piece.in_t, 0.5), basis_triangle(knots, 0, middle).value(), 1e-14);
    }
}

TEST(BasisPieces, are_the_function) {
    RandomCurves random(53);
    for (int round = 0; round < 200; ++round) {
        const KnotVector knots = random.curve().knots();
        const auto p = static_cast<std::size_t>(knots.degree());
        const auto i = static_cast<std::size_t>(random.whole(0, static_cast<int>(knots.size() - p) - 2));
        for (const BasisPiece& piece : basis_pieces(knots, i, knots.degree()))
            for (const double t : {0.125, 0.5, 0.875}) {
                const double u = piece.interval.lower + t * piece.interval.length();
                const double exact_t = (u - piece.interval.lower) / piece.interval.length();
                EXPECT_NEAR(at(piece.in_t, exact_t), basis_triangle(knots, i, u).value(), 1e-12);
            }
    }
}

}  // namespace batten::core
