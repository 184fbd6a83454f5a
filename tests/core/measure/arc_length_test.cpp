#include "core/measure/arc_length.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/curve/knot_kinds.h"
#include "core/evaluate/evaluate.h"
#include "core/refine/degree.h"
#include "tests/core/golden.h"
#include "tests/core/known_curves.h"
#include "tests/core/random_curves.h"

namespace batten::core {
namespace {

using std::numbers::pi;

// y = x^2 for x from 0 to 2, of length sqrt(17) + asinh(4) / 4.
Curve parabola() {
    return Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {1, 0}, {2, 4}}}).value();
}

double parabola_length(double x) {
    return 0.5 * x * std::sqrt(1 + 4 * x * x) + 0.25 * std::asinh(2 * x);
}

// (t^2, t^3) for t from -1 to 1.
Curve cusp() {
    return Curve::make({.degree = 3,
                        .knots = {0, 0, 0, 0, 1, 1, 1, 1},
                        .points = {{1, -1}, {-1.0 / 3, 1}, {-1.0 / 3, -1}, {1, 1}}})
        .value();
}

Curve loop() {
    return Curve::make({.degree = 3,
                        .knots = {0, 1, 2, 4, 5},
                        .points = {{1, 1}, {-1, 2}, {-1, -1}, {1, -1}},
                        .periodic = true})
        .value();
}

// Up and down 3 and across 4, each leg of length 5, over more spans than are measured at a time; leg k from k to k + 1.
Curve zigzag(std::size_t legs, bool is_periodic) {
    CurveDefinition definition{.degree = 1, .periodic = is_periodic};
    for (std::size_t k = 0; k <= legs; ++k) {
        definition.knots.push_back(static_cast<double>(k));
        if (k < legs || !is_periodic)
            definition.points.push_back({4.0 * static_cast<double>(k), k % 2 == 0 ? 0.0 : 3.0});
    }
    if (is_periodic) return Curve::make(std::move(definition)).value();
    definition.knots.insert(definition.knots.begin(), 0.0);
    definition.knots.push_back(static_cast<double>(legs));
    return Curve::make(std::move(definition)).value();
}

TEST(ArcLength, long_curves_are_measured_over_all_their_spans) {
    const Curve open = zigzag(20'000, false);
    EXPECT_DOUBLE_EQ(arc_length(open).value, 100'000.0);
    EXPECT_LT(arc_length(open).error, 1e-6);
    EXPECT_DOUBLE_EQ(arc_length(open, 4095.5, 4097.25).value, 8.75);
    EXPECT_DOUBLE_EQ(arc_length(open, 8000.0, 4000.0).value, -20'000.0);
    EXPECT_DOUBLE_EQ(arc_length(open, -1.0, 8193.0).value, 40'965.0);
    const Curve closed = zigzag(10'000, true);
    const double back = std::hypot(4.0 * 9'999, 3.0);
    EXPECT_NEAR(arc_length(closed).value, 5.0 * 9'999 + back, 1e-7);
    // The legs of a periodic curve begin where its second point is.
    EXPECT_NEAR(arc_length(closed, 9'999.0, 10'001.0).value + arc_length(closed, 1.0, 9'999.0).value,
                5.0 * 9'999 + back, 1e-7);
}

TEST(Golden, arc_length) {
    golden::Tally tally("arc_length.json");
    for (const auto& members : golden::cases("arc_length.json")) {
        tally.count_case();
        const Curve curve = golden::curve_of(members);
        const double length = members.at("length").get<double>();
        const Integral found = arc_length(curve);
        const auto name = members.at("name").get<std::string>();
        tally.add("length", std::abs(found.value - length) / length, 1e-12, name);
        tally.add("length of the table", std::abs(ArcLengthTable(curve).total().value - length) / length, 1e-12, name);
        EXPECT_LE(std::abs(found.value - length), found.error) << name;
        EXPECT_LE(found.error, 1e-12 * length) << name;
    }
}

TEST(ArcLength, closed_forms) {
    EXPECT_NEAR(arc_length(ellipse(1, 1)).value, 2 * pi, 1e-14);
    EXPECT_NEAR(arc_length(parabola()).value, parabola_length(2), 1e-14);
    // (t^2, t^3): integral of |t| sqrt(4 + 9 t^2).
    EXPECT_NEAR(arc_length(cusp()).value, 2 * (std::pow(13.0, 1.5) - 8) / 27, 1e-13);
    // Complete elliptic integral of the second kind, ellipse with half axes 2 and 1.
    EXPECT_NEAR(arc_length(ellipse(2, 1)).value, 9.688448220547675, 1e-13);
    const Curve line =
        Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{1, 1}, {4, 5}}, .weights = {1, 1e6}}).value();
    EXPECT_NEAR(arc_length(line).value, 5.0, 1e-12);
}

// The parabola and, far from evenly run through, a line; as pieces of degree 25.
TEST(ArcLength, closed_forms_at_the_highest_degree) {
    const Curve high = elevate_degree(parabola(), max_degree - 2).value();
    EXPECT_NEAR(arc_length(high).value, std::sqrt(17.0) + std::asinh(4.0) / 4.0, 1e-14);
    const double half = std::sqrt(5.0) / 2.0 + std::asinh(2.0) / 4.0;
    EXPECT_NEAR(arc_length(high, 0.0, 0.5).value, half, 1e-14);
    EXPECT_NEAR(ArcLengthTable(high).parameter_at(half), 0.5, 1e-14);
    std::vector<Point> points;
    for (int i = 0; i <= max_degree; ++i) points.emplace_back(3.0 * std::pow(0.5, i), 4.0 * std::pow(0.5, i));
    const Curve line =
        Curve::make(make_knots(KnotKind::bezier, max_degree, points.size(), {0.0, 1.0}).value(), points, {}).value();
    EXPECT_NEAR(arc_length(line).value, 5.0 * (1.0 - std::pow(0.5, max_degree)), 1e-14);
    const CurveDefinition definition = high.definition();
    for (const double size : {1e-300, 1e300}) {
        CurveDefinition sized = definition;
        for (Point& point : sized.points) point = tip_of(size * vector_to(point));
        EXPECT_NEAR(arc_length(Curve::make(sized).value()).value / size, std::sqrt(17.0) + std::asinh(4.0) / 4.0, 1e-13)
            << size;
    }
}

TEST(ArcLength, cusp_away_from_the_middle) {
    // t from -1 to 2.
    const Curve curve =
        Curve::make({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{1, -1}, {-1, 2}, {0, -4}, {4, 8}}})
            .value();
    const double length = (std::pow(13.0, 1.5) + std::pow(40.0, 1.5) - 16) / 27;
    EXPECT_NEAR(arc_length(curve).value, length, 1e-12 * length);
    EXPECT_GE(arc_length(curve).error, std::abs(arc_length(curve).value - length));
}

// As one weight grows the curve tends to straight legs to and from its point: from P0 to P1 to P3, and from P0 to P2 to
// P3; all of the way is made at parameters nearer to the ends than doubles can tell from 1.
TEST(ArcLength, one_huge_weight_makes_legs_and_is_measured_at_once) {
    const std::vector<Point> points{{0, 0}, {1, 2}, {3, 3}, {4, 0}};
    const double to_first = std::sqrt(5.0) + std::sqrt(13.0);
    const double to_second = std::sqrt(18.0) + std::sqrt(10.0);
    for (const double huge : {1e19, 1e30, 1e100, 1e300})
        for (const auto& [index, length] : {std::pair(0, 4.0), {1, to_first}, {2, to_second}, {3, 4.0}}) {
            CurveDefinition definition{
                .degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = points, .weights = {1, 1, 1, 1}};
            definition.weights[static_cast<std::size_t>(index)] = huge;
            const Curve curve = Curve::make(definition).value();
            const Integral found = arc_length(curve);
            EXPECT_NEAR(found.value, length, huge > 1e20 ? 1e-12 : 1e-8) << huge << " at " << index;
            const ArcLengthTable table(curve);
            EXPECT_EQ(table.total().value, found.value);
            const double u = table.parameter_at(0.5 * length);
            EXPECT_TRUE(0.0 <= u && u <= 1.0);
        }
}

// Weights (1, w c, c^2) of an arc give the same arc at other parameters.
TEST(ArcLength, does_not_depend_on_how_far_apart_the_weights_are) {
    const double w = std::sqrt(0.5);
    for (const double c : {30.0, 1e-4, 1e8, 1e40, 1e-120}) {
        const Curve arc = Curve::make({.degree = 2,
                                       .knots = {0, 0, 0, 1, 1, 1},
                                       .points = {{1, 0}, {1, 1}, {0, 1}},
                                       .weights = {1, w * c, c * c}})
                              .value();
        const Integral found = arc_length(arc);
        EXPECT_NEAR(found.value, pi / 2, 1e-13) << c;
        EXPECT_LE(std::abs(found.value - pi / 2), found.error) << c;
        EXPECT_TRUE(is_sharp(found));
    }
}

// It goes to (1, 0) and comes back. A part that ends just beside the turn has it where the rules do not look.
TEST(ArcLength, turning_back_beside_an_end_is_seen) {
    const Curve fold =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {2, 0}, {0, 0}}}).value();
    for (const double beside : {1e-3, 1e-4, 1e-5, 1e-6}) {
        // x = 4 u (1 - u).
        const double back = 4 * beside * beside;
        EXPECT_NEAR(arc_length(fold, 0.5 - beside, 1.0).value, 1 + back, 1e-14) << beside;
        EXPECT_NEAR(arc_length(fold, 0.0, 0.5 + beside).value, 1 + back, 1e-14) << beside;
        EXPECT_NEAR(arc_length(fold, 0.1, 0.5 + beside).value, 0.64 + back, 1e-14) << beside;
    }
}

TEST(ArcLength, numbers_of_every_size_are_measured_or_none_is_given) {
    RandomCurves random(343);
    for (int i = 0; i < 40; ++i) {
        CurveDefinition definition = random.curve().definition();
        definition.weights.resize(definition.points.size());
        double polygon = 0.0;
        for (double& weight : definition.weights) weight = std::pow(10.0, random.number(-150, 150));
        for (std::size_t k = 0; k < definition.points.size(); ++k) {
            const std::size_t next = (k + 1) % definition.points.size();
            if (definition.periodic || next > 0) polygon += distance(definition.points[k], definition.points[next]);
        }
        const Integral found = arc_length(Curve::make(definition).value());
        EXPECT_GE(found.value, 0.0) << i;
        EXPECT_LE(found.value, polygon * (1 + 1e-9)) << i;
        EXPECT_LE(found.error, 1e-6 * polygon) << i;
    }
}

TEST(ArcLength, of_intervals_adds_up_and_has_a_sign) {
    const Curve curve = parabola();
    EXPECT_NEAR(arc_length(curve, 0.25, 0.75).value, parabola_length(1.5) - parabola_length(0.5), 1e-14);
    EXPECT_NEAR(arc_length(curve, 0.75, 0.25).value, parabola_length(0.5) - parabola_length(1.5), 1e-14);
    EXPECT_EQ(arc_length(curve, 0.3, 0.3).value, 0.0);
    EXPECT_EQ(arc_length(curve, -5, 5).value, arc_length(curve).value);
    const double small = parabola_length(1 + 1e-6) - parabola_length(1);
    EXPECT_NEAR(arc_length(curve, 0.5, 0.5 + 0.5e-6).value, small, 1e-9 * small);
}

TEST(ArcLength, goes_round_a_periodic_curve) {
    const double whole = arc_length(loop()).value;
    EXPECT_NEAR(arc_length(loop(), 4, 6).value, arc_length(loop(), 4, 5).value + arc_length(loop(), 0, 1).value, 1e-13);
    EXPECT_NEAR(arc_length(loop(), 1, 16).value, 3 * whole, 1e-12);
    EXPECT_NEAR(arc_length(loop(), 2, -3).value, -whole, 1e-13);
}

TEST(ArcLength, does_not_depend_on_place_and_domain) {
    const double expected = arc_length(ellipse(2, 1)).value;
    EXPECT_NEAR(arc_length(moved(ellipse(2, 1), {1e6, -3e6})).value, expected, 1e-9);
    EXPECT_NEAR(arc_length(over(ellipse(2, 1), 0, 1e-9)).value, expected, 1e-14);
    EXPECT_NEAR(arc_length(over(ellipse(2, 1), 7, 1e9)).value, expected, 1e-14);
    EXPECT_NEAR(arc_length(over(ellipse(2, 1), 1e9, 1e-3)).value, expected, 1e-13);
}

TEST(ArcLength, is_no_longer_than_the_polygon_and_no_shorter_than_chords) {
    RandomCurves random(321);
    for (int i = 0; i < 200; ++i) {
        const Curve curve = random.curve();
        const Integral length = arc_length(curve);
        double chords = 0.0;
        Point last = point_at(curve, curve.domain().lower);
        for (int k = 1; k <= 2000; ++k) {
            const Point next = point_at(curve, curve.domain().lower + curve.domain().length() * k / 2000.0,
                                        k == 2000 ? Side::left : Side::right);
            chords += distance(last, next);
            last = next;
        }
        EXPECT_GE(length.value, chords - 1e-12);
        EXPECT_LE(length.value, chords * (1 + 1e-2) + 1e-12);
        EXPECT_LE(length.error, 1e-12 * length.value);
    }
}

TEST(ArcLengthTable, parameter_at_is_the_inverse_of_length_at) {
    RandomCurves random(322);
    for (int i = 0; i < 60; ++i) {
        const Curve curve = random.curve();
        const ArcLengthTable table(curve);
        const double total = table.total().value;
        EXPECT_EQ(table.parameter_at(0.0), curve.domain().lower);
        for (int k = 1; k < 12; ++k) {
            const double s = total * k / 12.0;
            const double u = table.parameter_at(s);
            EXPECT_NEAR(table.length_at(u), s, 1e-12 * total) << i;
            EXPECT_NEAR(arc_length(curve, curve.domain().lower, u).value, s, 1e-12 * total) << i;
        }
    }
}

TEST(ArcLengthTable, closed_forms_and_ends) {
    const ArcLengthTable circle(ellipse(1, 1));
    for (int k = 0; k <= 16; ++k) {
        const Point point = point_at(ellipse(1, 1), circle.parameter_at(2 * pi * k / 16));
        EXPECT_NEAR(point.x, std::cos(2 * pi * k / 16), 1e-14);
        EXPECT_NEAR(point.y, std::sin(2 * pi * k / 16), 1e-14);
    }
    EXPECT_EQ(circle.parameter_at(-1), 0.0);
    EXPECT_EQ(circle.parameter_at(100), 1.0);
    EXPECT_EQ(circle.length_at(7), circle.length_at(1));
    const ArcLengthTable round(loop());
    const double total = round.total().value;
    EXPECT_NEAR(round.parameter_at(total + 1.0), round.parameter_at(1.0), 1e-12);
    EXPECT_NEAR(round.parameter_at(-1.0), round.parameter_at(total - 1.0), 1e-12);
    EXPECT_NEAR(round.length_at(6.0), round.length_at(1.0), 1e-13);
    EXPECT_NEAR(round.length_at(5.0), total, 1e-13);
}

TEST(ArcLengthTable, stretches_without_length_do_no_harm) {
    const Curve still =
        Curve::make({.degree = 1, .knots = {0, 0, 1, 2, 3, 3}, .points = {{0, 0}, {1, 0}, {1, 0}, {1, 1}}}).value();
    const ArcLengthTable table(still);
    EXPECT_EQ(table.total().value, 2.0);
    EXPECT_EQ(table.parameter_at(1.0), 1.0);
    EXPECT_NEAR(table.parameter_at(1.5), 2.5, 1e-15);
    EXPECT_EQ(table.length_at(1.5), 1.0);
    const Curve point = Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {3, Point(1, 1)}}).value();
    EXPECT_EQ(arc_length(point).value, 0.0);
    EXPECT_EQ(ArcLengthTable(point).parameter_at(0.5), 0.0);
    EXPECT_TRUE(std::isfinite(ArcLengthTable(cusp()).parameter_at(arc_length(cusp()).value / 2)));
    EXPECT_NEAR(ArcLengthTable(cusp()).parameter_at(arc_length(cusp()).value / 2), 0.5, 1e-6);
}

TEST(ArcLength, tells_what_rounding_leaves_of_a_curve_much_shorter_than_its_polygon) {
    // Its control points are 1 apart. The length was computed in numbers of 64 binary digits.
    const Curve still = Curve::make({.degree = 25,
                                     .knots = {0.0, 333333333.3333333, 666666666.6666666, 1000000000.0},
                                     .points = {{1000001.1021974011, -1000000.2604886176},
                                                {1000002.2891678213, -1000000.0032045902},
                                                {1000002.9224008515, -1000000.5762406283}},
                                     .weights = {0.00394282231681817, 0.008273036874870058, 20.939214641528597},
                                     .periodic = true})
                            .value();
    const Integral found = arc_length(still);
    EXPECT_NEAR(found.value, 5.8654071894494696e-05, found.error);
    EXPECT_LT(found.error, 1e-8 * found.value);
}

}  // namespace
}  // namespace batten::core
