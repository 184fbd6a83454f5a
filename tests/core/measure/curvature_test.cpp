#include "core/measure/curvature.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/evaluate/evaluate.h"
#include "core/measure/cusps.h"
#include "core/refine/degree.h"
#include "core/refine/knot_insertion.h"
#include "tests/core/known_curves.h"
#include "tests/core/random_curves.h"

namespace batten::core {
namespace {

// y = x^3 for x from -1 to 2, u from 0 to 1, so x = 3u - 1.
Curve cubic_graph() {
    return Curve::make({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{-1, -1}, {0, 2}, {1, -4}, {2, 8}}})
        .value();
}

// y = x^2 for x from -2 to 4.
Curve parabola() {
    return Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{-2, 4}, {1, -8}, {4, 16}}}).value();
}

TEST(Bending, of_a_parabola_in_closed_form) {
    for (const double u : {0.0, 0.2, 1.0 / 3.0, 0.8, 1.0}) {
        const double x = 6 * u - 2;
        const double root = std::sqrt(1 + 4 * x * x);
        const Bending bending = bending_at(parabola(), u).value();
        EXPECT_NEAR(bending.curvature, 2 / std::pow(root, 3), 1e-14);
        // d/dx of 2 (1 + 4x^2)^(-3/2) is -24 x (1 + 4x^2)^(-5/2); dx/du = 6, ds/dx = root.
        EXPECT_NEAR(bending.by_parameter, -6 * 24 * x / std::pow(root, 5), 1e-12);
        EXPECT_NEAR(bending.by_arc_length, -24 * x / std::pow(root, 6), 1e-13);
    }
}

TEST(Bending, is_the_difference_quotient_of_the_curvature) {
    RandomCurves random(301);
    for (int i = 0; i < 200; ++i) {
        const Curve curve = random.curve();
        const double h = 1e-6;
        const double u = random.number(curve.domain().lower + h, curve.domain().upper - h);
        const auto at = bending_at(curve, u);
        const auto before = curvature_at(curve, u - h);
        const auto after = curvature_at(curve, u + h);
        if (!at || !before || !after || curve.knots().span_at(u - h) != curve.knots().span_at(u + h)) continue;
        const double scale = 1.0 + std::abs(*before) + std::abs(at->by_parameter);
        if (scale > 1e3) continue;
        EXPECT_NEAR(at->by_parameter, (*after - *before) / (2 * h), 1e-3 * scale) << i;
    }
}

TEST(Bending, has_no_value_at_a_cusp) {
    const Curve cusp =
        Curve::make({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{0, 0}, {1, 1}, {0, 1}, {1, 0}}})
            .value();
    EXPECT_FALSE(bending_at(cusp, 0.5).has_value());
}

TEST(Inflections, of_a_cubic_graph) {
    for (const Curve& curve : {cubic_graph(), moved(cubic_graph(), {1e6, -1e6}),
                               elevate_degree(cubic_graph(), 3).value(), insert_knot(cubic_graph(), 0.3).value()}) {
        const auto found = inflections(curve);
        ASSERT_EQ(found.size(), 1U);
        EXPECT_NEAR(found[0].u, 1.0 / 3.0, 1e-9);
        EXPECT_EQ(found[0].where.length(), 0.0);
        EXPECT_FALSE(found[0].is_jump);
    }
    EXPECT_NEAR(inflections(cubic_graph())[0].u, 1.0 / 3.0, 1e-15);
    EXPECT_TRUE(inflections(parabola()).empty());
    EXPECT_TRUE(inflections(ellipse(3, 1)).empty());
}

TEST(Inflections, at_a_knot_is_counted_once) {
    const auto found = inflections(insert_knot(cubic_graph(), 1.0 / 3.0).value());
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].u, 1.0 / 3.0, 1e-12);
}

TEST(Inflections, flat_point_is_none) {
    // y = x^4 bends to the left on both sides of its flat point.
    const Curve quartic = Curve::make({.degree = 4,
                                       .knots = {-1, -1, -1, -1, -1, 1, 1, 1, 1, 1},
                                       .points = {{-1, 1}, {-0.5, -1}, {0, 1}, {0.5, -1}, {1, 1}}})
                              .value();
    EXPECT_TRUE(inflections(quartic).empty());
}

TEST(Inflections, where_the_curvature_jumps_between_two_parabolas) {
    // Uniform quadratic splines are C1; every leg that turns the other way makes a jump at its middle.
    const Curve wave =
        Curve::make(
            {.degree = 2, .knots = {0, 0, 0, 1, 2, 3, 3, 3}, .points = {{0, 0}, {1, 2}, {3, -2}, {5, 2}, {6, 0}}})
            .value();
    const auto found = inflections(wave);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].u, 1.0);
    EXPECT_EQ(found[1].u, 2.0);
    EXPECT_TRUE(found[0].is_jump);
}

TEST(Inflections, corners_are_none_and_straight_pieces_count_once) {
    EXPECT_TRUE(inflections(polygon({{0, 0}, {1, 1}, {2, 0}, {3, 1}})).empty());
    // A quarter bend to the left, a straight piece, a quarter bend to the right, all tangent.
    const Curve hook = Curve::make({.degree = 2,
                                    .knots = {0, 0, 0, 1, 1, 2, 2, 3, 3, 3},
                                    .points = {{0, 0}, {1, 0}, {1, 1}, {1, 2}, {1, 4}, {1, 5}, {2, 5}}})
                           .value();
    for (const Curve& curve : {hook, moved(hook, {1e6 + 0.1, 3e6 + 0.7})}) {
        const auto found = inflections(curve);
        ASSERT_EQ(found.size(), 1U);
        EXPECT_EQ(found[0].where, (Interval{1, 2}));
        EXPECT_EQ(found[0].u, 1.5);
    }
    // Both bends to the left: none.
    const Curve bay = Curve::make({.degree = 2,
                                   .knots = {0, 0, 0, 1, 1, 2, 2, 3, 3, 3},
                                   .points = {{0, 0}, {1, 0}, {1, 1}, {1, 2}, {1, 4}, {1, 5}, {0, 5}}})
                          .value();
    EXPECT_TRUE(inflections(bay).empty());
}

TEST(Inflections, of_a_straight_line_are_none) {
    RandomCurves random(303);
    for (int i = 0; i < 20; ++i) {
        const Curve curve = random.curve();
        CurveDefinition line = curve.definition();
        for (Point& point : line.points) point = Point(0.1, 0.7) + point.x * Vector(0.3, -0.9);
        EXPECT_TRUE(inflections(Curve::make(line).value()).empty()) << i;
        EXPECT_TRUE(curvature_extrema(Curve::make(line).value()).empty()) << i;
    }
}

TEST(Inflections, are_all_changes_of_sign_that_sampling_finds) {
    RandomCurves random(304);
    for (int i = 0; i < 60; ++i) {
        const Curve curve = random.curve();
        if (curve.control_points().size() < 3) continue;  // a straight way there and back
        const auto found = inflections(curve);
        const auto knots = curve.knots().values();
        constexpr int samples = 400;
        for (std::size_t s = 0; s + 1 < knots.size(); ++s) {
            if (knots[s] == knots[s + 1] || knots[s] < curve.domain().lower || knots[s + 1] > curve.domain().upper)
                continue;
            const double step = (knots[s + 1] - knots[s]) / samples;
            for (int k = 1; k + 1 < samples; ++k) {
                const double u = knots[s] + step * k;
                const double before = curvature_at(curve, u).value_or(0);
                const double after = curvature_at(curve, u + step).value_or(0);
                const auto inside = std::count_if(found.begin(), found.end(), [&](const Inflection& inflection) {
                    return u < inflection.u && inflection.u <= u + step;
                });
                if (std::min(std::abs(before), std::abs(after)) < 1e-9) continue;
                EXPECT_EQ(inside % 2 == 1, before * after < 0) << i << " at " << u << ", degree " << curve.degree();
            }
        }
    }
}

TEST(Inflections, do_not_depend_on_the_domain) {
    for (const double factor : {1e-9, 1e9}) {
        const auto found = inflections(over(cubic_graph(), 5 * factor, factor));
        ASSERT_EQ(found.size(), 1U);
        EXPECT_NEAR(found[0].u / factor, 5 + 1.0 / 3.0, 1e-14);
    }
}

TEST(CurvatureExtrema, of_parabola_and_ellipse_are_their_vertices) {
    const auto vertex = curvature_extrema(parabola());
    ASSERT_EQ(vertex.size(), 1U);
    EXPECT_NEAR(vertex[0].u, 1.0 / 3.0, 1e-14);
    EXPECT_NEAR(vertex[0].curvature, 2.0, 1e-12);
    EXPECT_TRUE(vertex[0].is_maximum);
    // Curvature a / b^2 at the ends of the long axis and b / a^2 at those of the short one.
    for (const Curve& curve : {ellipse(3, 2), moved(ellipse(3, 2), {1e6, 1e6})}) {
        const auto four = curvature_extrema(curve);
        ASSERT_EQ(four.size(), 4U);
        for (std::size_t k = 0; k < 4; ++k) {
            EXPECT_NEAR(four[k].u, 0.25 * static_cast<double>(k), 1e-9);
            EXPECT_EQ(four[k].is_maximum, k % 2 == 0);
            EXPECT_NEAR(four[k].curvature, k % 2 == 0 ? 0.75 : 2.0 / 9.0, 1e-8);
        }
    }
}

TEST(CurvatureExtrema, circle_has_none) {
    EXPECT_TRUE(curvature_extrema(ellipse(2, 2)).empty());
    EXPECT_TRUE(curvature_extrema(elevate_degree(ellipse(2, 2), 2).value()).empty());
    EXPECT_TRUE(curvature_extrema(moved(ellipse(2, 2), {1e6, 0})).empty());
}

TEST(CurvatureExtrema, of_a_cubic_graph) {
    // y = x^3: curvature 6x (1 + 9x^4)^(-3/2) is extreme where 45 x^4 = 1.
    const auto found = curvature_extrema(cubic_graph());
    const double x = std::pow(1.0 / 45.0, 0.25);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found[0].point.x, -x, 1e-13);
    EXPECT_FALSE(found[0].is_maximum);
    EXPECT_NEAR(found[1].point.x, x, 1e-13);
    EXPECT_TRUE(found[1].is_maximum);
    EXPECT_NEAR(found[1].curvature, 6 * x * std::pow(1.2, -1.5), 1e-13);
}

TEST(CurvatureExtrema, derivative_changes_its_sign_there_and_nowhere_else) {
    RandomCurves random(305);
    for (int i = 0; i < 60; ++i) {
        const Curve curve = random.curve();
        if (curve.degree() == 1 || curve.control_points().size() < 3) continue;
        const auto found = curvature_extrema(curve);
        for (const CurvatureExtremum& extremum : found) {
            const auto bending = bending_at(curve, extremum.u);
            ASSERT_TRUE(bending.has_value());
        }
        const auto knots = curve.knots().values();
        constexpr int samples = 200;
        for (std::size_t s = 0; s + 1 < knots.size(); ++s) {
            if (knots[s] == knots[s + 1] || knots[s] < curve.domain().lower || knots[s + 1] > curve.domain().upper)
                continue;
            const double step = (knots[s + 1] - knots[s]) / samples;
            for (int k = 1; k + 1 < samples; ++k) {
                const double u = knots[s] + step * k;
                const auto before = bending_at(curve, u);
                const auto after = bending_at(curve, u + step);
                if (!before || !after) continue;
                const auto inside = std::count_if(found.begin(), found.end(), [&](const CurvatureExtremum& extremum) {
                    return u < extremum.u && extremum.u <= u + step;
                });
                if (std::min(std::abs(before->by_parameter), std::abs(after->by_parameter)) <
                    1e-7 * (std::abs(before->curvature) + std::abs(after->curvature)))
                    continue;
                EXPECT_EQ(inside % 2 == 1, before->by_parameter * after->by_parameter < 0)
                    << i << " at " << u << ", degree " << curve.degree();
            }
        }
    }
}

TEST(Cusps, semicubical_parabola) {
    const Curve cusp =
        Curve::make({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{0, 0}, {1, 1}, {0, 1}, {1, 0}}})
            .value();
    for (const Curve& curve : {cusp, moved(cusp, {1e6, -1e6}), over(cusp, 0, 1e-9), over(cusp, 1e9, 1e9),
                               insert_knot(cusp, 0.4).value(), elevate_degree(cusp, 2).value()}) {
        const auto found = cusps(curve);
        ASSERT_EQ(found.size(), 1U);
        EXPECT_NEAR((found[0].u - curve.domain().lower) / curve.domain().length(), 0.5, 1e-6);
        EXPECT_NEAR(std::abs(found[0].turn.value()), 3.14159265358979, 1e-3);
        EXPECT_TRUE(inflections(curve).empty());
        EXPECT_TRUE(curvature_extrema(curve).empty());
    }
    EXPECT_EQ(cusps(cusp)[0].u, 0.5);
    EXPECT_EQ(cusps(cusp)[0].point, Point(0.5, 0.75));
}

TEST(Cusps, at_an_uneven_parameter_and_of_a_rational_curve) {
    // (t^2, t^3) for t from -1 to 2: u = 1/3.
    const Curve cusp =
        Curve::make({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{1, -1}, {-1, 2}, {0, -4}, {4, 8}}})
            .value();
    ASSERT_EQ(cusps(cusp).size(), 1U);
    EXPECT_NEAR(cusps(cusp)[0].u, 1.0 / 3.0, 1e-14);
    // A projective map keeps cusps: w = 2 + x is 3, 1, 2, 6.
    CurveDefinition definition = cusp.definition();
    definition.weights = {3, 1, 2, 6};
    for (std::size_t i = 0; i < 4; ++i)
        definition.points[i] = tip_of(vector_to(definition.points[i]) / definition.weights[i]);
    const auto found = cusps(Curve::make(definition).value());
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].u, 1.0 / 3.0, 1e-13);
}

TEST(Cusps, places_without_speed_that_are_no_proper_cusps) {
    // Doubled end points.
    const Curve slow =
        Curve::make({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{0, 0}, {0, 0}, {1, 1}, {2, 0}}})
            .value();
    const auto at_end = cusps(slow);
    ASSERT_EQ(at_end.size(), 1U);
    EXPECT_EQ(at_end[0].u, 0.0);
    EXPECT_FALSE(at_end[0].turn.has_value());
    // (t^3, t^3) hesitates on its straight way.
    const Curve hesitating =
        Curve::make(
            {.degree = 3, .knots = {-1, -1, -1, -1, 1, 1, 1, 1}, .points = {{-1, -1}, {1, 1}, {-1, -1}, {1, 1}}})
            .value();
    ASSERT_EQ(cusps(hesitating).size(), 1U);
    EXPECT_NEAR(cusps(hesitating)[0].turn.value(), 0.0, 1e-12);
    // A whole piece that is a point is one place.
    const auto still = cusps(polygon({{0, 0}, {1, 0}, {1, 0}, {1, 1}}));
    ASSERT_EQ(still.size(), 1U);
    EXPECT_EQ(still[0].where, (Interval{1, 2}));
    EXPECT_NEAR(still[0].turn.value(), 1.5707963267948966, 1e-15);
}

TEST(Cusps, ordinary_curves_have_none) {
    RandomCurves random(306);
    for (int i = 0; i < 100; ++i) {
        const Curve curve = random.curve();
        // Two points in a circle are a straight way there and back, with stops.
        if (curve.control_points().size() == 2) continue;
        EXPECT_TRUE(cusps(curve).empty()) << i;
    }
    EXPECT_TRUE(cusps(ellipse(3, 1)).empty());
}

TEST(OsculatingCircle, of_the_parabola_and_of_a_circle) {
    // At (x, x^2) the evolute is (-4 x^3, 3 x^2 + 1/2); x = 6u - 2.
    for (const double u : {0.0, 0.1, 1.0 / 3.0, 0.8, 1.0}) {
        const double x = 6.0 * u - 2.0;
        const OsculatingCircle circle = osculating_circle(parabola(), u).value();
        const double size = 1.0 + std::abs(4.0 * x * x * x);
        EXPECT_NEAR(circle.center.x, -4.0 * x * x * x, 1e-13 * size) << u;
        EXPECT_NEAR(circle.center.y, 3.0 * x * x + 0.5, 1e-13 * size) << u;
        EXPECT_NEAR(circle.radius, 0.5 * std::pow(1.0 + 4.0 * x * x, 1.5), 1e-13 * size * size) << u;
    }
    const Vector offset(1e6, -3e6);
    for (const double u : {0.0, 0.25, 0.4, 1.0}) {
        const OsculatingCircle circle = osculating_circle(moved(ellipse(2, 2), offset), u).value();
        EXPECT_NEAR(circle.center.x, offset.x, 1e-8);
        EXPECT_NEAR(circle.center.y, offset.y, 1e-8);
        EXPECT_NEAR(circle.radius, 2.0, 1e-8);
    }
    // Turning right, the center is on the right.
    const Curve right =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{-1, -1}, {0, 1}, {1, -1}}}).value();
    EXPECT_NEAR(osculating_circle(right, 0.5)->center.y, -0.5, 1e-15);
}

TEST(OsculatingCircle, is_missing_where_nothing_bends_or_moves_and_one_sided_at_a_knot) {
    EXPECT_FALSE(osculating_circle(cubic_graph(), 1.0 / 3.0).has_value() &&
                 osculating_circle(cubic_graph(), 1.0 / 3.0)->radius < 1e12);
    const Curve line = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {1, 1}}}).value();
    EXPECT_FALSE(osculating_circle(line, 0.5));
    const Curve still = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{1, 1}, {1, 1}}}).value();
    EXPECT_FALSE(osculating_circle(still, 0.5));
    // y = x (1 - x), then y = (x - 1) (x - 2), with one tangent: radius sqrt(2) on either side.
    const Curve wave = Curve::make({.degree = 2,
                                    .knots = {0, 0, 0, 1, 1, 2, 2, 2},
                                    .points = {{0, 0}, {0.5, 0.5}, {1, 0}, {1.5, -0.5}, {2, 0}}})
                           .value();
    EXPECT_NEAR(osculating_circle(wave, 1.0, Side::left)->center.x, 0.0, 1e-14);
    EXPECT_NEAR(osculating_circle(wave, 1.0, Side::right)->center.x, 2.0, 1e-14);
    EXPECT_NEAR(osculating_circle(wave, 1.0)->radius, std::sqrt(2.0), 1e-14);
}

TEST(BendingWithin, finds_what_the_whole_curve_has_there) {
    RandomCurves random(417);
    for (int i = 0; i < 60; ++i) {
        const Curve curve = random.curve();
        if (curve.degree() == 1 || curve.control_points().size() < 3) continue;
        const auto knots = curve.knots().values();
        const auto first = curve.knots().span_at(random.parameter(curve));
        const Interval range{knots[first], knots[first + 1]};
        const auto check = [&](const auto& all, const auto& within) {
            std::vector<double> expected;
            for (const auto& place : all)
                if (range.lower + 1e-6 < place.u && place.u < range.upper - 1e-6) expected.push_back(place.u);
            std::vector<double> found;
            for (const auto& place : within)
                if (range.lower + 1e-6 < place.u && place.u < range.upper - 1e-6) found.push_back(place.u);
            ASSERT_EQ(found.size(), expected.size()) << i;
            for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], expected[k], 1e-9) << i;
        };
        check(inflections(curve), inflections_within(curve, range));
        check(curvature_extrema(curve), curvature_extrema_within(curve, range));
    }
}

// A wave of 10,000 points has an inflection in every span; within one span there is one.
TEST(BendingWithin, looks_at_few_spans_only) {
    CurveDefinition definition{.degree = 3};
    for (int i = 0; i < 10'000; ++i) definition.points.emplace_back(i, i % 2);
    for (int i = 0; i < 10'004; ++i) definition.knots.push_back(i);
    const Curve wave = Curve::make(std::move(definition)).value();
    const auto found = inflections_within(wave, {500, 501});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].u, 500.5, 1e-12);
    const auto extrema = curvature_extrema_within(wave, {500, 501});
    ASSERT_EQ(extrema.size(), 2U);
    EXPECT_EQ(extrema[0].u, 500.0);
    EXPECT_NE(extrema[0].is_maximum, extrema[1].is_maximum);
}

}  // namespace
}  // namespace batten::core
