#include "core/evaluate/basis_triangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/evaluate/basis.h"
#include "tests/core/golden.h"
#include "tests/core/random_curves.h"
#include "tests/core/reference.h"

namespace batten::core {

namespace {

const KnotVector lecture = KnotVector::make(3, {0, 1, 2, 3, 4, 5, 6, 7}).value();

void expect_cell(const BasisCell& cell, std::size_t index, double value, BasisRamp rising, BasisRamp falling) {
    EXPECT_EQ(cell.index, index);
    EXPECT_DOUBLE_EQ(cell.value, value);
    EXPECT_DOUBLE_EQ(cell.rising.value, rising.value);
    EXPECT_DOUBLE_EQ(cell.falling.value, falling.value);
    EXPECT_EQ(cell.rising.is_void, rising.is_void);
    EXPECT_EQ(cell.falling.is_void, falling.is_void);
}

std::vector<double> values_of(const std::vector<BasisCell>& level) {
    std::vector<double> values;
    for (const BasisCell& cell : level) values.push_back(cell.value);
    return values;
}

}  // namespace

TEST(BasisTriangle, of_the_uniform_cubic_has_the_numbers_of_the_recurrence) {
    const BasisTriangle triangle = basis_triangle(lecture, 0, 1.5);
    ASSERT_EQ(triangle.levels.size(), 4u);
    EXPECT_EQ(triangle.u, 1.5);
    EXPECT_EQ(values_of(triangle.levels[0]), (std::vector<double>{0, 1, 0, 0}));
    EXPECT_EQ(values_of(triangle.levels[1]), (std::vector<double>{0.5, 0.5, 0}));
    expect_cell(triangle.levels[1][0], 0, 0.5, {1.5}, {0.5});
    expect_cell(triangle.levels[1][1], 1, 0.5, {0.5}, {1.5});
    expect_cell(triangle.levels[1][2], 2, 0.0, {-0.5}, {2.5});
    expect_cell(triangle.levels[2][0], 0, 0.75, {0.75}, {0.75});
    expect_cell(triangle.levels[2][1], 1, 0.125, {0.25}, {1.25});
    expect_cell(triangle.levels[3][0], 0, 23.0 / 48, {0.5}, {2.5 / 3});
    EXPECT_EQ(triangle.value(), triangle.levels[3][0].value);
}

TEST(BasisTriangle, has_the_functions_of_lower_degree) {
    for (const double u : {0.25, 1.5, 3.0, 3.75, 6.5})
        for (std::size_t i = 0; i < 4; ++i) {
            const BasisTriangle triangle = basis_triangle(lecture, i, u);
            for (std::size_t k = 0; k < triangle.levels.size(); ++k)
                for (const BasisCell& cell : triangle.levels[k])
                    EXPECT_EQ(lower_basis_function(lecture, cell.index, static_cast<int>(k), u), cell.value);
        }
    EXPECT_EQ(lower_basis_function(lecture, 6, 0, 6.5), 1.0);
    EXPECT_EQ(lower_basis_function(lecture, 5, 1, 6.25), 0.75);
    EXPECT_EQ(lower_basis_function(lecture, 5, 1, 6.0, Side::left), 1.0);
}

TEST(BasisTriangle, counts_0_over_0_as_0_where_knots_coincide) {
    const auto knots = KnotVector::make(2, {0, 0, 0, 1, 1, 1}).value();
    const BasisTriangle triangle = basis_triangle(knots, 0, 0.25);
    EXPECT_EQ(values_of(triangle.levels[0]), (std::vector<double>{0, 0, 1}));
    expect_cell(triangle.levels[1][0], 0, 0.0, {0.0, true}, {0.0, true});
    expect_cell(triangle.levels[1][1], 1, 0.75, {0.0, true}, {0.75});
    expect_cell(triangle.levels[2][0], 0, 9.0 / 16, {0.0, true}, {0.75});
    expect_cell(basis_triangle(knots, 2, 0.25).levels[2][0], 2, 1.0 / 16, {0.25}, {0.0, true});
}

TEST(BasisTriangle, goes_on_beyond_the_domain) {
    // Each function is the first one, shifted; the domain is [3, 4].
    for (const auto& [t, expected] : {std::pair(0.5, 1.0 / 48), std::pair(1.0, 1.0 / 6), std::pair(2.0, 4.0 / 6),
                                      std::pair(2.5, 23.0 / 48), std::pair(3.5, 1.0 / 48)})
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_DOUBLE_EQ(basis_triangle(lecture, i, static_cast<double>(i) + t).value(), expected);
    for (std::size_t i = 0; i < 4; ++i)
        for (const double u : {-1e300, -0.5, 0.0, 7.0, 7.5, 1e300}) EXPECT_EQ(basis_triangle(lecture, i, u).value(), 0);
}

TEST(BasisTriangle, takes_the_side_at_a_tear) {
    const auto torn = KnotVector::make(1, {0, 0, 1, 1, 2, 2}, KnotKind::custom, Tears::allow).value();
    EXPECT_EQ(basis_triangle(torn, 1, 1.0, Side::left).value(), 1.0);
    EXPECT_EQ(basis_triangle(torn, 1, 1.0, Side::right).value(), 0.0);
    EXPECT_EQ(basis_triangle(torn, 2, 1.0, Side::left).value(), 0.0);
    EXPECT_EQ(basis_triangle(torn, 2, 1.0, Side::right).value(), 1.0);
    EXPECT_EQ(basis_triangle(torn, 0, 0.0, Side::left).value(), 1.0);
    EXPECT_EQ(basis_triangle(torn, 3, 2.0, Side::right).value(), 1.0);
}

TEST(BasisTriangle, agrees_with_the_reference_results) {
    for (const auto& item : golden::cases("basis.json")) {
        const int degree = item.at("degree");
        const auto p = static_cast<std::size_t>(degree);
        const auto knots = KnotVector::make(degree, item.at("knots")).value();
        for (const auto& place : item.at("at")) {
            const auto span = place.at("span").get<std::size_t>();
            const auto expected = place.at("derivatives").at(0).get<std::vector<double>>();
            for (std::size_t j = 0; j <= p; ++j)
                EXPECT_NEAR(basis_triangle(knots, span - p + j, place.at("u")).value(), expected[j], 1e-14)
                    << item.at("name");
        }
    }
}

TEST(BasisTriangle, agrees_with_the_definition_everywhere) {
    RandomCurves random(51);
    for (int round = 0; round < 200; ++round) {
        const KnotVector knots = random.curve().knots();
        const auto p = static_cast<std::size_t>(knots.degree());
        const double first = knots.values().front();
        const double last = knots.values().back();
        const double u = random.number(first, last);
        const Side side = random.whole(0, 1) == 0 ? Side::left : Side::right;
        const std::size_t span = span_of_all(knots, u, side).value();
        EXPECT_LE(knots[span], u);
        EXPECT_LE(u, knots[span + 1]);
        for (std::size_t i = 0; i + p + 1 < knots.size(); ++i) {
            const auto expected =
                static_cast<double>(reference::basis_function(knots.values(), p, i, span, static_cast<long double>(u)));
            EXPECT_NEAR(basis_triangle(knots, i, u, side).value(), expected, 1e-14);
        }
    }
}

TEST(BasisTriangle, of_degree_25_far_away_sums_to_one_in_the_domain_only) {
    std::vector<double> values;
    for (int k = 0; k < 60; ++k) values.push_back(1e6 + k);
    const auto knots = KnotVector::make(25, values).value();
    const auto sum_at = [&](double u) {
        double sum = 0.0;
        for (std::size_t i = 0; i < knots.control_point_count(); ++i) sum += basis_triangle(knots, i, u).value();
        return sum;
    };
    EXPECT_NEAR(sum_at(1e6 + 30.25), 1.0, 1e-13);
    EXPECT_LT(sum_at(1e6 + 10.0), 0.5);
    EXPECT_GT(sum_at(1e6 + 10.0), 0.0);
}

TEST(BasisTriangle, has_no_span_beyond_the_knots) {
    EXPECT_EQ(span_of_all(lecture, -0.5), std::nullopt);
    EXPECT_EQ(span_of_all(lecture, 7.5), std::nullopt);
    EXPECT_EQ(span_of_all(lecture, std::numeric_limits<double>::quiet_NaN()), std::nullopt);
    EXPECT_EQ(span_of_all(lecture, 0.0), 0u);
    EXPECT_EQ(span_of_all(lecture, 0.0, Side::left), 0u);
    EXPECT_EQ(span_of_all(lecture, 7.0), 6u);
    EXPECT_EQ(span_of_all(lecture, 2.0, Side::left), 1u);
    EXPECT_EQ(span_of_all(lecture, 2.0), 2u);
    // The end of the domain belongs to the span inside.
    EXPECT_EQ(span_of_all(lecture, 4.0), 3u);
}

}  // namespace batten::core
