#include "core/evaluate/uniform_cubic_conditions.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "core/evaluate/basis.h"

namespace batten::core {

namespace {

Fraction reduced(std::int64_t numerator, std::int64_t denominator) {
    const std::int64_t common = std::gcd(numerator, denominator) * (denominator < 0 ? -1 : 1);
    return {numerator / common, denominator / common};
}

Fraction times(Fraction a, Fraction b) {
    return reduced(a.numerator * b.numerator, a.denominator * b.denominator);
}

Fraction over(Fraction a, Fraction b) {
    return reduced(a.numerator * b.denominator, a.denominator * b.numerator);
}

Fraction less(Fraction a, Fraction b) {
    return reduced(a.numerator * b.denominator - b.numerator * a.denominator, a.denominator * b.denominator);
}

// The unknown k of piece j: 4 j + k; the last number is the right side.
using Equation = std::array<Fraction, 17>;

constexpr int falling(int k, int order) {
    return order == 0 ? 1 : k * falling(k - 1, order - 1);
}

// The r-th derivatives agree of the pieces over [q - 1, q] and [q, q + 1] of the support [0, 4], each in its own t; the
// piece over [q, q + 1] belongs to the control point 3 - q.
Equation agreement(int q, int r) {
    Equation equation{};
    for (int k = 0; k < 4; ++k) {
        if (q > 0) equation[static_cast<std::size_t>(4 * (4 - q) + k)] = {falling(k, r), 1};
        if (q < 4 && k == r) equation[static_cast<std::size_t>(4 * (3 - q) + k)] = {-falling(k, r), 1};
    }
    return equation;
}

std::vector<Equation> the_fifteen() {
    std::vector<Equation> equations;
    for (int q = 0; q <= 4; ++q)
        for (int r = 0; r <= 2; ++r) equations.push_back(agreement(q, r));
    return equations;
}

void subtract(Equation& from, const Equation& row, Fraction factor) {
    for (std::size_t c = 0; c < 17; ++c) from[c] = less(from[c], times(factor, row[c]));
}

// Gauss and Jordan's elimination; its rank.
std::size_t eliminate(std::vector<Equation>& equations) {
    std::size_t rank = 0;
    for (std::size_t c = 0; c < 16 && rank < equations.size(); ++c) {
        const auto pivot = std::find_if(equations.begin() + static_cast<std::ptrdiff_t>(rank), equations.end(),
                                        [&](const Equation& row) { return row[c].numerator != 0; });
        if (pivot == equations.end()) continue;
        std::swap(equations[rank], *pivot);
        const Fraction lead = equations[rank][c];
        for (Fraction& entry : equations[rank]) entry = over(entry, lead);
        for (std::size_t other = 0; other < equations.size(); ++other)
            if (other != rank) subtract(equations[other], Equation(equations[rank]), Fraction(equations[other][c]));
        ++rank;
    }
    return rank;
}

}  // namespace

TEST(UniformCubicConditions, leave_one_factor_which_the_sum_settles) {
    std::vector<Equation> equations = the_fifteen();
    EXPECT_EQ(eliminate(equations), 15u);
    Equation sum_is_one{};
    for (std::size_t j = 0; j < 4; ++j) sum_is_one[4 * j] = {1, 1};
    sum_is_one[16] = {1, 1};
    equations.push_back(sum_is_one);
    ASSERT_EQ(eliminate(equations), 16u);
    for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t k = 0; k < 4; ++k)
            EXPECT_EQ(uniform_cubic_piece(j)[k], equations[4 * j + k][16]) << j << ' ' << k;
}

TEST(UniformCubicConditions, have_the_pieces_of_the_lecture) {
    EXPECT_EQ(uniform_cubic_piece(0), (std::array<Fraction, 4>{{{1, 6}, {-1, 2}, {1, 2}, {-1, 6}}}));
    EXPECT_EQ(uniform_cubic_piece(1), (std::array<Fraction, 4>{{{2, 3}, {0, 1}, {-1, 1}, {1, 2}}}));
    EXPECT_EQ(uniform_cubic_piece(2), (std::array<Fraction, 4>{{{1, 6}, {1, 2}, {1, 2}, {-1, 2}}}));
    EXPECT_EQ(uniform_cubic_piece(3), (std::array<Fraction, 4>{{{0, 1}, {0, 1}, {0, 1}, {1, 6}}}));
}

TEST(UniformCubicConditions, have_the_values_of_the_pieces) {
    // (1 - t)^3 / 6 and so on at t = 1/2: 1, 23, 23 and 1 of 48.
    EXPECT_DOUBLE_EQ(uniform_cubic_value(0, 0.5), 1.0 / 48.0);
    EXPECT_DOUBLE_EQ(uniform_cubic_value(1, 0.5), 23.0 / 48.0);
    EXPECT_DOUBLE_EQ(uniform_cubic_value(0, 0.25), 27.0 / 384.0);
    EXPECT_DOUBLE_EQ(uniform_cubic_value(1, 0.25), 235.0 / 384.0);
    EXPECT_DOUBLE_EQ(uniform_cubic_value(2, 0.25), 121.0 / 384.0);
    EXPECT_DOUBLE_EQ(uniform_cubic_value(3, 0.25), 1.0 / 384.0);
}

TEST(UniformCubicConditions, have_both_sides_with_their_numbers) {
    const std::array<Fraction, 15> expected{{{0, 1},
                                             {0, 1},
                                             {0, 1},
                                             {1, 6},
                                             {1, 2},
                                             {1, 1},
                                             {2, 3},
                                             {0, 1},
                                             {-2, 1},
                                             {1, 6},
                                             {-1, 2},
                                             {1, 1},
                                             {0, 1},
                                             {0, 1},
                                             {0, 1}}};
    const auto conditions = uniform_cubic_conditions();
    for (std::size_t i = 0; i < 15; ++i) {
        EXPECT_EQ(conditions[i].joint, i / 3);
        EXPECT_EQ(conditions[i].order, static_cast<int>(i % 3));
        EXPECT_EQ(conditions[i].left, expected[i]) << i;
        EXPECT_EQ(conditions[i].right, expected[i]) << i;
        EXPECT_TRUE(conditions[i].holds());
    }
    EXPECT_FALSE(conditions[2].before);
    EXPECT_EQ(conditions[2].after, 3u);
    EXPECT_EQ(conditions[3].before, 3u);
    EXPECT_EQ(conditions[3].after, 2u);
    EXPECT_EQ(conditions[14].before, 0u);
    EXPECT_FALSE(conditions[14].after);
    EXPECT_EQ(uniform_cubic_sum(), (std::array<Fraction, 4>{{{1, 1}, {0, 1}, {0, 1}, {0, 1}}}));
}

TEST(UniformCubicConditions, the_numbers_are_those_of_the_basis_function) {
    const KnotVector knots = KnotVector::make(3, {-3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 7}).value();
    for (const UniformCubicCondition& condition : uniform_cubic_conditions()) {
        // N_3 over [0, 4], where the domain is; of the functions that do not vanish the first one is N_{s-3}.
        const double u = static_cast<double>(condition.joint);
        const auto r = static_cast<std::size_t>(condition.order);
        if (condition.after) {
            const BasisValues values = basis_functions(knots, u, 2, Side::right);
            EXPECT_NEAR(condition.right.value(), values.derivatives[r][3 + 3 - values.span], 1e-15);
        }
        if (condition.before) {
            const BasisValues values = basis_functions(knots, u, 2, Side::left);
            EXPECT_NEAR(condition.left.value(), values.derivatives[r][3 + 3 - values.span], 1e-15);
        }
    }
}

}  // namespace batten::core
