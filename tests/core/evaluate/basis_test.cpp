#include "core/evaluate/basis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/core/random_curves.h"
#include "tests/core/reference.h"

namespace batten::core {

namespace {

double sum(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

double largest(const std::vector<double>& values) {
    double result = 0.0;
    for (const double value : values) result = std::max(result, std::abs(value));
    return result;
}

}  // namespace

TEST(Basis, of_one_cubic_piece_are_the_bernstein_polynomials) {
    const auto knots = KnotVector::make(3, {0, 0, 0, 0, 1, 1, 1, 1}).value();
    const BasisValues basis = basis_functions(knots, 0.25, 3);
    EXPECT_EQ(basis.span, 3u);
    const std::vector<std::vector<double>> expected{{27.0 / 64, 27.0 / 64, 9.0 / 64, 1.0 / 64},
                                                    {-27.0 / 16, 9.0 / 16, 15.0 / 16, 3.0 / 16},
                                                    {4.5, -7.5, 1.5, 1.5},
                                                    {-6, 18, -18, 6}};
    for (std::size_t r = 0; r <= 3; ++r)
        for (std::size_t j = 0; j <= 3; ++j) EXPECT_NEAR(basis.derivatives[r][j], expected[r][j], 1e-14);
}

TEST(Basis, derivatives_above_the_degree_are_zero) {
    const auto knots = KnotVector::make(1, {0, 0, 1, 1}).value();
    const BasisValues basis = basis_functions(knots, 0.5, 3);
    ASSERT_EQ(basis.derivatives.size(), 4u);
    EXPECT_EQ(basis.derivatives[1], (BasisRow{-1, 1}));
    EXPECT_EQ(basis.derivatives[2], (BasisRow{0, 0}));
    EXPECT_EQ(basis.derivatives[3], (BasisRow{0, 0}));
}

TEST(Basis, is_positive_and_sums_to_one_and_its_derivatives_to_zero) {
    RandomCurves random(3);
    for (int k = 0; k < 500; ++k) {
        const Curve curve = random.curve();
        const Side side = random.whole(0, 1) == 0 ? Side::left : Side::right;
        const BasisValues basis = basis_functions(curve.knots(), random.parameter(curve), curve.degree(), side);
        for (const double value : basis.derivatives[0]) EXPECT_GE(value, 0.0);
        EXPECT_NEAR(sum(basis.derivatives[0]), 1.0, 1e-14);
        for (std::size_t r = 1; r < basis.derivatives.size(); ++r)
            EXPECT_NEAR(sum(basis.derivatives[r]), 0.0, 1e-13 * largest(basis.derivatives[r]));
    }
}

TEST(Basis, agrees_with_the_recursion_of_cox_and_de_boor) {
    RandomCurves random(4);
    for (int k = 0; k < 200; ++k) {
        const Curve curve = random.curve();
        const double u = random.parameter(curve);
        const auto p = static_cast<std::size_t>(curve.degree());
        const BasisValues basis = basis_functions(curve.knots(), u, 0, Side::left);
        const double inside = curve.knots().into_domain(u, Side::left);
        for (std::size_t j = 0; j <= p; ++j) {
            const auto expected = reference::basis_function(curve.knots().values(), p, basis.span - p + j, basis.span,
                                                            static_cast<long double>(inside));
            EXPECT_NEAR(basis.derivatives[0][j], static_cast<double>(expected), 1e-14);
        }
    }
}

TEST(Basis, one_function_is_the_same_as_among_all) {
    RandomCurves random(5);
    for (int k = 0; k < 200; ++k) {
        const Curve curve = random.open_curve();
        const double u = random.parameter(curve);
        const auto p = static_cast<std::size_t>(curve.degree());
        const BasisValues basis = basis_functions(curve.knots(), u);
        for (std::size_t i = 0; i < curve.control_points().size(); ++i) {
            const bool vanishes = i + p < basis.span || i > basis.span;
            const double expected = vanishes ? 0.0 : basis.derivatives[0][i + p - basis.span];
            EXPECT_NEAR(basis_function(curve.knots(), i, u), expected, 1e-15);
        }
    }
}

TEST(Basis, periodic_functions_sum_to_one_also_where_they_overlap_themselves) {
    RandomCurves random(6);
    for (int k = 0; k < 300; ++k) {
        const Curve curve = random.periodic_curve();
        const double u = random.number(-20.0, 20.0);
        double total = 0.0;
        for (std::size_t i = 0; i < curve.control_points().size(); ++i) total += basis_function(curve.knots(), i, u);
        EXPECT_NEAR(total, 1.0, 1e-14);
    }
}

TEST(Basis, vanishes_outside_its_support_and_not_inside) {
    RandomCurves random(7);
    for (int k = 0; k < 300; ++k) {
        const Curve curve = random.open_curve();
        const double u = random.number(curve.domain().lower, curve.domain().upper);
        for (std::size_t i = 0; i < curve.control_points().size(); ++i) {
            const Interval support = basis_support(curve.knots(), i);
            const bool is_inside = support.lower < u && u < support.upper;
            EXPECT_EQ(basis_function(curve.knots(), i, u) > 0.0, is_inside);
        }
    }
}

TEST(Basis, is_zero_outside_an_open_domain) {
    const auto knots = KnotVector::make(2, {0, 1, 2, 3, 4, 5}).value();
    EXPECT_EQ(basis_function(knots, 0, 1.5), 0.0);
    EXPECT_EQ(basis_support(knots, 0), (Interval{2, 3}));
    EXPECT_EQ(basis_function(knots, 0, 2), 0.5);
    EXPECT_EQ(basis_function(knots, 2, 3), 0.5);
}

TEST(Basis, periodic_support_begins_in_the_domain_and_may_leave_it) {
    const auto knots = KnotVector::make_periodic(2, {0, 1, 2, 3, 4}).value();
    // Unrolled: -2 -1 | 0 1 2 3 4 | 5 6.
    EXPECT_EQ(basis_support(knots, 2), (Interval{0, 3}));
    EXPECT_EQ(basis_support(knots, 0), (Interval{2, 5}));
    EXPECT_EQ(basis_support(knots, 1), (Interval{3, 6}));
    EXPECT_EQ(basis_function(knots, 0, 0.5), basis_function(knots, 0, 4.5));
    EXPECT_EQ(basis_function(knots, 0, 0.5), 0.125);
}

TEST(Basis, periodic_support_is_where_the_function_is_positive) {
    RandomCurves random(8);
    for (int k = 0; k < 300; ++k) {
        const Curve curve = random.periodic_curve();
        const Interval domain = curve.domain();
        const double u = random.number(domain.lower, domain.upper);
        for (std::size_t i = 0; i < curve.control_points().size(); ++i) {
            const Interval support = basis_support(curve.knots(), i);
            EXPECT_TRUE(domain.contains(support.lower));
            bool is_inside = false;
            for (double repetition = u; repetition < support.upper; repetition += domain.length())
                is_inside = is_inside || repetition > support.lower;
            EXPECT_EQ(basis_function(curve.knots(), i, u) > 0.0, is_inside);
        }
    }
}

}  // namespace batten::core
