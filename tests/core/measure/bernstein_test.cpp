#include "core/measure/detail/bernstein.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/measure/detail/sign_runs.h"

namespace batten::core {
namespace {

using Coefficients = Bernstein::Coefficients;

Bernstein exactly(const Coefficients& values) {
    return {values, Coefficients(values.size(), 0.0)};
}

// (t - a) in degree 1, with the error of a rounded number.
Bernstein factor(double a) {
    return {{-a, 1.0 - a}, {1e-16, 1e-16}};
}

Bernstein product_of(const std::vector<double>& zeros) {
    Bernstein result = constant(1.0);
    for (const double zero : zeros) result = product(result, factor(zero));
    return result;
}

TEST(Bernstein, product_of_powers_has_the_coefficients_of_their_definition) {
    // t^2 (1-t) = 1/3 * [3 t^2 (1-t)]
    const Bernstein found = product(product(exactly({0, 1}), exactly({0, 1})), exactly({1, 0}));
    ASSERT_EQ(found.degree(), 3U);
    EXPECT_EQ(found.values[0], 0.0);
    EXPECT_EQ(found.values[1], 0.0);
    EXPECT_NEAR(found.values[2], 1.0 / 3.0, 1e-16);
    EXPECT_EQ(found.values[3], 0.0);
}

TEST(Bernstein, sums_raise_the_lower_degree) {
    // 1 + t - t^2 in degree 2: 1, 3/2, 1.
    const Bernstein found = difference(exactly({1, 2}), exactly({0, 0, 1}));
    ASSERT_EQ(found.degree(), 2U);
    EXPECT_EQ(found.values[0], 1.0);
    EXPECT_EQ(found.values[1], 1.5);
    EXPECT_EQ(found.values[2], 1.0);
    EXPECT_EQ(sum(constant(2.0), exactly({1, 2})).values, (Coefficients{3, 4}));
}

TEST(Bernstein, derivative_halves_and_parts_agree_with_the_polynomial) {
    const Bernstein cubic = exactly({1, -2, 5, 3});
    const auto expected = [](double t) {
        return std::pow(1 - t, 3) - 6 * t * std::pow(1 - t, 2) + 15 * t * t * (1 - t) + 3 * t * t * t;
    };
    const auto slope = [](double t) {
        return -3 * std::pow(1 - t, 2) - 6 * std::pow(1 - t, 2) + 12 * t * (1 - t) + 30 * t * (1 - t) - 15 * t * t +
               9 * t * t;
    };
    const auto [left, right] = halves(cubic);
    const Bernstein inner = part(cubic, {0.25, 0.75});
    for (const double t : {0.0, 0.125, 0.3, 0.5, 0.9, 1.0}) {
        EXPECT_NEAR(value_at(cubic, t), expected(t), 1e-15);
        EXPECT_NEAR(value_at(derivative(cubic), t), slope(t), 1e-14);
        EXPECT_NEAR(value_at(left, t), expected(0.5 * t), 1e-15);
        EXPECT_NEAR(value_at(right, t), expected(0.5 + 0.5 * t), 1e-15);
        EXPECT_NEAR(value_at(inner, t), expected(0.25 + 0.5 * t), 1e-15);
    }
}

TEST(Bernstein, errors_bound_what_rounding_does_to_products) {
    const Bernstein twenty = product_of(std::vector<double>(20, 0.1));
    for (std::size_t k = 0; k <= 20; ++k) {
        // The coefficients of (t - 1/10)^20 are (-1/10)^(20-k) (9/10)^k.
        const long double truth =
            std::pow(-0.1L, static_cast<long double>(20 - k)) * std::pow(0.9L, static_cast<long double>(k));
        EXPECT_LE(std::abs(static_cast<double>(truth) - twenty.values[k]), twenty.errors[k]) << k;
        EXPECT_LE(twenty.errors[k], 1e-12 * std::abs(twenty.values[k])) << k;
    }
}

TEST(Roots, simple_ones_are_found_to_the_last_digits) {
    const std::vector<double> zeros{0.0625, 0.1, 0.3, 1.0 / 3.0, 0.5, 0.7, 0.95};
    const auto found = roots(product_of(zeros));
    ASSERT_EQ(found.size(), zeros.size());
    for (std::size_t k = 0; k < zeros.size(); ++k) EXPECT_NEAR(found[k], zeros[k], 1e-13);
}

TEST(Roots, at_both_ends_and_none_outside) {
    EXPECT_EQ(roots(product_of({0.0, 1.0})), (std::vector<double>{0.0, 1.0}));
    EXPECT_TRUE(roots(product_of({-0.001, 1.001})).empty());
    EXPECT_EQ(roots(product_of({-0.5, 0.25, 2.0})).size(), 1U);
}

TEST(Roots, multiple_ones_are_reported_once) {
    for (const double place : {0.5, 0.3, 0.7123456})
        for (std::size_t multiplicity = 2; multiplicity <= 5; ++multiplicity) {
            auto zeros = std::vector<double>(multiplicity, place);
            zeros.push_back(0.9);
            const auto found = roots(product_of(zeros));
            ASSERT_EQ(found.size(), 2U) << place << " " << multiplicity;
            EXPECT_NEAR(found[0], place, 1e-11) << multiplicity;
            EXPECT_NEAR(found[1], 0.9, 1e-12);
        }
}

TEST(Roots, near_ones_are_told_apart) {
    const auto found = roots(product_of({0.4, 0.4 + 1e-6}));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found[0], 0.4, 1e-9);
    EXPECT_NEAR(found[1], 0.4 + 1e-6, 1e-9);
}

TEST(Roots, a_polynomial_that_vanishes_has_none_but_one_run) {
    const Bernstein nothing{{0, 1e-17, -1e-17}, {1e-16, 1e-16, 1e-16}};
    EXPECT_TRUE(roots(nothing).empty());
    EXPECT_EQ(sign_runs(nothing), (std::vector<SignRun>{{{0, 1}, 0}}));
}

TEST(SignRuns, cover_the_interval_without_gaps) {
    const auto runs = sign_runs(product_of({0.25, 0.25, 0.75}));
    ASSERT_EQ(runs.size(), 5U);
    EXPECT_EQ(runs[0].sign, -1);
    EXPECT_EQ(runs[1].sign, 0);
    EXPECT_EQ(runs[2].sign, -1);
    EXPECT_EQ(runs[4].sign, 1);
    EXPECT_EQ(runs[0].where.lower, 0.0);
    for (std::size_t k = 1; k < 5; ++k) EXPECT_EQ(runs[k].where.lower, runs[k - 1].where.upper);
    EXPECT_EQ(runs[4].where.upper, 1.0);
}

TEST(SignEvents, go_round_where_the_runs_do) {
    const std::vector<SignRun> runs{{{0, 1}, 0}, {{1, 2}, 1}, {{2, 3}, -1}, {{3, 4}, 0}};
    const auto open = sign_events(runs);
    ASSERT_EQ(open.size(), 3U);
    EXPECT_EQ(open[0].before, 0);
    EXPECT_TRUE(open[1].is_change());
    EXPECT_EQ(open[2].after, 0);
    const auto cyclic = sign_events(runs, true);
    ASSERT_EQ(cyclic.size(), 2U);
    EXPECT_EQ(cyclic[0].where, (Interval{2, 2}));
    EXPECT_EQ(cyclic[1].where, (Interval{3, 5}));
    EXPECT_EQ(cyclic[1].before, -1);
    EXPECT_EQ(cyclic[1].after, 1);
    const auto jump = sign_events(std::vector<SignRun>{{{0, 1}, 1}, {{1, 2}, -1}}, true);
    ASSERT_EQ(jump.size(), 2U);
    EXPECT_EQ(jump[0].where, (Interval{0, 0}));
    EXPECT_EQ(jump[0].after, 1);
}

}  // namespace
}  // namespace batten::core
