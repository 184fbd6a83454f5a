#include "core/evaluate/evaluator.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/curve/knot_kinds.h"
#include "core/evaluate/samples.h"
#include "core/make/conics.h"
#include "tests/core/law_curves.h"
#include "tests/core/random_curves.h"

namespace batten::core {

namespace {

// Some roundings of the largest coordinate.
double allowed_in(const Curve& curve) {
    return 10 * laws::unit_of(curve);
}

double largest_part(Vector v) {
    return std::max(std::abs(v.x), std::abs(v.y));
}

// Parameters from below the domain to above it, with all knots.
std::vector<double> parameters_over(const Curve& curve, int count) {
    const auto [lower, upper] = curve.domain();
    std::vector<double> parameters;
    for (int k = -2; k <= count + 2; ++k) parameters.push_back(lower + (upper - lower) * k / count);
    for (const double knot : curve.knots().values()) parameters.push_back(knot);
    std::sort(parameters.begin(), parameters.end());
    return parameters;
}

// The largest difference of samples from point_at.
double largest_error_of_samples(const Curve& curve, int count) {
    const std::vector<double> parameters = parameters_over(curve, count);
    std::vector<Point> points(parameters.size());
    sample(curve, parameters, points);
    double largest = 0.0;
    for (std::size_t i = 0; i < parameters.size(); ++i)
        largest = std::max(largest, largest_part(points[i] - point_at(curve, parameters[i])));
    return largest;
}

// The largest difference from point_at, one by one from both sides and many at once.
double largest_error(const Curve& curve) {
    const Evaluator evaluator(curve);
    double largest = std::max(largest_error_of_samples(curve, 97), largest_error_of_samples(curve, 997));
    for (const double u : parameters_over(curve, 97))
        for (const Side side : {Side::left, Side::right})
            largest = std::max(largest, largest_part(evaluator.point_at(u, side) - point_at(curve, u, side)));
    return largest;
}

// Knots of every multiplicity in turn, at uneven distances.
Curve of_every_multiplicity(int degree, bool is_rational, RandomCurves& random) {
    const auto p = static_cast<std::size_t>(degree);
    std::vector<double> knots(p + 1, -1.0);
    for (std::size_t multiplicity = 1; multiplicity <= p; multiplicity += 1 + p / 5)
        knots.insert(knots.end(), multiplicity, knots.back() + random.number(0.01, 3));
    knots.insert(knots.end(), p + 1, knots.back() + 1.0);
    CurveDefinition definition{.degree = degree, .knots = knots};
    for (std::size_t i = 0; i + p + 1 < knots.size(); ++i) {
        definition.points.emplace_back(random.number(-8, 8), random.number(-8, 8));
        if (is_rational) definition.weights.push_back(random.number(0.2, 5));
    }
    return Curve::make(definition).value();
}

Curve of_kind(KnotKind kind, int degree, std::size_t n, RandomCurves& random) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < n; ++i) points.emplace_back(random.number(-8, 8), random.number(-8, 8));
    return Curve::make(make_knots(kind, degree, n).value(), points, {}).value();
}

Curve scaled(const Curve& curve, double factor, Vector offset = {}) {
    CurveDefinition definition = curve.definition();
    for (Point& point : definition.points) point = tip_of(factor * vector_to(point)) + offset;
    return Curve::make(definition).value();
}

}  // namespace

TEST(Evaluator, gives_the_points_of_every_sort_of_curve) {
    laws::check_everywhere("a prepared curve has the same points", [](laws::Setting setting) {
        const Curve curve = laws::draw_curve(setting);
        RC_ASSERT(largest_error(curve) <= allowed_in(curve));
    });
}

TEST(Evaluator, gives_the_points_at_every_degree_and_multiplicity) {
    RandomCurves random(31);
    for (int degree = min_degree; degree <= max_degree; ++degree) {
        SCOPED_TRACE(degree);
        for (const bool is_rational : {false, true}) {
            const Curve curve = of_every_multiplicity(degree, is_rational, random);
            EXPECT_LE(largest_error(curve), allowed_in(curve)) << is_rational;
        }
        for (const KnotKind kind : {KnotKind::uniform, KnotKind::clamped_uniform, KnotKind::periodic}) {
            const Curve curve = of_kind(kind, degree, 40, random);
            EXPECT_LE(largest_error(curve), allowed_in(curve)) << name_of(kind);
        }
    }
}

TEST(Evaluator, gives_the_points_of_weights_of_any_size) {
    RandomCurves random(32);
    for (int k = 0; k < 300; ++k) {
        CurveDefinition definition = random.curve().definition();
        for (double& weight : definition.weights) weight = std::pow(10.0, random.number(-6, 6));
        const Curve curve = Curve::make(definition).value();
        EXPECT_LE(largest_error(curve), allowed_in(curve));
        for (double& weight : definition.weights) weight *= 1e-290;
        const Curve light = Curve::make(definition).value();
        EXPECT_LE(largest_error(light), allowed_in(light));
    }
}

TEST(Evaluator, gives_the_points_at_any_size_and_place) {
    RandomCurves random(33);
    for (int k = 0; k < 50; ++k) {
        const Curve curve = random.curve();
        for (const Curve& other : {scaled(curve, 1e-300), scaled(curve, 1e-12), scaled(curve, 1e300),
                                   scaled(curve, 1e306), scaled(curve, 1, {1e6, -3e8}), scaled(curve, 1e-9, {1, 1})})
            EXPECT_LE(largest_error(other), allowed_in(other)) << largest_part(vector_to(other.control_points()[0]));
    }
}

TEST(Evaluator, gives_derivatives_of_any_order) {
    RandomCurves random(36);
    constexpr int most = 9;
    for (int k = 0; k < 200; ++k) {
        const Curve curve = random.curve();
        const Evaluator evaluator(curve);
        std::array<double, most + 1> scales{};
        std::array<double, most + 1> errors{};
        for (int i = 0; i < 40; ++i) {
            const double u = random.parameter(curve);
            const int order = i % (most + 1);
            const Side side = i % 3 == 0 ? Side::left : Side::right;
            const Jet expected = derivatives_at(curve, u, order, side);
            const Jet found = evaluator.derivatives_at(u, order, side);
            EXPECT_LE(largest_part(found.point - expected.point), allowed_in(curve));
            ASSERT_EQ(found.derivatives.size(), expected.derivatives.size());
            for (std::size_t r = 1; r <= found.derivatives.size(); ++r) {
                scales[r] = std::max(scales[r], largest_part(expected[r]));
                errors[r] = std::max(errors[r], largest_part(found[r] - expected[r]));
            }
        }
        for (std::size_t r = 1; r <= most; ++r) EXPECT_LE(errors[r], 1e-11 * scales[r]) << r;
    }
}

TEST(Evaluator, gives_derivatives_of_the_side_that_is_asked_for) {
    const Evaluator polyline(
        Curve::make({.degree = 1, .knots = {0, 0, 1, 3, 3}, .points = {{0, 0}, {1, 0}, {1, 4}}}).value());
    EXPECT_EQ(polyline.derivatives_at(1, 2, Side::left), (Jet{{1, 0}, {{1, 0}, {0, 0}}}));
    EXPECT_EQ(polyline.derivatives_at(1, 2, Side::right), (Jet{{1, 0}, {{0, 2}, {0, 0}}}));
    EXPECT_EQ(polyline.derivatives_at(-5, 1), (Jet{{0, 0}, {{1, 0}}}));
    EXPECT_EQ(polyline.derivatives_at(5, 1), (Jet{{1, 4}, {{0, 2}}}));
    EXPECT_EQ(polyline.derivatives_at(2, 0), (Jet{{1, 2}, {}}));
}

TEST(Evaluator, gives_the_points_of_both_sides_of_a_tear) {
    const Evaluator torn(Curve::make({.degree = 2,
                                      .knots = {0, 0, 0, 1, 1, 1, 2, 2, 2},
                                      .points = {{0, 0}, {1, 1}, {2, 0}, {5, 0}, {6, -1}, {7, 0}},
                                      .tears = Tears::allow})
                             .value());
    EXPECT_EQ(torn.point_at(1, Side::left), Point(2, 0));
    EXPECT_EQ(torn.point_at(1, Side::right), Point(5, 0));
    EXPECT_EQ(torn.point_at(1), Point(5, 0));
}

TEST(Evaluator, has_the_bits_of_point_at_at_both_ends_and_beyond) {
    RandomCurves random(34);
    const double infinity = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 200; ++k) {
        const Curve curve = random.curve();
        const Evaluator evaluator(curve);
        const auto [lower, upper] = curve.domain();
        for (const double u : {lower, upper, infinity, -infinity, std::nan("")})
            for (const Side side : {Side::left, Side::right})
                EXPECT_EQ(evaluator.point_at(u, side), point_at(curve, u, side)) << u;
        if (curve.is_periodic()) continue;
        EXPECT_EQ(evaluator.point_at(lower - 1), point_at(curve, lower));
        EXPECT_EQ(evaluator.point_at(upper + 1), point_at(curve, upper));
        std::vector<Point> points(3);
        sample(curve, std::vector{upper, lower, lower}, points);
        EXPECT_EQ(points, (std::vector{point_at(curve, upper), point_at(curve, lower), point_at(curve, lower)}));
    }
}

TEST(Evaluator, finds_spans_of_very_different_lengths) {
    CurveDefinition definition{.degree = 1, .knots = {0, 0}, .points = {{0, 0}}};
    for (int k = -1000; k <= 1000; k += 5) {
        definition.knots.push_back(std::ldexp(1.0, k));
        definition.points.emplace_back(k, k % 7);
    }
    definition.knots.push_back(definition.knots.back());
    const Curve curve = Curve::make(definition).value();
    const Evaluator evaluator(curve);
    for (int k = -1000; k < 1000; k += 5)
        for (const double u : {std::ldexp(1.0, k), std::ldexp(3.0, k)})
            EXPECT_LE(distance(evaluator.point_at(u), point_at(curve, u)), allowed_in(curve)) << k;
}

TEST(Evaluator, takes_the_shortest_domain_and_the_longest) {
    const double least = std::numeric_limits<double>::denorm_min();
    for (const double length : {least, 3 * least, 1e-308, 1e-300, 1.0, 1e300, 1.7e308}) {
        const Curve curve = Curve::make({.degree = 3,
                                         .knots = {0, 0, 0, 0, length, length, length, length},
                                         .points = {{0, 0}, {1, 2}, {3, 2}, {4, 0}}})
                                .value();
        const Evaluator evaluator(curve);
        for (const double u : {0.0, 0.25 * length, 0.5 * length, 0.7 * length, length})
            EXPECT_LE(distance(evaluator.point_at(u), point_at(curve, u)), allowed_in(curve)) << length;
    }
}

TEST(Sample, gives_the_points_in_any_order_and_number) {
    RandomCurves random(35);
    for (const KnotKind kind : {KnotKind::clamped_uniform, KnotKind::periodic}) {
        const Curve curve = of_kind(kind, 3, 50, random);
        std::vector<double> parameters = parameters_over(curve, 1000);
        const auto expect_points = [&](std::span<const double> wanted) {
            // Behind the last one nothing is written.
            std::vector<Point> points(wanted.size() + 8, Point(77, 77));
            sample(curve, wanted, std::span(points).first(wanted.size()));
            for (std::size_t i = 0; i < wanted.size(); ++i)
                EXPECT_LE(largest_part(points[i] - point_at(curve, wanted[i])), allowed_in(curve)) << wanted[i];
            for (std::size_t i = wanted.size(); i < points.size(); ++i) EXPECT_EQ(points[i], Point(77, 77));
        };
        for (std::size_t count = 0; count < 70; ++count) expect_points(std::span(parameters).subspan(100, count));
        std::reverse(parameters.begin(), parameters.end());
        expect_points(parameters);
        for (std::size_t i = 0; i < parameters.size(); ++i)
            std::swap(parameters[i], parameters[i * 7919 % parameters.size()]);
        expect_points(parameters);
        // Some in one span, some elsewhere, again and again.
        for (std::size_t i = 0; i < parameters.size(); ++i)
            parameters[i] =
                curve.domain().lower + curve.domain().length() * (i % 9 < 6 ? 0.3 : 0.1 * static_cast<double>(i % 10));
        expect_points(parameters);
    }
}

TEST(TaylorExpander, makes_the_pieces_of_eight_spans_however_long_the_curve_is) {
    for (const std::size_t n : {40U, 4000U}) {
        std::vector<Point> points;
        for (std::size_t i = 0; i < n; ++i) points.emplace_back(i, i % 2);
        const Curve curve = Curve::make(make_knots(KnotKind::uniform, 3, n).value(), points, {}).value();
        TaylorExpander expander(curve);
        expander.begin_at(20);
        expander.add_spans();
        const auto knots = curve.knots().values().subspan(20, block_size + 1);
        EXPECT_EQ(expander.pieces().joints, std::vector(knots.begin(), knots.end()));
    }
}

TEST(Sample, takes_what_is_no_number) {
    RandomCurves random(37);
    const Curve curve = of_kind(KnotKind::clamped_uniform, 3, 20, random);
    std::vector<double> parameters(40, 0.4);
    for (std::size_t i = 3; i < parameters.size(); i += 6) parameters[i] = std::nan("");
    std::vector<Point> points(parameters.size());
    sample(curve, parameters, points);
    for (std::size_t i = 0; i < parameters.size(); ++i)
        EXPECT_LE(largest_part(points[i] - point_at(curve, parameters[i])), allowed_in(curve)) << i;
}

TEST(Evaluator, keeps_a_circle_round) {
    const Evaluator evaluator(circle({3, 4}, 5).value());
    const auto [lower, upper] = evaluator.curve().domain();
    for (int k = 0; k <= 1000; ++k) {
        const Point point = evaluator.point_at(lower + (upper - lower) * k / 1000);
        EXPECT_NEAR(std::hypot(point.x - 3, point.y - 4), 5, 2e-15);
    }
}

}  // namespace batten::core
