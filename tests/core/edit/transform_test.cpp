#include "core/edit/transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/curve/control_box.h"
#include "core/curve/knot_kinds.h"
#include "core/evaluate/evaluate.h"
#include "core/make/conics.h"
#include "tests/core/near_points.h"
#include "tests/core/random_curves.h"

namespace batten::core {
namespace {

using Code = CurveErrorCode;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<Point> points(const Curve& curve) {
    return {curve.control_points().begin(), curve.control_points().end()};
}

std::vector<double> weights(const Curve& curve) {
    return {curve.weights().begin(), curve.weights().end()};
}

Curve arch() {
    return Curve::make({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{0, 0}, {1, 2}, {3, 2}, {4, 0}}})
        .value();
}

PlaneMap with_last_row(double wx, double wy, double w, Point pivot = {0.0, 0.0}) {
    return {.rows = {{{1, 0, 0}, {0, 1, 0}, {wx, wy, w}}}, .pivot = pivot};
}

// The map as the textbook writes it, in the arithmetic of the test.
Point image_of(const PlaneMap& map, Point point) {
    const long double x = static_cast<long double>(point.x) - map.pivot.x;
    const long double y = static_cast<long double>(point.y) - map.pivot.y;
    const auto row = [&](std::size_t k) { return map.rows[k][0] * x + map.rows[k][1] * y + map.rows[k][2]; };
    return {static_cast<double>(map.pivot.x + row(0) / row(2)), static_cast<double>(map.pivot.y + row(1) / row(2))};
}

PlaneMap random_affine_map(RandomCurves& random) {
    const auto number = [&] { return random.number(-2.0, 2.0); };
    const Point pivot(number(), number());
    return {.rows = {{{3.0 + number(), number(), number()}, {number(), 3.0 + number(), number()}, {0, 0, 1}}},
            .pivot = pivot};
}

// Its horizon passes by the control points.
PlaneMap random_projective_map(RandomCurves& random, const Curve& curve) {
    PlaneMap map = random_affine_map(random);
    map.pivot = control_box(curve).center();
    const Vector size = control_box(curve).size();
    const double most = 0.9 / (size.x + size.y + 1e-3);
    map.rows[2] = {random.number(-most, most), random.number(-most, most), 1.0};
    return map;
}

}  // namespace

TEST(PlaneMap, takes_points_where_its_formula_says) {
    EXPECT_EQ(mapped(translation({2, -3}), {1, 1}), Point(3, -2));
    EXPECT_EQ(mapped(rotation(90, {1, 1}), {2, 1}), Point(1, 2));
    EXPECT_EQ(mapped(rotation(-90, {1, 1}), {2, 1}), Point(1, 0));
    expect_near(mapped(rotation(30, {0, 0}), {2, 0}), {std::numbers::sqrt3, 1}, 1e-15);
    EXPECT_EQ(mapped(scaling(2, -3, {1, 1}), {2, 2}), Point(3, -2));
    EXPECT_EQ(mapped(shearing(0.5, 0, {0, 0}), {1, 2}), Point(2, 2));
    EXPECT_EQ(mapped(shearing(0, 0.5, {0, 0}), {4, 2}), Point(4, 4));
    EXPECT_EQ(mapped(shearing(0.5, 0, {0, 2}), {1, 2}), Point(1, 2)) << "the line through the pivot stays";
    EXPECT_EQ(mapped(reflection(0, {0, 1}), {3, 5}), Point(3, -3));
    EXPECT_EQ(mapped(reflection(90, {1, 0}), {3, 5}), Point(-1, 5));
    EXPECT_EQ(mapped(reflection(45, {0, 0}), {1, 3}), Point(3, 1));
    expect_near(mapped(reflection(30, {0, 0}), {2, 0}), {1, std::numbers::sqrt3}, 1e-15);
    const PlaneMap affine{.rows = {{{1, 2, 3}, {4, 5, 6}, {0, 0, 1}}}};
    EXPECT_EQ(mapped(affine, {10, 100}), Point(213, 546));
}

TEST(PlaneMap, divides_by_the_last_row_where_it_is_projective) {
    const PlaneMap map = with_last_row(0.5, 0, 1);
    EXPECT_FALSE(map.is_affine());
    EXPECT_EQ(mapped(map, {2, 4}), Point(1, 2));
    EXPECT_EQ(weight_factor(map, {2, 4}), 2.0);
    EXPECT_EQ(weight_factor(map, {-4, 1}), -1.0);
    EXPECT_EQ(mapped(with_last_row(0.5, 0, 1, {1, 1}), {3, 5}), Point(2, 3));
    EXPECT_EQ(mapped(with_last_row(0, 0.25, 1), {2, 4}), Point(1, 2));
    EXPECT_FALSE(is_finite(mapped(map, {-2, 4}))) << "the line x = -2 goes to infinity";
}

TEST(PlaneMap, is_written_about_the_origin) {
    // x' = 1 + (x - 1) / (1 + (x - 1) / 2) = (3 x - 1) / (x + 1), and with y seen from 3.
    const PlaneMap map = about_origin(with_last_row(0.5, 0, 1, {1, 3}));
    EXPECT_EQ(map.pivot, Point(0, 0));
    EXPECT_EQ(map.rows, (PlaneMap{.rows = {{{1.5, 0, -0.5}, {1.5, 1, -1.5}, {0.5, 0, 0.5}}}}.rows));
    RandomCurves random(4);
    for (int k = 0; k < 50; ++k) {
        const Curve curve = random.curve();
        const PlaneMap any = random_projective_map(random, curve);
        for (const Point point : points(curve))
            expect_near(mapped(about_origin(any), point), image_of(any, point), 1e-12);
    }
}

TEST(PlaneMap, keeps_the_pivot_and_nears_to_it_far_from_zero) {
    const Point far(1e6 + 0.1, -1e6 + 0.3);
    for (const PlaneMap& map : {rotation(37, far), scaling(1e-7, 3, far), shearing(0.3, 0.7, far), reflection(11, far)})
        EXPECT_EQ(mapped(map, far), far);
    // Rounded once: no more than half a unit of 1e6.
    const Point near = far + Vector(1.0 / 1024, 0.0);
    const Vector step = near - far;
    EXPECT_NEAR(mapped(rotation(60, far), near).x - far.x, 0.5 * step.x, 6e-11);
    EXPECT_NEAR(mapped(rotation(60, far), near).y - far.y, 0.5 * std::numbers::sqrt3 * step.x, 6e-11);
    EXPECT_EQ(mapped(scaling(1e-9, 1e-9, {0, 0}), {3, 7}), Point(3 * 1e-9, 7 * 1e-9));
}

TEST(PlaneMap, is_refused_where_it_is_flat_or_not_finite) {
    EXPECT_TRUE(check_map(PlaneMap{}));
    EXPECT_TRUE(check_map(scaling(1e200, 1e-200, {0, 0})));
    EXPECT_TRUE(check_map({.rows = {{{1e-200, 1, 0}, {1, 1e-200, 0}, {0, 0, 1}}}}));
    EXPECT_TRUE(check_map({.rows = {{{1, 1e-200, 1e-200}, {1, 2e-200, 1e-200}, {1, 1e-200, 3e-200}}}}));
    const CurveError singular{.code = Code::map_singular};
    EXPECT_EQ(check_map(scaling(0, 1, {0, 0})).error(), singular);
    EXPECT_EQ(check_map(scaling(1, 0, {5, 5})).error(), singular);
    EXPECT_EQ(check_map(shearing(2, 0.5, {0, 0})).error(), singular);
    // 0.1 * 0.6 and 0.2 * 0.3 differ as doubles.
    EXPECT_EQ(check_map({.rows = {{{0.1, 0.2, 0}, {0.3, 0.6, 0}, {0, 0, 1}}}}).error(), singular);
    EXPECT_EQ(check_map({.rows = {{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}}}).error(), singular);
    EXPECT_EQ(check_map(with_last_row(0, 0, 0)).error(), singular);
    EXPECT_EQ(check_map(rotation(infinity, {0, 0})).error(), (CurveError{.code = Code::map_not_finite}));
    EXPECT_EQ(check_map(rotation(1, {0, infinity})).error(), (CurveError{.code = Code::map_not_finite}));
}

TEST(Transform, keeps_everything_under_the_identity) {
    RandomCurves random(1);
    for (int k = 0; k < 60; ++k) {
        const Curve curve = random.curve();
        PlaneMap same;
        same.pivot = {random.number(-1e6, 1e6), 0.1};
        EXPECT_EQ(transform(curve, same).value(), curve);
        EXPECT_EQ(transform(curve, rotation(360, same.pivot)).value(), curve);
        EXPECT_EQ(transform(curve, scaling(1, 1, same.pivot)).value(), curve);
    }
}

TEST(Transform, is_undone_by_the_inverse_map) {
    RandomCurves random(2);
    for (int k = 0; k < 60; ++k) {
        const Curve curve = random.curve();
        const Point pivot = points(curve).front();
        const auto there_and_back = [&](const PlaneMap& there, const PlaneMap& back) {
            const Curve result = transform(transform(curve, there).value(), back).value();
            for (std::size_t i = 0; i < points(curve).size(); ++i)
                expect_near(points(result)[i], points(curve)[i], 1e-13);
            EXPECT_EQ(weights(result), weights(curve));
            return result;
        };
        there_and_back(rotation(37, pivot), rotation(-37, pivot));
        there_and_back(shearing(0.3, 0, pivot), shearing(-0.3, 0, pivot));
        there_and_back(reflection(37, pivot), reflection(37, pivot));
        EXPECT_EQ(there_and_back(scaling(4, 0.5, {0, 0}), scaling(0.25, 2, {0, 0})), curve);
        EXPECT_EQ(there_and_back(rotation(90, {0, 0}), rotation(-90, {0, 0})), curve);
        EXPECT_EQ(there_and_back(reflection(0, {0, 0}), reflection(180, {0, 0})), curve);
    }
}

TEST(Transform, agrees_with_mapping_the_points_of_the_curve) {
    RandomCurves random(3);
    for (int k = 0; k < 200; ++k) {
        const Curve curve = random.curve();
        const bool is_projective = k % 2 == 0;
        const PlaneMap map = is_projective ? random_projective_map(random, curve) : random_affine_map(random);
        const Curve image = transform(curve, map).value();
        EXPECT_EQ(image.knots(), curve.knots());
        if (!is_projective) {
            EXPECT_EQ(weights(image), weights(curve));
        }
        for (int j = 0; j < 20; ++j) {
            const double u = random.parameter(curve);
            expect_near(point_at(image, u), image_of(map, point_at(curve, u)), 1e-11);
        }
        EXPECT_LT(largest_map_difference(curve, map, image, 33).distance, 1e-11);
    }
}

TEST(Transform, takes_a_circle_to_a_parabola) {
    const double w = std::sqrt(0.5);
    const Curve quarter =
        Curve::make(
            {.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{1, 0}, {1, 1}, {0, 1}}, .weights = {1, w, 1}})
            .value();
    // The line y = -1, which touches the circle, goes to infinity: X^2 = 1 - 2 Y.
    const Curve image = transform(quarter, with_last_row(0, 1, 1)).value();
    EXPECT_EQ(weights(image), (std::vector<double>{1, 2 * w, 2}));
    EXPECT_EQ(points(image), (std::vector<Point>{{1, 0}, {0.5, 0.5}, {0, 0.5}}));
    for (const double u : {0.0, 0.1, 0.5, 0.8, 1.0}) {
        const Point p = point_at(image, u);
        EXPECT_NEAR(p.x * p.x, 1.0 - 2.0 * p.y, 1e-15);
    }
}

TEST(Transform, makes_a_polynomial_curve_rational_where_it_is_projective) {
    EXPECT_FALSE(transform(arch(), shearing(1, 0, {0, 0})).value().is_rational());
    const Curve image = transform(arch(), with_last_row(0.25, 0, 1)).value();
    EXPECT_TRUE(image.is_rational());
    EXPECT_EQ(weights(image), (std::vector<double>{1, 1.25, 1.75, 2}));
    EXPECT_EQ(points(image)[3], Point(2, 0));
    // Up to a factor the same map: all factors negative.
    const Curve same = transform(arch(), {.rows = {{{-1, 0, 0}, {0, -1, 0}, {-0.25, 0, -1}}}}).value();
    EXPECT_EQ(same, image);
}

TEST(Transform, refuses_what_would_lie_at_infinity_or_beyond) {
    // Zero at x = 3, where point 2 is.
    EXPECT_EQ(transform(arch(), with_last_row(-1, 0, 3)).error(),
              (CurveError{.code = Code::point_beyond_horizon, .index = 2, .value = 0}));
    // 1/3 as a double is a little less.
    EXPECT_EQ(transform(arch(), with_last_row(-1.0 / 3.0, 0, 1)).error(),
              (CurveError{.code = Code::point_beyond_horizon, .index = 2, .value = 0}));
    EXPECT_EQ(transform(arch(), with_last_row(-1, 0, 2)).error(),
              (CurveError{.code = Code::point_beyond_horizon, .index = 2, .value = -1}));
    EXPECT_EQ(describe(transform(arch(), with_last_row(-1, 0, 2)).error()),
              "the map takes control point 2 to infinity or beyond, where its weight would be -1; every weight must "
              "stay above 0");
    EXPECT_EQ(transform(arch(), scaling(1e308, 1, {0, 0})).error(),
              (CurveError{.code = Code::point_not_finite, .index = 2}));
    EXPECT_EQ(describe(transform(arch(), scaling(0, 1, {0, 0})).error()),
              "the map takes the plane onto a line or a point; it must have a determinant other than 0");
    EXPECT_EQ(transform(arch(), translation({std::nan(""), 0})).error(), (CurveError{.code = Code::map_not_finite}));
    EXPECT_EQ(transform(arch(), with_last_row(1e308, 1e308, 1e308)).error(),
              (CurveError{.code = Code::not_computable}));
}

TEST(Transform, maps_some_of_the_points_once_each) {
    const std::vector<std::size_t> some{1, 2, 1};
    const Curve moved = transform_points(arch(), some, translation({0, 1})).value();
    EXPECT_EQ(points(moved), (std::vector<Point>{{0, 0}, {1, 3}, {3, 3}, {4, 0}}));
    const Curve bent = transform_points(arch(), some, with_last_row(0, 0.5, 1)).value();
    EXPECT_EQ(points(bent), (std::vector<Point>{{0, 0}, {0.5, 1}, {1.5, 1}, {4, 0}}));
    EXPECT_EQ(weights(bent), (std::vector<double>{1, 2, 2, 1}));
    EXPECT_EQ(transform_points(arch(), {}, translation({0, 1})).value(), arch());
    EXPECT_EQ(transform_points(arch(), std::vector<std::size_t>{4}, PlaneMap{}).error(),
              (CurveError{.code = Code::point_index_out_of_range, .index = 4, .upper = 3}));
}

TEST(Transform, holds_for_large_curves_of_high_degree) {
    std::vector<Point> zigzag;
    for (int i = 0; i < 10000; ++i) zigzag.emplace_back(1e6 + i, i % 2 == 0 ? -1e6 : 1e6);
    const Curve curve =
        Curve::make(make_knots(KnotKind::clamped_uniform, 25, zigzag.size()).value(), zigzag, {}).value();
    const PlaneMap map = rotation(45, {1e6, 0});
    const Curve image = transform(curve, map).value();
    EXPECT_LT(largest_map_difference(curve, map, image, 65).distance, 1e-8);
    EXPECT_NEAR(points(image)[9999].x, 1e6 + std::sqrt(0.5) * (9999 - 1e6), 1e-9);
}

TEST(LargestMapDifference, finds_how_far_weights_that_are_kept_lead_astray) {
    const Curve line = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {2, 0}}}).value();
    const PlaneMap map = with_last_row(1, 0, 1);
    const Curve kept = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {2.0 / 3.0, 0}}}).value();
    // At u = 1/2 the image of (1, 0) is (1/2, 0), but the middle of the mapped points is (1/3, 0).
    const MapDifference found = largest_map_difference(line, map, kept, 3);
    EXPECT_NEAR(found.distance, 1.0 / 6.0, 1e-15);
    EXPECT_EQ(found.parameter, 0.5);
    EXPECT_NEAR(largest_map_difference(line, map, transform(line, map).value(), 101).distance, 0.0, 1e-15);
}

}  // namespace batten::core
