/// What operations cost, counted in the products of a number and a point that they form, never timed.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

#include "core/base/detail/banded_least_squares.h"
#include "core/base/detail/quadrature.h"
#include "core/curve/detail/spline.h"
#include "core/curve/knot_kinds.h"
#include "core/edit/detail/gap_list.h"
#include "core/evaluate/basis.h"
#include "core/evaluate/detail/decomposition.h"
#include "core/make/parametrization.h"
#include "core/refine/detail/removal_reach.h"
#include "core/refine/detail/spline_elevation.h"
#include "core/refine/detail/spline_removal.h"

namespace batten::core {

namespace {

// A point that tells a counter of each product it is a factor of. Every blend forms one.
struct CountedPoint {
    double value = 0.0;
    std::size_t* products = nullptr;
};

CountedPoint operator+(CountedPoint a, CountedPoint b) {
    return {a.value + b.value, a.products != nullptr ? a.products : b.products};
}

CountedPoint operator-(CountedPoint a, CountedPoint b) {
    return {a.value - b.value, a.products != nullptr ? a.products : b.products};
}

CountedPoint operator*(double factor, CountedPoint a) {
    if (a.products != nullptr) ++*a.products;
    return {factor * a.value, a.products};
}

using CountedSpline = Spline<CountedPoint>;

constexpr std::size_t few = 40;
constexpr std::size_t many = 4000;

// A clamped spline with `count` points over the domain [0, 1], all knots inside simple.
CountedSpline spline_of(std::size_t p, std::size_t count, std::size_t& products) {
    const KnotVector knots = make_knots(KnotKind::clamped_uniform, static_cast<int>(p), count).value();
    CountedSpline spline{.p = p, .knots = {knots.values().begin(), knots.values().end()}};
    for (std::size_t i = 0; i < count; ++i) spline.points.push_back({static_cast<double>(i * i % 7), &products});
    return spline;
}

// The products that `operation` forms on a spline of degree p with `count` points.
template <class Operation>
std::size_t cost(std::size_t p, std::size_t count, Operation operation) {
    std::size_t products = 0;
    CountedSpline spline = spline_of(p, count, products);
    operation(spline);
    return products;
}

constexpr double inside = 0.4937;  // no knot of any of these splines

}  // namespace

TEST(Complexity, a_curve_point_costs_half_of_p_squared) {
    for (const std::size_t p : {1U, 3U, 10U, 25U})
        for (const std::size_t count : {few, many}) {
            const KnotVector knots = make_knots(KnotKind::clamped_uniform, static_cast<int>(p), count).value();
            const std::size_t products = cost(p, count, [&](CountedSpline& spline) {
                const SpanKnots at(knots, knots.span_at(inside));
                LocalPoints<CountedPoint> points;
                for (std::size_t j = 0; j <= p; ++j) points[j] = spline.points[at.s - p + j];
                de_boor(points, at, inside);
            });
            EXPECT_EQ(products, p * (p + 1) / 2);
        }
}

TEST(Complexity, an_inserted_knot_costs_p_blends_however_long_the_curve_is) {
    for (const std::size_t p : {1U, 3U, 10U, 25U})
        for (const std::size_t count : {few, many})
            for (std::size_t times = 1; times <= p; ++times) {
                const std::size_t products = cost(p, count, [&](CountedSpline& spline) {
                    insert_ascending(spline, std::vector<double>(times, inside));
                    EXPECT_EQ(spline.multiplicity(inside), times);
                });
                // Each one is surrounded by one knot more that equals it, and so has one blend less to form.
                EXPECT_EQ(products, times * p - times * (times - 1) / 2);
            }
}

TEST(Complexity, splitting_costs_less_than_p_squared_on_either_side) {
    for (const std::size_t p : {1U, 3U, 10U, 25U})
        for (const std::size_t count : {few, many}) {
            const std::size_t products = cost(p, count, [&](const CountedSpline& spline) {
                part_between(spline, spline.domain().lower, inside);
                part_between(spline, inside, spline.domain().upper);
            });
            EXPECT_EQ(products, p * (p + 1));
        }
}

TEST(Complexity, a_removed_knot_costs_a_few_products_for_each_of_its_p_points) {
    for (const std::size_t p : {1U, 3U, 10U, 25U}) {
        std::vector<std::size_t> costs;
        for (const std::size_t count : {few, many})
            costs.push_back(cost(p, count, [&](CountedSpline& spline) {
                insert_ascending(spline, std::vector<double>{inside});
                *spline.points[0].products = 0;
                const std::size_t r = spline.first_of_run(inside);
                std::vector<Ratio> ratios;
                for (std::size_t i = r - p; i < r; ++i)
                    ratios.push_back(ratio_between(spline.knots[i], spline.knots[i + p + 1], inside));
                removal<CountedPoint>(ratios, std::vector(p, 1.0), std::span(spline.points).subspan(r - p - 1, p + 2));
            }));
        EXPECT_LE(costs[0], 4 * (p + 1));
        EXPECT_EQ(costs[0], costs[1]);
    }
}

TEST(Complexity, refinement_costs_p_blends_for_each_new_knot) {
    for (const std::size_t p : {1U, 3U, 10U, 25U})
        for (const std::size_t count : {few, many}) {
            std::size_t added = 0;
            const std::size_t products = cost(p, count, [&](CountedSpline& spline) {
                std::vector<double> middles;
                for (std::size_t s = p; s < count; ++s)
                    middles.push_back(0.5 * (spline.knots[s] + spline.knots[s + 1]));
                added = middles.size();
                insert_ascending(spline, middles);
            });
            EXPECT_LE(products, p * added);
            EXPECT_GE(products, added);
        }
}

TEST(Complexity, decomposition_costs_less_than_p_blends_for_each_point_of_the_pieces) {
    for (const std::size_t p : {1U, 3U, 10U, 25U})
        for (const std::size_t count : {few, many}) {
            std::size_t points = 0;
            const std::size_t products = cost(p, count, [&](CountedSpline& spline) {
                insert_ascending(spline, knots_missing_for_pieces(spline));
                points = spline.points.size();
            });
            EXPECT_LE(products, p * points);
            EXPECT_EQ(points, (count - p) * p + 1);
        }
}

TEST(Complexity, pieces_one_after_the_other_cost_half_of_p_squared_each) {
    for (const std::size_t p : {1U, 3U, 10U, 25U})
        for (const std::size_t count : {few, many}) {
            std::size_t pieces = 0;
            const std::size_t products = cost(p, count, [&](CountedSpline& spline) {
                const auto load = [&](std::size_t i) { return spline.points[i]; };
                Decomposition<CountedPoint, std::size_t, decltype(load)> decomposition(p, spline.knots, count - 1,
                                                                                       load);
                pieces = count - p;
                for (std::size_t k = pieces; k-- > 0;) decomposition.emit(k == 0, [](const auto&, std::size_t) {});
            });
            // The ends are clamped: there nothing is left to do for the first piece.
            EXPECT_EQ(products, (pieces - 1) * (p * (p - 1) / 2));
        }
}

TEST(Complexity, elevation_costs_p_squared_for_each_point_of_the_result) {
    for (const std::size_t p : {1U, 3U, 10U})
        for (const std::size_t count : {few, many}) {
            std::size_t points = 0;
            const std::size_t products =
                cost(p, count, [&](const CountedSpline& spline) { points = elevated_clamped(spline).points.size(); });
            EXPECT_LE(products, (p + 1) * (p + 1) * points);
        }
}

// The equations of the interpolation over averaged knots, solved for counted points.
TEST(Complexity, interpolation_costs_a_few_p_products_for_each_point) {
    for (const std::size_t p : {1U, 3U, 10U, 25U})
        for (const std::size_t count : {few, many}) {
            std::vector<double> sites;
            for (std::size_t k = 0; k < count; ++k)
                sites.push_back((static_cast<double>(k) + 0.3 * static_cast<double>(k % 3)) /
                                static_cast<double>(count));
            const KnotVector knots = KnotVector::make(static_cast<int>(p), averaged_knots(sites, p)).value();
            std::size_t products = 0;
            std::vector<BandedEquation<CountedPoint>> equations;
            for (std::size_t k = 0; k < count; ++k) {
                const BasisValues basis = basis_functions(knots, sites[k]);
                equations.push_back({basis.span - p, basis.derivatives[0], {static_cast<double>(k % 5), &products}});
            }
            ASSERT_TRUE(solve_least_squares(equations, count).has_value());
            // Up to p+1 rotations of 4 products for each equation, and p+1 products for each unknown on the way back.
            EXPECT_LE(products, 5 * (p + 1) * count);
        }
}

// The spans in which a knot is taken out, on both sides of it, are all that its removal copies and measures.
TEST(Complexity, a_removed_knot_reaches_as_many_points_however_long_the_curve_is) {
    for (const int p : {1, 3, 10, 25}) {
        std::vector<std::size_t> reached;
        for (const std::size_t count : {4 * few, 4 * many}) {
            const KnotVector knots = make_knots(KnotKind::clamped_uniform, p, count).value();
            const Curve curve = Curve::make(knots, std::vector<Point>(count, Point{}), {}).value();
            reached.push_back(curve_in_reach(curve, knots[count / 2]).value().curve.control_points().size());
        }
        EXPECT_LE(reached[0], 5 * static_cast<std::size_t>(p) + 5);
        EXPECT_EQ(reached[0], reached[1]);
    }
}

// Counts how often it goes from one place to another.
struct MovedItem {
    explicit MovedItem(std::size_t& count) : moves(&count) {}
    MovedItem(const MovedItem&) = default;
    MovedItem& operator=(const MovedItem&) = default;
    MovedItem(MovedItem&& other) noexcept : moves(other.moves) { ++*moves; }
    MovedItem& operator=(MovedItem&& other) noexcept {
        moves = other.moves;
        ++*moves;
        return *this;
    }
    ~MovedItem() = default;

    std::size_t* moves;
};

// The knots of deleted points, of which each is moved behind the gap, before it again, and while arrays grow.
TEST(Complexity, deleting_points_moves_each_knot_a_few_times_however_many_go) {
    for (const std::size_t count : {few, many}) {
        std::size_t moves = 0;
        GapList<MovedItem> knots(std::vector<MovedItem>(count, MovedItem(moves)));
        moves = 0;
        for (std::size_t i = count; i-- > 1;)
            if (i % 2 == 0) knots.take_out(i);
        EXPECT_EQ(knots.rest().size(), count / 2 + 1);
        EXPECT_LE(moves, 4 * count);
    }
}

// The lengths of pieces that one rule is right for, as a table of lengths has them.
TEST(Complexity, a_table_of_integrals_costs_one_rule_for_each_piece) {
    for (const std::size_t count : {few, many}) {
        std::vector<PieceRange> pieces;
        for (std::size_t i = 0; i < count; ++i) pieces.push_back({i, {0.0, 1.0}});
        std::size_t evaluations = 0;
        const auto parts = integrate_adaptively<double>(
            pieces,
            [&](std::size_t piece, double t) {
                ++evaluations;
                return std::sqrt(4.0 + t * static_cast<double>(piece % 3));
            },
            [](std::size_t, const RulePair<double>& rules) { return std::abs(rules.kronrod - rules.gauss); },
            [](double error, double sum) { return error <= 1e-12 * sum; });
        EXPECT_EQ(parts.size(), count);
        EXPECT_EQ(evaluations, 21 * count);
    }
}

}  // namespace batten::core
