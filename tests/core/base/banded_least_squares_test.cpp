#include "core/base/detail/banded_least_squares.h"

#include <gtest/gtest.h>

#include <glm/vec2.hpp>

namespace batten::core {

namespace {

// A number that counts the multiplications with it.
struct Counted {
    double value = 0.0;
    static std::size_t& count() {
        static std::size_t multiplications = 0;
        return multiplications;
    }
    friend Counted operator+(Counted a, Counted b) { return {a.value + b.value}; }
    friend Counted operator-(Counted a, Counted b) { return {a.value - b.value}; }
    friend Counted operator*(double factor, Counted a) {
        ++count();
        return {factor * a.value};
    }
};

// Row i: x_{i-2}/4 + x_{i-1} + 3 x_i + x_{i+1} + x_{i+2}/4 = right, for as many of these as there are.
template <class P>
std::vector<BandedEquation<P>> band(std::size_t n, P right) {
    const double coefficients[] = {0.25, 1, 3, 1, 0.25};
    std::vector<BandedEquation<P>> equations;
    for (std::size_t i = 0; i < n; ++i) {
        BandedEquation<P> equation{i < 2 ? 0 : i - 2, {}, right};
        for (std::size_t j = equation.first; j < std::min(n, i + 3); ++j)
            equation.coefficients.push_back(coefficients[j + 2 - i]);
        equations.push_back(std::move(equation));
    }
    return equations;
}

std::size_t operations(std::size_t n) {
    Counted::count() = 0;
    solve_least_squares(band(n, Counted{1.0}), n);
    return Counted::count();
}

}  // namespace

TEST(BandedLeastSquares, solves_square_equations) {
    const auto equations = band(50, glm::dvec2(1.0, -2.0));
    const auto x = solve_least_squares(equations, 50).value();
    for (const auto& equation : equations) {
        glm::dvec2 sum(0.0);
        for (std::size_t j = 0; j < equation.coefficients.size(); ++j)
            sum += equation.coefficients[j] * x[equation.first + j];
        EXPECT_NEAR(sum.x, 1.0, 1e-15 * 4);
        EXPECT_NEAR(sum.y, -2.0, 1e-15 * 8);
    }
}

TEST(BandedLeastSquares, takes_equations_in_any_order) {
    auto equations = band(30, 1.0);
    const auto expected = solve_least_squares(equations, 30).value();
    std::rotate(equations.begin(), equations.begin() + 17, equations.end());
    EXPECT_EQ(solve_least_squares(equations, 30).value(), expected);
}

// The line a + b t nearest to (0, 1), (1, 2), (2, 2), (3, 4): a = 0.9, b = 0.9.
TEST(BandedLeastSquares, finds_the_least_squares) {
    const std::vector<BandedEquation<double>> equations{
        {0, {1, 0}, 1.0}, {0, {1, 1}, 2.0}, {0, {1, 2}, 2.0}, {0, {1, 3}, 4.0}};
    const auto line = solve_least_squares(equations, 2).value();
    EXPECT_NEAR(line[0], 0.9, 1e-15);
    EXPECT_NEAR(line[1], 0.9, 1e-15);
}

TEST(BandedLeastSquares, says_where_unknowns_are_not_determined) {
    EXPECT_FALSE(solve_least_squares<double>({{0, {1, 1}, 1.0}, {0, {2, 2}, 2.0}}, 2));
    EXPECT_FALSE(solve_least_squares<double>({{0, {1}, 1.0}}, 2));
    EXPECT_TRUE(solve_least_squares<double>({}, 0));
}

TEST(BandedLeastSquares, costs_as_many_operations_on_points_as_the_band_has_entries) {
    const std::size_t for_each_unknown = operations(2000) - operations(1999);
    EXPECT_EQ(operations(4000) - operations(2000), 2000 * for_each_unknown);
    // Four for each rotation with a row of the band, and one for each entry going back.
    EXPECT_LE(for_each_unknown, 4U * 4U + 9U);
}

}  // namespace batten::core
