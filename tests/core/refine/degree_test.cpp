#include "core/refine/degree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/curve/knot_analysis.h"
#include "core/curve/knot_kinds.h"
#include "core/edit/point_edit.h"
#include "core/evaluate/evaluate.h"
#include "core/make/conics.h"
#include "core/measure/continuity.h"
#include "core/measure/deviation.h"
#include "core/refine/clamping.h"
#include "core/refine/detail/carried_point.h"
#include "core/refine/detail/low_elevation.h"
#include "core/refine/detail/spline_elevation.h"
#include "core/refine/knot_refinement.h"
#include "core/refine/periodic.h"
#include "core/refine/reverse.h"
#include "tests/core/golden.h"
#include "tests/core/known_curves.h"
#include "tests/core/random_curves.h"
#include "tests/core/shape_check.h"
#include "tests/core/smooth_shapes.h"

namespace batten::core {
namespace {

using Knots = std::vector<double>;

constexpr double size = 8.0;  // of the random curves

double largest_weight(const Curve& curve) {
    return *std::max_element(curve.weights().begin(), curve.weights().end());
}

Curve make_polynomial(const Curve& curve) {
    CurveDefinition definition = curve.definition();
    definition.weights.clear();
    return Curve::make(std::move(definition)).value();
}

// With one more knot inside as often as it may be there.
Curve with_a_tear(const Curve& curve, RandomCurves& random) {
    const double u = random.number(curve.domain().lower, curve.domain().upper);
    const auto times = static_cast<std::size_t>(curve.degree() + 1 - curve.knots().multiplicity(u));
    return refine_knots(curve, std::vector(times, u), Tears::allow).value_or(curve);
}

// The way that knows every degree and all ends, in homogeneous coordinates.
Curve elevated_by_refinements(const Curve& curve) {
    return settled(curve, elevated(carried(curve), CarriedPoint{}), curve.knots().kind()).value();
}

TEST(Elevation, of_low_degrees_from_pieces_is_that_by_refinements) {
    RandomCurves random(231);
    int compared = 0;
    for (int k = 0; k < 3000; ++k) {
        Curve curve = random.open_curve();
        if (curve.degree() > 3) continue;
        curve = clamp_ends(curve).value();
        if (k % 2 == 0) curve = make_polynomial(curve);
        if (k % 3 == 0) curve = with_a_tear(curve, random);
        ASSERT_TRUE(has_low_elevation(curve));
        const Curve expected = elevated_by_refinements(curve);
        const Curve found = low_elevation(curve).value();
        ASSERT_EQ(found.knots(), expected.knots());
        EXPECT_EQ(found.control_points().front(), curve.control_points().front());
        EXPECT_EQ(found.control_points().back(), curve.control_points().back());
        for (std::size_t i = 0; i < found.control_points().size(); ++i) {
            EXPECT_LE(distance(found.control_points()[i], expected.control_points()[i]), 4e-15 * size);
            EXPECT_NEAR(found.weights()[i], expected.weights()[i], 2e-15 * largest_weight(curve));
        }
        ++compared;
    }
    EXPECT_GE(compared, 1000);
}

TEST(Golden, degree_elevation) {
    golden::Tally tally("degree_elevation.json");
    for (const auto& members : golden::cases("degree_elevation.json")) {
        tally.count_case();
        const auto name = members.at("name").get<std::string>();
        const Curve curve = golden::curve_of(members);
        const Curve expected = golden::curve_of(members.at("result"));
        const Curve found = elevate_degree(curve, members.at("by").get<int>()).value();
        EXPECT_EQ(stored(found), stored(expected)) << name;
        const double scale = golden::largest_coordinate(curve.control_points());
        tally.add("points", golden::largest_difference(found.control_points(), expected.control_points()) / scale,
                  1e-12, name);
        tally.add("weights", golden::largest_difference(found.weights(), expected.weights()) / largest_weight(curve),
                  1e-12, name);
    }
}

TEST(ElevateDegree, keeps_every_sort_of_curve) {
    RandomCurves random(101);
    for (int i = 0; i < 300; ++i) {
        const Curve curve = random.curve();
        const int by = random.whole(1, 3);
        const auto elevated = elevate_degree(curve, by);
        ASSERT_TRUE(elevated.has_value()) << describe(elevated.error());
        EXPECT_EQ(elevated->degree(), curve.degree() + by);
        EXPECT_EQ(elevated->domain(), curve.domain());
        EXPECT_EQ(elevated->is_periodic(), curve.is_periodic());
        EXPECT_LE(largest_deviation(curve, *elevated), 1e-12 * size);
    }
}

TEST(ElevateDegree, is_right_to_the_last_digits_in_every_degree) {
    RandomCurves random(108);
    for (const int degree : {2, 6, 12, 18, 24}) {
        const Curve curve = high_degree_curve(degree, 8, random);
        EXPECT_LE(shape_change(curve, elevate_degree(curve).value(), random), 1.5e-15) << degree;
        CurveDefinition definition = curve.definition();
        std::fill(definition.knots.begin(), definition.knots.end(), 0.0);
        for (std::size_t i = 0; i < definition.knots.size(); ++i) definition.knots[i] = static_cast<double>(i);
        const Curve uniform = Curve::make(definition).value();
        EXPECT_LE(shape_change(uniform, elevate_degree(uniform).value(), random), 1.5e-15) << degree;
    }
    const Curve quadratic = high_degree_curve(2, 8, random);
    EXPECT_LE(shape_change(quadratic, elevate_degree(quadratic, 23).value(), random), 4e-15);
}

TEST(ElevateDegree, far_away_and_with_rings_of_few_points) {
    RandomCurves random(109);
    for (int i = 0; i < 100; ++i) {
        const Curve far = moved(random.curve(), {1e6, -1e6});
        EXPECT_LE(shape_change(far, elevate_degree(far, 2).value(), random), 1e-15);
    }
    for (const int degree : {5, 12, 24}) {
        const Curve ring = Curve::make({.degree = degree,
                                        .knots = {0, 1, 3, 3},
                                        .points = {{-3, 1}, {4, 8}, {2, -5}},
                                        .weights = {1, 2, 0.5},
                                        .periodic = true})
                               .value();
        EXPECT_LE(shape_change(ring, elevate_degree(ring).value(), random), 2e-15);
    }
}

TEST(ElevateDegree, raises_every_multiplicity) {
    RandomCurves random(102);
    for (int i = 0; i < 200; ++i) {
        const Curve curve = random.curve();
        const Curve elevated = elevate_degree(curve, 2).value();
        for (const DistinctKnot& knot : distinct_knots(curve.knots()))
            EXPECT_TRUE(!knot.is_interior || elevated.knots().multiplicity(knot.value) == knot.multiplicity + 2);
    }
}

TEST(ElevateDegree, keeps_ends_bit_by_bit_and_weights_positive) {
    RandomCurves random(103);
    for (int i = 0; i < 200; ++i) {
        const Curve curve = random.open_curve();
        const Curve elevated = elevate_degree(curve).value();
        for (const double weight : elevated.weights()) EXPECT_GT(weight, 0.0);
        if (!is_clamped(curve.knots())) continue;
        EXPECT_EQ(elevated.control_points().front(), curve.control_points().front());
        EXPECT_EQ(elevated.control_points().back(), curve.control_points().back());
        EXPECT_EQ(elevated.weights().back(), curve.weights().back());
    }
}

TEST(ElevateDegree, parabola_as_a_cubic_has_the_points_of_the_book) {
    const Curve parabola =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {3, 6}, {6, 0}}}).value();
    const Curve cubic = elevate_degree(parabola).value();
    const std::vector<Point> expected{{0, 0}, {2, 4}, {4, 4}, {6, 0}};
    EXPECT_LE(golden::largest_difference(cubic.control_points(), expected), 1e-15);
    const Curve bezier = Curve::make(make_knots(KnotKind::bezier, 2, 3).value(), {{0, 0}, {3, 6}, {6, 0}}, {}).value();
    EXPECT_EQ(elevate_degree(bezier)->knots().kind(), KnotKind::bezier);
    EXPECT_EQ(set_degree(bezier, 3).error().code, CurveErrorCode::too_few_points);
}

TEST(ElevateDegree, torn_curves_stay_torn) {
    const Curve torn = Curve::make({.degree = 2,
                                    .knots = {0, 0, 0, 1, 1, 1, 2, 2, 2},
                                    .points = {{0, 0}, {1, 2}, {2, 0}, {5, 0}, {6, 2}, {7, 0}},
                                    .tears = Tears::allow})
                           .value();
    const Curve elevated = elevate_degree(torn).value();
    EXPECT_LE(largest_deviation(torn, elevated), 1e-14);
    EXPECT_EQ(point_at(elevated, 1.0, Side::left), Point(2, 0));
    EXPECT_EQ(point_at(elevated, 1.0, Side::right), Point(5, 0));
    EXPECT_LE(largest_deviation(reduce_degree(elevated).value(), torn), 1e-12);
}

TEST(ElevateDegree, refuses_knots_that_are_one_in_the_next_period) {
    // 1 + 1e-20 is 1.
    const Curve close =
        Curve::make({.degree = 3, .knots = {0, 1e-20, 0.5, 1}, .points = {{0, 0}, {1, 0}, {0, 1}}, .periodic = true})
            .value();
    EXPECT_EQ(elevate_degree(close).error().code, CurveErrorCode::knots_coincide);
    EXPECT_EQ(elevate_degree(close).error().index, 1U);
    const Curve crowded =
        Curve::make({.degree = 3,
                     .knots = {1e-300, 6.4e-133, 1.8e-23, 1.8e-23, 7.7e69, 1.8e72, 1.8e72},
                     .points = {{0.2, -0.2}, {-0.2, -0.2}, {0.8, 0.6}, {0, 0.1}, {-0.5, -0.7}, {0.7, -0.2}},
                     .periodic = true})
            .value();
    EXPECT_EQ(elevate_degree(crowded, 7).error().code, CurveErrorCode::knots_coincide);
}

TEST(ElevateDegree, refuses_degrees_out_of_range) {
    const Curve line = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {1, 1}}}).value();
    EXPECT_EQ(elevate_degree(line, 0).error().code, CurveErrorCode::degree_out_of_range);
    EXPECT_EQ(elevate_degree(line, -1).error().code, CurveErrorCode::degree_out_of_range);
    EXPECT_EQ(elevate_degree(line, 24)->degree(), 25);
    EXPECT_EQ(elevate_degree(line, 25).error(), (CurveError{.code = CurveErrorCode::degree_out_of_range, .value = 26}));
    EXPECT_LE(largest_deviation(line, elevate_degree(line, 24).value()), 1e-13);
}

TEST(ReduceDegree, undoes_elevation) {
    RandomCurves random(104);
    for (int i = 0; i < 300; ++i) {
        const Curve curve = random.curve();
        const auto back = reduce_degree(elevate_degree(curve).value());
        ASSERT_TRUE(back.has_value()) << describe(back.error());
        EXPECT_EQ(back->degree(), curve.degree());
        EXPECT_LE(largest_deviation(curve, *back), 1e-9 * size);
        if (!curve.is_periodic() && !is_clamped(curve.knots())) continue;
        EXPECT_EQ(stored(*back), stored(curve));
        EXPECT_LE(golden::largest_difference(back->control_points(), curve.control_points()), 1e-9 * size);
        EXPECT_LE(golden::largest_difference(back->weights(), curve.weights()), 1e-9 * largest_weight(curve));
    }
}

// There a unit in the last place is 1.2e-10.
TEST(ReduceDegree, undoes_elevation_far_away_to_the_last_digits) {
    RandomCurves random(111);
    for (const int degree : {3, 5, 8, 12}) {
        CurveDefinition definition = high_degree_curve(degree, 16, random).definition();
        std::fill(definition.weights.begin(), definition.weights.end(), 1.0);
        for (Point& point : definition.points) point += Vector(1e6, -1e6);
        for (const bool is_clamped : {true, false}) {
            if (!is_clamped)
                for (std::size_t i = 0; i < definition.knots.size(); ++i) definition.knots[i] = static_cast<double>(i);
            const Curve far = Curve::make(definition).value();
            EXPECT_LE(largest_deviation(far, reduce_degree(elevate_degree(far).value()).value()), 5e-10) << degree;
        }
    }
}

TEST(ReduceDegree, keeps_the_ends_of_a_clamped_curve) {
    RandomCurves random(105);
    for (int i = 0; i < 200; ++i) {
        const Curve curve = random.open_curve();
        if (curve.degree() == 1 || !is_clamped(curve.knots())) continue;
        const auto reduced = reduce_degree(curve);
        if (!reduced) {
            EXPECT_EQ(reduced.error().code, CurveErrorCode::weight_not_positive);
            continue;
        }
        EXPECT_EQ(point_at(*reduced, curve.domain().lower), point_at(curve, curve.domain().lower));
        EXPECT_EQ(point_at(*reduced, curve.domain().upper), point_at(curve, curve.domain().upper));
    }
}

TEST(ReduceDegree, never_fails_for_polynomial_curves) {
    RandomCurves random(106);
    for (int i = 0; i < 500; ++i) {
        CurveDefinition definition = random.curve().definition();
        std::fill(definition.weights.begin(), definition.weights.end(), 1.0);
        if (definition.degree == 1) continue;
        const Curve curve = Curve::make(definition).value();
        const auto reduced = reduce_degree(curve);
        if (!reduced) {
            EXPECT_EQ(reduced.error().code, CurveErrorCode::too_few_points);
            EXPECT_TRUE(curve.is_periodic());
            continue;
        }
        EXPECT_EQ(reduced->degree(), curve.degree() - 1);
        EXPECT_EQ(reduced->domain(), curve.domain());
        EXPECT_FALSE(reduced->is_rational());
        EXPECT_FALSE(elevate_degree(curve)->is_rational());
    }
}

TEST(ReduceDegree, long_curves_take_the_sparse_way) {
    RandomCurves random(107);
    std::vector<Point> points;
    for (int i = 0; i < 200; ++i) points.emplace_back(0.1 * i, random.number(-8.0, 8.0));
    for (const KnotKind kind : {KnotKind::clamped_uniform, KnotKind::periodic}) {
        const Curve curve = Curve::make(make_knots(kind, 3, points.size()).value(), points, {}).value();
        EXPECT_LE(largest_deviation(curve, reduce_degree(elevate_degree(curve).value()).value()), 1e-9 * 20.0);
    }
}

TEST(ReduceDegree, to_a_tolerance_reports_or_refuses_the_error) {
    RandomCurves random(110);
    const Curve cubic = high_degree_curve(3, 4, random);
    const auto back = reduce_degree(elevate_degree(cubic, 3).value(), 3, 1e-6).value();
    EXPECT_EQ(back.curve.degree(), 3);
    EXPECT_LE(back.error, 1e-9);
    const auto refused = reduce_degree(cubic, 1, 1e-6);
    ASSERT_EQ(refused.error().code, CurveErrorCode::deviation_too_large);
    EXPECT_EQ(refused.error().upper, 1e-6);
    const auto allowed = reduce_degree(cubic, 1, refused.error().value).value();
    EXPECT_EQ(allowed.error, refused.error().value);
    EXPECT_EQ(allowed.error, largest_deviation(cubic, allowed.curve));
    EXPECT_EQ(reduce_degree(cubic, 3, 1.0).error().code, CurveErrorCode::degree_out_of_range);
    EXPECT_EQ(reduce_degree(cubic, 0, 1.0).error().code, CurveErrorCode::degree_out_of_range);
    EXPECT_EQ(reduce_degree(cubic, 1, 0.0).error().code, CurveErrorCode::tolerance_not_positive);
}

TEST(ReduceDegree, refuses_a_polyline) {
    const Curve line = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {1, 1}}}).value();
    EXPECT_EQ(reduce_degree(line).error(), (CurveError{.code = CurveErrorCode::degree_out_of_range, .value = 0}));
}

TEST(SetDegree, special_kinds_are_regenerated_with_the_same_points) {
    std::vector<Point> points{{0, 0}, {1, 2}, {2, 0}, {3, 2}, {4, 0}, {5, 2}, {6, 0}};
    for (const KnotKind kind : {KnotKind::uniform, KnotKind::clamped_uniform, KnotKind::periodic}) {
        const Curve curve = Curve::make(make_knots(kind, 3, 7, {2.0, 5.0}).value(), points, {}).value();
        for (const int degree : {1, 2, 4, 6}) {
            const Curve changed = set_degree(curve, degree).value();
            EXPECT_EQ(changed.degree(), degree);
            EXPECT_EQ(changed.knots().kind(), kind);
            EXPECT_EQ(changed.domain(), curve.domain());
            EXPECT_TRUE(std::ranges::equal(changed.control_points(), points));
        }
        EXPECT_EQ(set_degree(curve, 3).value(), curve);
    }
    const Curve arcs = Curve::make(make_knots(KnotKind::piecewise_bezier, 3, 7).value(), points, {}).value();
    EXPECT_EQ(set_degree(arcs, 2)->knots().kind(), KnotKind::piecewise_bezier);
    EXPECT_EQ(set_degree(arcs, 4)->knots().kind(), KnotKind::clamped_uniform);
}

TEST(SetDegree, keeps_typed_uniform_knots_uniform_with_the_same_points) {
    const std::vector<Point> points{{0, 0}, {1, 2}, {2, 0}, {3, 2}, {4, 0}, {5, 2}, {6, 0}};
    const Curve typed =
        Curve::make({.degree = 3, .knots = {0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4}, .points = points}).value();
    ASSERT_EQ(typed.knots().kind(), KnotKind::custom) << "its values alone must tell";
    const Curve quadratic = set_degree(typed, 2).value();
    EXPECT_EQ(quadratic.knots().kind(), KnotKind::clamped_uniform);
    EXPECT_EQ(stored(quadratic), (Knots{0, 0, 0, 0.8, 1.6, 2.4, 3.2, 4, 4, 4}));
    EXPECT_TRUE(std::ranges::equal(quadratic.control_points(), points));
}

TEST(SetDegree, equal_spans_with_one_clamped_end_stay_so_with_the_same_points) {
    const std::vector<Point> points{{0, 0}, {1, 2}, {2, 0}, {3, 2}, {4, 0}};
    const Curve half = Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 2, 3, 4, 5}, .points = points}).value();
    const Curve cubic = set_degree(half, 3).value();
    EXPECT_EQ(stored(cubic), (Knots{0, 0, 0, 0, 1.5, 3, 4.5, 6, 7.5}));
    EXPECT_TRUE(std::ranges::equal(cubic.control_points(), points));
    const Curve line = set_degree(reverse(half).value(), 1).value();
    EXPECT_EQ(stored(line), (Knots{-0.75, 0, 0.75, 1.5, 2.25, 3, 3}));
}

TEST(SetDegree, bezier_polygon_becomes_clamped_uniform_when_its_degree_falls) {
    const Curve bezier =
        Curve::make(make_knots(KnotKind::bezier, 3, 4).value(), {{0, 0}, {1, 2}, {3, 2}, {4, 0}}, {}).value();
    const Curve quadratic = set_degree(bezier, 2).value();
    EXPECT_EQ(quadratic.knots().kind(), KnotKind::clamped_uniform);
    EXPECT_EQ(stored(quadratic), (Knots{0, 0, 0, 0.5, 1, 1, 1}));
}

TEST(SetDegree, refuses_degrees_and_counts_out_of_range) {
    const Curve curve = Curve::make(make_knots(KnotKind::clamped_uniform, 3, 5).value(), {5, Point(1, 1)}, {}).value();
    EXPECT_EQ(set_degree(curve, 0).error().code, CurveErrorCode::degree_out_of_range);
    EXPECT_EQ(set_degree(curve, 26).error(), (CurveError{.code = CurveErrorCode::degree_out_of_range, .value = 26}));
    EXPECT_EQ(set_degree(curve, 5).error(),
              (CurveError{.code = CurveErrorCode::too_few_points, .value = 5, .lower = 6}));
}

TEST(ReduceDegree, keeps_the_smoothness_of_the_shape) {
    RandomCurves random(398);
    for (const int degree : {3, 4, 5, 8})
        for (int k = 0; k < 10; ++k) {
            const Curve curve = smooth_by_shape(degree, 4, random);
            const auto reduced = reduce_degree(curve);
            if (!reduced) continue;
            const auto losses = smoothness_losses(curve, *reduced);
            // A parabola has one curvature; from degree 3 on nothing is lost.
            EXPECT_TRUE(degree == 3 || losses.empty()) << degree;
            for (const SmoothnessLoss& loss : losses) EXPECT_EQ(loss.after.geometric, 1);
        }
}

TEST(ReduceDegree, keeps_a_closed_curve_smooth_at_its_ends) {
    const Curve dented = set_weight(elevate_degree(circle({0, 0}, 1.0).value(), 2).value(), 3, 2.5).value();
    // Weights in a geometric sequence leave the shape of the pieces, and here those of the ends differ by 1.1^16.
    CurveDefinition definition = dented.definition();
    for (std::size_t i = 0; i < definition.weights.size(); ++i)
        definition.weights[i] *= std::pow(1.1, static_cast<double>(i));
    std::vector<Curve> closed{dented, Curve::make(std::move(definition)).value()};
    RandomCurves random(400);
    for (const std::size_t spans : {6U, 80U})
        for (const int degree : {3, 4, 6}) {
            CurveDefinition ring{.degree = degree, .knots = {}, .points = {}, .periodic = true};
            for (std::size_t i = 0; i <= spans; ++i) ring.knots.push_back(static_cast<double>(i));
            for (std::size_t i = 0; i < spans; ++i) {
                const double angle = 6.28 * static_cast<double>(i) / static_cast<double>(spans);
                const double radius = 5.0 + random.number(0.0, 1.0);
                ring.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
                ring.weights.push_back(random.number(0.8, 1.2));
            }
            closed.push_back(to_clamped(Curve::make(std::move(ring)).value()).value());
        }
    for (const Curve& curve : closed) {
        const Curve reduced = reduce_degree(curve).value();
        const int level = std::min(2, reduced.degree() - 1);
        EXPECT_EQ(continuity_of_ends(curve).geometric, 2);
        EXPECT_GE(continuity_of_ends(reduced).geometric, level) << curve.degree();
        EXPECT_EQ(reduced.control_points().front(), reduced.control_points().back());
    }
}

// Two parabolas that go on smoothly at both of their joints are one line, run through to and fro.
TEST(ReduceDegree, lets_a_closed_curve_have_a_corner_where_it_would_shrink_to_a_line) {
    const Curve oval = Curve::make({.degree = 3,
                                    .knots = {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2},
                                    .points = {{2, 0}, {2, 1}, {-2, 1}, {-2, 0}, {-2, -1}, {2, -1}, {2, 0}}})
                           .value();
    EXPECT_EQ(continuity_of_ends(oval).geometric, 2);
    const Curve reduced = reduce_degree(oval).value();
    EXPECT_EQ(continuity_of_ends(reduced).geometric, 0);
    EXPECT_LE(largest_deviation(oval, reduced), 1.0);
}

TEST(ReduceDegree, of_a_raised_curve_that_is_smooth_by_shape_restores_it) {
    RandomCurves random(399);
    for (const int degree : {2, 3, 5}) {
        const Curve curve = smooth_by_shape(degree, 30, random);
        const Curve back = reduce_degree(elevate_degree(curve).value()).value();
        EXPECT_LE(point_difference(curve, back), 1e-9) << degree;
    }
}

}  // namespace
}  // namespace batten::core
