/// The classes of bugs that spline programs keep having, by their number in the list of pitfalls.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numeric>

#include "core/curve/knot_analysis.h"
#include "core/evaluate/basis.h"
#include "core/evaluate/blossom.h"
#include "core/evaluate/de_boor.h"
#include "core/evaluate/evaluate.h"
#include "core/refine/knot_insertion.h"
#include "tests/core/random_curves.h"
#include "tests/core/reference.h"

namespace batten::core {

namespace {

double sum_of_basis(const KnotVector& knots, double u) {
    const auto values = basis_functions(knots, u).derivatives[0];
    return std::accumulate(values.begin(), values.end(), 0.0);
}

// The same closed curve with its points, weights and knots begun `first` places later.
Curve rotated(const Curve& curve, std::size_t first) {
    CurveDefinition definition = curve.definition();
    const auto [lower, upper] = curve.domain();
    const std::size_t n = definition.points.size();
    std::vector<double> knots;
    for (std::size_t k = 0; k <= n; ++k) {
        const std::size_t i = first + k;
        knots.push_back(i <= n ? definition.knots[i] : upper + (definition.knots[i - n] - lower));
    }
    definition.knots = knots;
    const auto steps = static_cast<std::ptrdiff_t>(first);
    std::rotate(definition.points.begin(), definition.points.begin() + steps, definition.points.end());
    std::rotate(definition.weights.begin(), definition.weights.begin() + steps, definition.weights.end());
    return Curve::make(definition).value();
}

Curve unclamped_cubic() {
    return Curve::make({.degree = 3,
                        .knots = {-1, 0, 0.5, 2, 3, 3.5, 5, 6, 8, 9},
                        .points = {{0, 0}, {1, 3}, {3, 4}, {5, 1}, {7, 2}, {8, 5}},
                        .weights = {1, 2, 0.5, 1, 3, 1}})
        .value();
}

Curve cusp() {
    // C(u) = (u^2, u^3) on [-1, 1]: at 0 the speed is zero.
    return Curve::make({.degree = 3,
                        .knots = {-1, -1, -1, -1, 1, 1, 1, 1},
                        .points = {{1, -1}, {-1.0 / 3, 1}, {-1.0 / 3, -1}, {1, 1}}})
        .value();
}

}  // namespace

TEST(Pitfalls, p01_end_parameter_is_bit_equal_to_end_point) {
    RandomCurves random(101);
    int clamped = 0;
    while (clamped < 200) {
        const Curve curve = random.open_curve();
        if (!is_clamped(curve.knots())) continue;
        ++clamped;
        const auto [lower, upper] = curve.domain();
        for (const Side side : {Side::left, Side::right}) {
            EXPECT_EQ(point_at(curve, lower, side), curve.control_points().front());
            EXPECT_EQ(point_at(curve, upper, side), curve.control_points().back());
            EXPECT_EQ(derivatives_at(curve, lower, 1, side).point, curve.control_points().front());
            EXPECT_EQ(derivatives_at(curve, upper, 1, side).point, curve.control_points().back());
            EXPECT_EQ(de_boor_triangle(curve, upper, side).point(), curve.control_points().back());
        }
    }
}

TEST(Pitfalls, p01_basis_sums_to_one_at_both_ends_also_unclamped) {
    RandomCurves random(102);
    for (int k = 0; k < 200; ++k) {
        const Curve curve = random.curve();
        EXPECT_NEAR(sum_of_basis(curve.knots(), curve.domain().lower), 1.0, 1e-15);
        EXPECT_NEAR(sum_of_basis(curve.knots(), curve.domain().upper), 1.0, 1e-15);
    }
}

TEST(Pitfalls, p01_end_of_an_unclamped_domain_is_the_limit_from_inside) {
    RandomCurves random(103);
    for (int k = 0; k < 200; ++k) {
        const Curve curve = random.open_curve();
        const double end = curve.domain().upper;
        const double before = end - 1e-9 * curve.domain().length();
        const auto derivatives = derivatives_at(curve, before, 1);
        EXPECT_LE(distance(point_at(curve, end), derivatives.point), 1e-6 + 1e-8 * length(derivatives[1]));
        EXPECT_LE(reference::relative_distance(curve, point_at(curve, end), reference::point_at(curve, end)), 1e-14);
    }
}

TEST(Pitfalls, p02_a_short_convention_vector_is_refused_with_the_count_expected) {
    // Six points of degree 3: the textbook has n + p + 1 = 10 knots, other programs write 8.
    const CurveDefinition definition{
        .degree = 3, .knots = {0, 0, 0, 1, 2, 3, 3, 3}, .points = {{0, 0}, {1, 1}, {2, 0}, {3, 1}, {4, 0}, {5, 1}}};
    const auto curve = Curve::make(definition);
    ASSERT_FALSE(curve);
    EXPECT_EQ(curve.error(), (CurveError{.code = CurveErrorCode::knot_count_mismatch, .value = 8, .lower = 10}));
    EXPECT_NE(describe(curve.error()).find("8 knots were found; 10 are needed"), std::string::npos);
}

TEST(Pitfalls, p02_the_degree_is_not_inferred_from_multiplicities) {
    // Ends of multiplicity 3 in a cubic: not a parabola, but a cubic whose domain begins one knot later.
    const Curve curve =
        Curve::make(
            {.degree = 3, .knots = {0, 0, 0, 1, 2, 3, 4, 4, 4}, .points = {{0, 0}, {1, 1}, {2, 0}, {3, 1}, {4, 0}}})
            .value();
    EXPECT_EQ(curve.degree(), 3);
    EXPECT_EQ(curve.domain(), (Interval{1, 3}));
}

TEST(Pitfalls, p04_rotating_the_point_list_gives_the_same_curve) {
    RandomCurves random(104);
    for (int k = 0; k < 200; ++k) {
        const Curve curve = random.periodic_curve();
        const int last = static_cast<int>(curve.control_points().size()) - 1;
        const Curve other = rotated(curve, static_cast<std::size_t>(random.whole(0, last)));
        for (int j = 0; j < 20; ++j) {
            const double u = random.number(curve.domain().lower, curve.domain().upper);
            EXPECT_LE(reference::relative_distance(curve, point_at(curve, u), point_at(other, u)), 1e-12);
        }
    }
}

TEST(Pitfalls, p04_the_seam_is_as_smooth_as_any_other_knot) {
    const std::vector<Point> points{{0, 0}, {4, 1}, {5, 5}, {1, 4}, {-2, 2}};
    for (int degree = 2; degree <= 6; ++degree) {
        const Curve curve = Curve::make({.degree = degree,
                                         .knots = {0, 1, 2.5, 3, 4.5, 5},
                                         .points = points,
                                         .weights = {1, 2, 0.5, 1, 3},
                                         .periodic = true})
                                .value();
        for (const double seam : {0.0, 5.0}) {
            const auto before = derivatives_at(curve, seam, degree, Side::left);
            const auto after = derivatives_at(curve, seam, degree, Side::right);
            EXPECT_LE(distance(before.point, after.point), 1e-11 * (1 + distance(after.point, {}))) << degree;
            for (std::size_t r = 1; r < static_cast<std::size_t>(degree); ++r)
                EXPECT_LE(length(before[r] - after[r]), 1e-11 * (1 + length(after[r]))) << degree << ' ' << r;
            // The p-th derivative jumps at a simple knot, so the two sides were really looked at.
            EXPECT_GT(length(before.derivatives.back() - after.derivatives.back()), 1e-3);
        }
        EXPECT_NEAR(curvature_at(curve, 5).value(), curvature_at(curve, 0).value(), 1e-12);
    }
}

TEST(Pitfalls, p04_a_double_seam_shows_both_its_sides) {
    const Curve curve =
        Curve::make(
            {.degree = 2, .knots = {0, 1, 2, 3, 3}, .points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}}, .periodic = true})
            .value();
    const auto before = derivatives_at(curve, 0, 1, Side::left);
    const auto after = derivatives_at(curve, 3, 1, Side::right);
    EXPECT_EQ(before.point, after.point);
    EXPECT_GT(length(before[1] / length(before[1]) - after[1] / length(after[1])), 0.5);
}

TEST(Pitfalls, p05_insertion_in_every_span_of_an_unclamped_domain_and_at_its_ends) {
    const Curve curve = unclamped_cubic();
    for (const double u : {2.0, 2.25, 3.0, 3.25, 3.5, 4.0, std::nextafter(5.0, 0.0), 5.0}) {
        const auto result = insert_knot(curve, u);
        ASSERT_TRUE(result) << describe(result.error());
        EXPECT_EQ(result->domain(), curve.domain());
        for (double at = 2.0; at <= 5.0; at += 1.0 / 64)
            EXPECT_LE(
                reference::relative_distance(curve, reference::point_at(*result, at), reference::point_at(curve, at)),
                1e-14);
    }
}

TEST(Pitfalls, p05_insertion_outside_the_domain_names_the_domain) {
    // Inside the knots, but outside the domain.
    for (const double u : {0.25, 1.0, std::nextafter(2.0, 0.0), std::nextafter(5.0, 6.0), 8.5}) {
        const auto result = insert_knot(unclamped_cubic(), u);
        ASSERT_FALSE(result);
        EXPECT_EQ(result.error().code, CurveErrorCode::parameter_outside_domain);
        EXPECT_NE(describe(result.error()).find("from 2 to 5"), std::string::npos);
    }
}

TEST(Pitfalls, p08_knots_1e9_apart_and_1e_minus_9_apart_behave_alike) {
    RandomCurves random(108);
    for (int k = 0; k < 100; ++k) {
        const Curve curve = random.open_curve();
        const double u = random.parameter(curve);
        const Point point = point_at(curve, u);
        const double slope = length(derivatives_at(curve, u, 1)[1]);
        // Powers of two, so that everything scales without rounding.
        for (const double scale : {std::ldexp(1.0, 30), std::ldexp(1.0, -30)}) {
            auto definition = curve.definition();
            for (double& knot : definition.knots) knot *= scale;
            const Curve scaled = Curve::make(definition).value();
            EXPECT_EQ(point_at(scaled, u * scale), point);
            EXPECT_EQ(length(derivatives_at(scaled, u * scale, 1)[1]) * scale, slope);
            EXPECT_EQ(segment_count(scaled.knots()), segment_count(curve.knots()));
            EXPECT_EQ(classify(scaled.knots()), classify(curve.knots()));
            if (curve.knots().multiplicity(u) < curve.degree()) {
                const Curve inserted = insert_knot(curve, u).value();
                EXPECT_TRUE(
                    std::ranges::equal(insert_knot(scaled, u * scale)->control_points(), inserted.control_points()));
            }
        }
    }
}

TEST(Pitfalls, p08_knots_1e_minus_9_apart_in_a_domain_of_1e9) {
    const Curve curve = Curve::make({.degree = 2,
                                     .knots = {0, 0, 0, 1e-9, 2e-9, 1e9, 1e9, 1e9},
                                     .points = {{0, 0}, {1, 2}, {2, -1}, {4, 3}, {5, 0}},
                                     .weights = {1, 2, 1, 0.5, 1}})
                            .value();
    EXPECT_EQ(segment_count(curve.knots()), 3u);
    for (const double u : {0.0, 1e-10, 1e-9, 1.5e-9, 2e-9, 1.0, 5e8, std::nextafter(1e9, 0.0), 1e9}) {
        EXPECT_LE(reference::relative_distance(curve, point_at(curve, u), reference::point_at(curve, u)), 1e-14);
        EXPECT_NEAR(sum_of_basis(curve.knots(), u), 1.0, 1e-15);
    }
    const Curve refined = insert_knot(curve, 1.5e-9).value();
    for (const double u : {1.2e-9, 1.7e-9, 3.0, 9e8})
        EXPECT_LE(reference::relative_distance(curve, reference::point_at(refined, u), reference::point_at(curve, u)),
                  1e-14);
}

TEST(Pitfalls, p08_just_below_and_just_above_every_knot) {
    RandomCurves random(109);
    for (int k = 0; k < 100; ++k) {
        const Curve curve = random.curve();
        for (const double knot : curve.knots().values())
            for (const double u : {std::nextafter(knot, -1e9), knot, std::nextafter(knot, 1e9)}) {
                if (!curve.domain().contains(u)) continue;
                EXPECT_LE(reference::relative_distance(curve, point_at(curve, u), reference::point_at(curve, u)),
                          1e-14);
            }
    }
}

TEST(Pitfalls, p09_insertion_at_full_multiplicity_is_refused_and_leaves_the_curve) {
    const Curve curve = insert_knot(unclamped_cubic(), 3.0, 2).value();
    const Curve copy = curve;
    const auto result = insert_knot(curve, 3.0);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error(), (CurveError{.code = CurveErrorCode::multiplicity_full, .value = 3, .upper = 3}));
    EXPECT_EQ(describe(result.error()),
              "knot 3 cannot be inserted that many times; at most 3 equal knots are allowed there");
    EXPECT_EQ(curve, copy);
}

TEST(Pitfalls, p09_multiplicity_counts_every_knot_once) {
    Curve curve = unclamped_cubic();
    for (int multiplicity = 1; multiplicity <= 3; ++multiplicity) {
        curve = insert_knot(curve, 4.0).value();
        EXPECT_EQ(curve.knots().multiplicity(4.0), multiplicity);
        const auto distinct = distinct_knots(curve.knots());
        const auto found =
            std::find_if(distinct.begin(), distinct.end(), [](const auto& knot) { return knot.value == 4; });
        ASSERT_NE(found, distinct.end());
        EXPECT_EQ(found->multiplicity, multiplicity);
        EXPECT_EQ(found->continuity, 3 - multiplicity);
    }
    EXPECT_FALSE(insert_knot(curve, 4.0));
}

TEST(Pitfalls, p10_a_cusp_has_no_curvature_and_nothing_is_not_a_number) {
    EXPECT_EQ(curvature_at(cusp(), 0), std::nullopt);
    EXPECT_EQ(curvature_at(cusp(), 0, Side::left), std::nullopt);
    // kappa = 6 / (u (4 + 9 u^2)^(3/2)) beside it: C' = (2u, 3u^2), C'' = (2, 6u).
    EXPECT_NEAR(curvature_at(cusp(), 0.5).value(), 6 / (0.5 * std::pow(4 + 9 * 0.25, 1.5)), 1e-13);
    const Jet jet = derivatives_at(cusp(), 0, 5);
    EXPECT_TRUE(is_finite(jet.point));
    for (const Vector& derivative : jet.derivatives) EXPECT_TRUE(is_finite(derivative));
}

TEST(Pitfalls, p10_a_cusp_that_rounding_hides_has_no_curvature_either) {
    RandomCurves random(110);
    int hidden = 0;
    for (int k = 0; k < 100; ++k) {
        const double scale = std::exp(random.number(-20, 20));
        const double turn = random.number(0, 6);
        auto definition = cusp().definition();
        for (Point& point : definition.points)
            point = tip_of(scale * Vector(std::cos(turn) * point.x - std::sin(turn) * point.y + 0.7,
                                          std::sin(turn) * point.x + std::cos(turn) * point.y - 0.1));
        definition.weights = {0.3, 0.3, 0.3, 0.3};
        const Curve curve = Curve::make(definition).value();
        hidden += derivatives_at(curve, 0, 1)[1] == Vector(0, 0) ? 0 : 1;
        EXPECT_EQ(curvature_at(curve, 0), std::nullopt);
        EXPECT_NE(curvature_at(curve, 1e-6), std::nullopt);
    }
    EXPECT_GT(hidden, 50);
}

TEST(Pitfalls, p10_a_curve_of_one_place_has_no_curvature) {
    const Curve curve =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{3, 4}, {3, 4}, {3, 4}}}).value();
    EXPECT_EQ(curvature_at(curve, 0.3), std::nullopt);
    EXPECT_EQ(derivatives_at(curve, 0.3, 1)[1], Vector(0, 0));
    EXPECT_EQ(point_at(curve, 0.3), Point(3, 4));
}

TEST(Pitfalls, p10_two_sided_values_at_multiple_knots) {
    // Two parabolas that meet in (2, 0) with slopes 1 and -1 of x.
    const Curve curve =
        Curve::make(
            {.degree = 2, .knots = {0, 0, 0, 1, 1, 2, 2, 2}, .points = {{0, 0}, {1, -1}, {2, 0}, {3, 3}, {4, 0}}})
            .value();
    EXPECT_EQ(derivatives_at(curve, 1, 2, Side::left), (Jet{{2, 0}, {{2, 2}, {0, 4}}}));
    EXPECT_EQ(derivatives_at(curve, 1, 2, Side::right), (Jet{{2, 0}, {{2, 6}, {0, -12}}}));
    EXPECT_NEAR(curvature_at(curve, 1, Side::left).value(), 8 / std::pow(8.0, 1.5), 1e-15);
    EXPECT_NEAR(curvature_at(curve, 1, Side::right).value(), -24 / std::pow(40.0, 1.5), 1e-15);
}

TEST(Pitfalls, p16_rational_derivatives_follow_the_quotient_rule) {
    // C = A / w by hand: A = (2u - 2u^2 + 3u^2, ...) is avoided by the half circle ((1 - u^2), 2u) / (1 + u^2).
    const Curve curve =
        Curve::make(
            {.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{1, 0}, {1, 1}, {0, 1}}, .weights = {1, 1, 2}})
            .value();
    for (int k = 0; k <= 16; ++k) {
        const double u = k / 16.0;
        const double d = 1 + u * u;
        const auto derivatives = derivatives_at(curve, u, 3);
        EXPECT_NEAR(derivatives[1].x, -4 * u / (d * d), 1e-14);
        EXPECT_NEAR(derivatives[1].y, 2 * (1 - u * u) / (d * d), 1e-14);
        EXPECT_NEAR(derivatives[2].x, 4 * (3 * u * u - 1) / (d * d * d), 1e-13);
        EXPECT_NEAR(derivatives[2].y, 4 * u * (u * u - 3) / (d * d * d), 1e-13);
        EXPECT_NEAR(derivatives[3].x, 48 * u * (1 - u * u) / (d * d * d * d), 1e-13);
        EXPECT_NEAR(derivatives[3].y, -12 * (u * u * u * u - 6 * u * u + 1) / (d * d * d * d), 1e-13);
    }
}

TEST(Pitfalls, p16_rational_derivative_is_the_limit_of_differences) {
    RandomCurves random(116);
    for (int k = 0; k < 200; ++k) {
        const Curve curve = random.curve();
        const auto [lower, upper] = curve.domain();
        const std::size_t s = curve.knots().span_at(random.number(lower, upper));
        const double u = 0.5 * (curve.knots()[s] + curve.knots()[s + 1]);
        const double h = 1e-5 * (curve.knots()[s + 1] - curve.knots()[s]);
        const auto derivatives = derivatives_at(curve, u, 3);
        const Vector slope = (reference::point_at(curve, u + h) - reference::point_at(curve, u - h)) / (2 * h);
        EXPECT_LE(length(slope - derivatives[1]), h * h * length(derivatives[3]) + 1e-13 / h);
    }
}

TEST(Pitfalls, p18_every_law_holds_a_million_units_away) {
    RandomCurves random(118);
    const Vector offset(1e6, -1e6);
    for (int k = 0; k < 200; ++k) {
        auto definition = random.curve().definition();
        for (Point& point : definition.points)
            point = {std::round(point.x * 4096.0) / 4096.0, std::round(point.y * 4096.0) / 4096.0};
        const Curve near = Curve::make(definition).value();
        for (Point& point : definition.points) point += offset;
        const Curve far = Curve::make(definition).value();
        const double u = random.parameter(near);
        EXPECT_LE(distance(point_at(far, u), point_at(near, u) + offset), 1e-8);
        EXPECT_LE(distance(de_boor_triangle(far, u).point(), point_at(near, u) + offset), 1e-8);
        const auto near_derivatives = derivatives_at(near, u, 2);
        const auto far_derivatives = derivatives_at(far, u, 2);
        for (std::size_t r = 1; r <= 2; ++r)
            EXPECT_LE(length(near_derivatives[r] - far_derivatives[r]), 1e-11 * (1 + length(near_derivatives[r])));
        const auto curvature = curvature_at(near, u);
        if (curvature && std::abs(*curvature) < 1e3) {
            EXPECT_NEAR(curvature_at(far, u).value(), *curvature, 1e-8 * (1 + std::abs(*curvature)));
        }
        if (near.knots().multiplicity(u) == near.degree() || near.knots().multiplicity(u) > near.degree()) continue;
        const Curve near_inserted = insert_knot(near, u).value();
        const Curve far_inserted = insert_knot(far, u).value();
        for (std::size_t i = 0; i < near_inserted.control_points().size(); ++i) {
            EXPECT_LE(distance(far_inserted.control_points()[i], near_inserted.control_points()[i] + offset), 1e-8);
            EXPECT_NEAR(far_inserted.weights()[i], near_inserted.weights()[i], 1e-14);
        }
    }
}

}  // namespace batten::core
