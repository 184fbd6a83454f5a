#include "core/evaluate/basis_evaluator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/curve/knot_kinds.h"
#include "tests/core/law_curves.h"
#include "tests/core/random_curves.h"

namespace batten::core {

namespace {

// Some roundings of 1.
constexpr double allowed = 2e-15;

void expect_equal(const BasisValues& found, const BasisValues& expected) {
    EXPECT_EQ(found.span, expected.span);
    ASSERT_EQ(found.derivatives.size(), 1u);
    ASSERT_EQ(found.derivatives[0].size(), expected.derivatives[0].size());
    for (std::size_t j = 0; j < expected.derivatives[0].size(); ++j)
        EXPECT_NEAR(found.derivatives[0][j], expected.derivatives[0][j], allowed);
}

}  // namespace

TEST(BasisEvaluator, has_the_values_of_every_sort_of_knots) {
    laws::check_everywhere("prepared basis functions have the same values", [](laws::Setting setting) {
        const KnotVector knots = laws::draw_curve(setting).knots();
        const BasisEvaluator prepared(knots);
        const auto [lower, upper] = knots.domain();
        for (int k = -3; k <= 53; ++k) {
            const double u = lower + (upper - lower) * k / 50;
            expect_equal(prepared.values_at(u), basis_functions(knots, u));
        }
        for (const double u : knots.values())
            for (const Side side : {Side::left, Side::right})
                expect_equal(prepared.values_at(u, side), basis_functions(knots, u, 0, side));
    });
}

TEST(BasisEvaluator, has_the_values_at_every_degree) {
    RandomCurves random(41);
    for (int degree = min_degree; degree <= max_degree; ++degree)
        for (const KnotKind kind : {KnotKind::uniform, KnotKind::clamped_uniform, KnotKind::periodic}) {
            const KnotVector knots = make_knots(kind, degree, 60).value();
            const BasisEvaluator prepared(knots);
            for (int k = 0; k < 50; ++k) {
                const double u = random.number(knots.domain().lower, knots.domain().upper);
                expect_equal(prepared.values_at(u), basis_functions(knots, u));
            }
        }
}

TEST(BasisEvaluator, takes_the_shortest_domain_and_the_longest) {
    const double least = std::numeric_limits<double>::denorm_min();
    for (const double length : {least, 3 * least, 1e-300, 1e-80, 1.0, 1e80, 1.7e308}) {
        const KnotVector knots = KnotVector::make(3, {0, 0, 0, 0, length, length, length, length}).value();
        const BasisEvaluator prepared(knots);
        for (const double u : {0.0, 0.25 * length, 0.5 * length, 0.7 * length, length, std::nan("")})
            expect_equal(prepared.values_at(u), basis_functions(knots, u));
    }
}

}  // namespace batten::core
