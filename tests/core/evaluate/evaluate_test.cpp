#include "core/evaluate/evaluate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "core/curve/knot_kinds.h"
#include "core/evaluate/basis.h"
#include "tests/core/golden.h"
#include "tests/core/random_curves.h"
#include "tests/core/reference.h"

namespace batten::core {

namespace {

using reference::relative_distance;

Curve circle() {
    const double w = std::numbers::sqrt2 / 2;
    return Curve::make({.degree = 2,
                        .knots = {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1},
                        .points = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}},
                        .weights = {1, w, 1, w, 1, w, 1, w, 1}})
        .value();
}

Curve torn() {
    return Curve::make({.degree = 2,
                        .knots = {0, 0, 0, 1, 1, 1, 2, 2, 2},
                        .points = {{0, 0}, {1, 1}, {2, 0}, {5, 0}, {6, -1}, {7, 0}},
                        .tears = Tears::allow})
        .value();
}

CurveDefinition moved(CurveDefinition definition, Vector offset) {
    for (Point& point : definition.points) point += offset;
    return definition;
}

}  // namespace

TEST(Evaluate, agrees_with_the_definition) {
    RandomCurves random(10);
    for (int k = 0; k < 500; ++k) {
        const Curve curve = random.curve();
        const double u = random.parameter(curve);
        EXPECT_LE(relative_distance(curve, point_at(curve, u), reference::point_at(curve, u)), 1e-14);
    }
}

TEST(Evaluate, at_the_highest_degree_is_the_sum_of_its_basis) {
    RandomCurves random(21);
    for (const std::size_t n : {std::size_t{2}, std::size_t{3}, std::size_t{26}, std::size_t{40}})
        for (const KnotKind kind : {KnotKind::periodic, KnotKind::clamped_uniform, KnotKind::uniform}) {
            const auto knots = make_knots(kind, max_degree, n);
            if (!knots) continue;
            std::vector<Point> points;
            for (std::size_t i = 0; i < n; ++i) points.emplace_back(random.number(-8, 8), random.number(-8, 8));
            const Curve curve = Curve::make(*knots, points, {}).value();
            for (int k = 0; k < 3; ++k) {
                const double u = random.parameter(curve);
                const BasisValues basis = basis_functions(*knots, u);
                Vector sum{};
                for (std::size_t j = 0; j <= max_degree; ++j)
                    sum += basis.derivatives[0][j] * vector_to(points[(basis.span - max_degree + j) % n]);
                EXPECT_LE(relative_distance(curve, point_at(curve, u), tip_of(sum)), 1e-13);
            }
        }
}

TEST(Evaluate, clamps_an_open_parameter_and_wraps_a_periodic_one) {
    RandomCurves random(11);
    const Curve open = random.open_curve();
    EXPECT_EQ(point_at(open, open.domain().upper + 3), point_at(open, open.domain().upper));
    EXPECT_EQ(point_at(open, -std::numeric_limits<double>::infinity()), point_at(open, open.domain().lower));
    EXPECT_EQ(point_at(open, std::nan("")), point_at(open, open.domain().lower));
    for (int k = 0; k < 100; ++k) {
        const Curve curve = random.periodic_curve();
        const double u = random.parameter(curve);
        const double other = u + random.whole(-3, 3) * curve.domain().length();
        EXPECT_LE(relative_distance(curve, point_at(curve, u), point_at(curve, other)), 1e-12);
    }
}

TEST(Evaluate, circle_is_a_circle) {
    const Curve curve = circle();
    for (int k = 0; k <= 1000; ++k) {
        const double u = k / 1000.0;
        const Point point = point_at(curve, u);
        EXPECT_NEAR(std::hypot(point.x, point.y), 1.0, 1e-15);
        EXPECT_NEAR(curvature_at(curve, u).value(), 1.0, 1e-13);
        EXPECT_NEAR(curvature_at(curve, u, Side::left).value(), 1.0, 1e-13);
    }
    EXPECT_EQ(point_at(curve, 0.25), Point(0, 1));
}

TEST(Evaluate, derivatives_of_a_rational_quarter_circle_by_hand) {
    // C(u) = (1 - u^2, 2u) / (1 + u^2), so C'(u) = (-4u, 2 - 2u^2) / (1 + u^2)^2.
    const Curve curve =
        Curve::make(
            {.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{1, 0}, {1, 1}, {0, 1}}, .weights = {1, 1, 2}})
            .value();
    const auto at_half = derivatives_at(curve, 0.5, 2);
    EXPECT_NEAR(at_half.point.x, 0.6, 1e-15);
    EXPECT_NEAR(at_half.point.y, 0.8, 1e-15);
    EXPECT_NEAR(at_half[1].x, -1.28, 1e-14);
    EXPECT_NEAR(at_half[1].y, 0.96, 1e-14);
    // x'' = (12 u^2 - 4) / (1 + u^2)^3, y'' = (4 u^3 - 12 u) / (1 + u^2)^3.
    EXPECT_NEAR(at_half[2].x, -0.512, 1e-14);
    EXPECT_NEAR(at_half[2].y, -2.816, 1e-14);
}

TEST(Evaluate, derivatives_of_any_order_of_a_rational_curve) {
    // C(u) = (u, 0) / (1 + u): at 0 the k-th derivative is (-1)^(k+1) k!.
    const Curve curve =
        Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {0.5, 0}}, .weights = {1, 2}}).value();
    const auto derivatives = derivatives_at(curve, 0.0, 12);
    double expected = -1.0;
    for (std::size_t k = 1; k <= 12; ++k) {
        expected *= -static_cast<double>(k);
        EXPECT_NEAR(derivatives[k].x, expected, 1e-13 * std::abs(expected));
        EXPECT_EQ(derivatives[k].y, 0.0);
    }
}

TEST(Evaluate, derivatives_agree_with_differences_of_points) {
    RandomCurves random(12);
    for (int k = 0; k < 300; ++k) {
        const Curve curve = random.curve();
        const std::size_t s = curve.knots().span_at(random.parameter(curve));
        const double h = 1e-4 * (curve.knots()[s + 1] - curve.knots()[s]);
        const double u = 0.3 * curve.knots()[s] + 0.7 * curve.knots()[s + 1];
        const auto derivatives = derivatives_at(curve, u, 3);
        const Point before = point_at(curve, u - h);
        const Point after = point_at(curve, u + h);
        const Vector slope = (after - before) / (2 * h);
        // Central differences are wrong by h^2 C''' / 6.
        const double allowed = h * h * length(derivatives[3]) + 1e-13 / h;
        EXPECT_LE(length(slope - derivatives[1]), allowed);
    }
}

TEST(Evaluate, sides_differ_at_a_knot_by_what_the_multiplicity_allows) {
    const Curve polyline =
        Curve::make({.degree = 1, .knots = {0, 0, 1, 3, 3}, .points = {{0, 0}, {1, 0}, {1, 4}}}).value();
    EXPECT_EQ(derivatives_at(polyline, 1, 1, Side::left)[1], Vector(1, 0));
    EXPECT_EQ(derivatives_at(polyline, 1, 1, Side::right)[1], Vector(0, 2));
    EXPECT_EQ(point_at(polyline, 1, Side::left), point_at(polyline, 1, Side::right));
    // At the ends of an open curve the side is the one inside.
    EXPECT_EQ(derivatives_at(polyline, 0, 1, Side::left)[1], Vector(1, 0));
    EXPECT_EQ(derivatives_at(polyline, 3, 1, Side::right)[1], Vector(0, 2));
}

TEST(Evaluate, both_sides_of_a_tear) {
    EXPECT_EQ(point_at(torn(), 1, Side::left), Point(2, 0));
    EXPECT_EQ(point_at(torn(), 1, Side::right), Point(5, 0));
    EXPECT_EQ(derivatives_at(torn(), 1, 1, Side::left)[1], Vector(2, -2));
    EXPECT_EQ(derivatives_at(torn(), 1, 1, Side::right)[1], Vector(2, -2));
}

TEST(Evaluate, both_sides_of_a_continuous_knot_are_bit_equal) {
    RandomCurves random(13);
    for (int k = 0; k < 300; ++k) {
        const Curve curve = random.open_curve();
        for (const double u : curve.knots().values()) {
            if (!curve.domain().contains(u)) continue;
            EXPECT_EQ(point_at(curve, u, Side::left), point_at(curve, u, Side::right));
        }
    }
}

TEST(Evaluate, scaling_all_weights_changes_nothing) {
    RandomCurves random(14);
    for (int k = 0; k < 200; ++k) {
        const Curve curve = random.curve();
        auto definition = curve.definition();
        for (double& weight : definition.weights) weight *= 1e5;
        const double u = random.parameter(curve);
        EXPECT_LE(relative_distance(curve, point_at(curve, u), point_at(Curve::make(definition).value(), u)), 1e-14);
    }
}

TEST(Evaluate, affine_maps_commute_with_evaluation) {
    RandomCurves random(15);
    const auto map = [](Point point) { return Point(2 * point.x - point.y + 5, 0.5 * point.x + 3 * point.y - 7); };
    for (int k = 0; k < 200; ++k) {
        const Curve curve = random.curve();
        auto definition = curve.definition();
        for (Point& point : definition.points) point = map(point);
        const Curve mapped = Curve::make(definition).value();
        const double u = random.parameter(curve);
        EXPECT_LE(relative_distance(mapped, point_at(mapped, u), map(point_at(curve, u))), 1e-14);
    }
}

TEST(Evaluate, projective_maps_commute_with_evaluation) {
    // (x, y, w) -> (x, y, 0.02 x - 0.03 y + w), which keeps w positive for points within 8 of the origin.
    RandomCurves random(16);
    const auto denominator = [](Point point) { return 0.02 * point.x - 0.03 * point.y + 1.0; };
    for (int k = 0; k < 200; ++k) {
        const Curve curve = random.curve();
        auto definition = curve.definition();
        for (std::size_t i = 0; i < definition.points.size(); ++i) {
            const double factor = denominator(definition.points[i]);
            definition.points[i] = tip_of(vector_to(definition.points[i]) / factor);
            definition.weights[i] *= factor;
        }
        const Curve mapped = Curve::make(definition).value();
        const double u = random.parameter(curve);
        const Point point = point_at(curve, u);
        EXPECT_LE(relative_distance(mapped, point_at(mapped, u), tip_of(vector_to(point) / denominator(point))), 1e-14);
    }
}

TEST(Evaluate, stays_in_the_box_of_its_local_control_points) {
    RandomCurves random(17);
    for (int k = 0; k < 300; ++k) {
        const Curve curve = random.curve();
        const double u = random.parameter(curve);
        const std::size_t s = curve.knots().span_at(u);
        Box box;
        for (std::size_t i = s - static_cast<std::size_t>(curve.degree()); i <= s; ++i)
            box.include(project(curve.homogeneous_point(i)));
        const Vector slack(1e-13, 1e-13);
        box.include(box.lower - slack);
        box.include(box.upper + slack);
        EXPECT_TRUE(box.contains(point_at(curve, u)));
    }
}

TEST(Evaluate, moving_a_control_point_moves_only_its_support) {
    RandomCurves random(18);
    for (int k = 0; k < 100; ++k) {
        const Curve curve = random.open_curve();
        auto definition = curve.definition();
        const auto i = static_cast<std::size_t>(random.whole(0, static_cast<int>(definition.points.size()) - 1));
        definition.points[i] += Vector(1, 2);
        const Curve changed = Curve::make(definition).value();
        for (int j = 0; j < 20; ++j) {
            const double u = random.number(curve.domain().lower, curve.domain().upper);
            const auto p = static_cast<std::size_t>(curve.degree());
            const bool is_supported = curve.knots()[i] < u && u < curve.knots()[i + p + 1];
            const double share = basis_function(curve.knots(), i, u);
            const bool is_same = point_at(curve, u) == point_at(changed, u);
            EXPECT_TRUE(is_same || is_supported);
            EXPECT_FALSE(is_same && share > 1e-9);
        }
    }
}

TEST(Evaluate, curvature_of_a_turn_to_the_right_is_negative) {
    EXPECT_LT(curvature_at(torn(), 0.5).value(), 0.0);
    EXPECT_GT(curvature_at(torn(), 1.5).value(), 0.0);
    // y = x^2 at its vertex.
    const Curve parabola =
        Curve::make({.degree = 2, .knots = {-1, -1, -1, 1, 1, 1}, .points = {{-1, 1}, {0, -1}, {1, 1}}}).value();
    EXPECT_NEAR(curvature_at(parabola, 0).value(), 2.0, 1e-15);
}

TEST(Evaluate, curvature_scales_with_the_curve_and_not_with_the_parameter) {
    RandomCurves random(19);
    for (int k = 0; k < 100; ++k) {
        const Curve curve = random.open_curve();
        auto definition = curve.definition();
        for (Point& point : definition.points) point = tip_of(1024.0 * vector_to(point));
        for (double& knot : definition.knots) knot *= 1.0 / 1048576;
        const double u = random.parameter(curve);
        const auto curvature = curvature_at(curve, u);
        const auto scaled = curvature_at(Curve::make(definition).value(), u / 1048576);
        ASSERT_EQ(curvature.has_value(), scaled.has_value());
        const double expected = curvature.value_or(0.0);
        EXPECT_NEAR(scaled.value_or(0.0) * 1024.0, expected, 1e-9 * std::abs(expected) + 1e-12);
    }
}

TEST(Evaluate, far_from_the_origin_derivatives_lose_nothing) {
    RandomCurves random(20);
    const Vector offset(1048576, -2097152);
    for (int k = 0; k < 300; ++k) {
        auto definition = random.curve().definition();
        // Rounded so that the translated points are exact.
        for (Point& point : definition.points)
            point = {std::round(point.x * 1024.0) / 1024.0, std::round(point.y * 1024.0) / 1024.0};
        const Curve curve = Curve::make(definition).value();
        const Curve far = Curve::make(moved(definition, offset)).value();
        const double u = random.parameter(curve);
        const auto near_derivatives = derivatives_at(curve, u, 2);
        const auto far_derivatives = derivatives_at(far, u, 2);
        EXPECT_LE(distance(far_derivatives.point, near_derivatives.point + offset), 1e-8);
        for (std::size_t r = 1; r <= 2; ++r)
            EXPECT_LE(length(far_derivatives[r] - near_derivatives[r]), 1e-11 * (length(near_derivatives[r]) + 1.0));
    }
}

// Weights times coordinates are beyond doubles; the points are not. Conic with the middle weight W at u = 1/2: as good
// as its middle point; at its ends the ends.
TEST(Evaluate, weights_of_any_size_give_points_and_derivatives) {
    for (const double huge : {1e200, 1e300}) {
        const Curve curve = Curve::make({.degree = 2,
                                         .knots = {0, 0, 0, 1, 1, 1},
                                         .points = {{1, 0}, {1e10, 1}, {0, 1}},
                                         .weights = {huge, huge, huge}})
                                .value();
        // Equal weights are no weights: the parabola at 1/2, and its derivative P2 - P0.
        EXPECT_NEAR(point_at(curve, 0.5).x, 0.25 + 0.5e10, 1e-5);
        EXPECT_NEAR(point_at(curve, 0.5).y, 0.75, 1e-15);
        EXPECT_NEAR(derivatives_at(curve, 0.5, 1)[1].x, -1.0, 1e-5);
        EXPECT_NEAR(derivatives_at(curve, 0.5, 1)[1].y, 1.0, 1e-14);
        CurveDefinition definition = curve.definition();
        definition.weights = {1, huge, 1};
        EXPECT_EQ(point_at(Curve::make(definition).value(), 0.5), Point(1e10, 1));
    }
}

}  // namespace batten::core
