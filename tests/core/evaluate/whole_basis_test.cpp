#include "core/evaluate/whole_basis.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/evaluate/basis.h"
#include "core/evaluate/basis_triangle.h"
#include "tests/core/random_curves.h"

namespace batten::core {

TEST(WholeBasis, raises_the_ends_to_full_multiplicity) {
    const WholeBasis uniform = whole_basis(KnotVector::make(2, {0, 1, 2, 3, 4, 5}).value());
    EXPECT_EQ(uniform.first, 2u);
    EXPECT_TRUE(std::ranges::equal(uniform.knots.values(), std::vector<double>{0, 0, 0, 1, 2, 3, 4, 5, 5, 5}));
    EXPECT_EQ(uniform.knots.domain(), (Interval{0, 5}));
    const WholeBasis half = whole_basis(KnotVector::make(2, {0, 0, 2, 3, 4, 4, 4}).value());
    EXPECT_EQ(half.first, 1u);
    EXPECT_TRUE(std::ranges::equal(half.knots.values(), std::vector<double>{0, 0, 0, 2, 3, 4, 4, 4}));
    const auto clamped = KnotVector::make(2, {0, 0, 0, 1, 2, 2, 2}).value();
    EXPECT_EQ(whole_basis(clamped).first, 0u);
    EXPECT_TRUE(std::ranges::equal(whole_basis(clamped).knots.values(), clamped.values()));
}

TEST(WholeBasis, has_values_and_derivatives_beyond_the_domain) {
    const WholeBasis whole = whole_basis(KnotVector::make(3, {0, 1, 2, 3, 4, 5, 6, 7}).value());
    // N_{0,3} = u^3 / 6 on [0, 1], and N_{3,3} = (7 - u)^3 / 6 on [6, 7].
    const BasisValues left = basis_functions(whole.knots, 0.5, 2);
    const std::size_t j = whole.first + 3 - left.span;
    EXPECT_DOUBLE_EQ(left.derivatives[0][j], 1.0 / 48);
    EXPECT_DOUBLE_EQ(left.derivatives[1][j], 1.0 / 8);
    EXPECT_DOUBLE_EQ(left.derivatives[2][j], 1.0 / 2);
    EXPECT_DOUBLE_EQ(basis_function(whole.knots, whole.first + 3, 6.5), 1.0 / 48);
}

TEST(WholeBasis, has_the_functions_of_the_vector) {
    RandomCurves random(52);
    for (int round = 0; round < 200; ++round) {
        const KnotVector knots = random.curve().knots();
        const WholeBasis whole = whole_basis(knots);
        const double u = random.number(knots.values().front(), knots.values().back());
        for (std::size_t i = 0; i + static_cast<std::size_t>(knots.degree()) + 1 < knots.size(); ++i)
            EXPECT_NEAR(basis_function(whole.knots, whole.first + i, u), basis_triangle(knots, i, u).value(), 1e-14);
    }
}

}  // namespace batten::core
