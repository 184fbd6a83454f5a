#include "core/measure/conic_arc.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/evaluate/evaluate.h"
#include "core/make/conics.h"
#include "tests/core/bezier_curve.h"

namespace batten::core {
namespace {

const double half_root = std::sqrt(0.5);
const double root_of_3 = std::sqrt(3.0);

ConicArc arc_of(const Curve& curve) {
    return conic_arc(bezier_piece(curve, 2)).value();
}

ConicArc quarter(double weight) {
    return arc_of(bezier({{3, 0}, {3, 3}, {0, 3}}, {1, weight, 1}));
}

// Calls `visit` for many points of all curves.
template <class Visit>
void visit_points(const std::vector<Curve>& curves, const Visit& visit) {
    for (const Curve& curve : curves)
        for (int k = 0; k <= 64; ++k) visit(point_at(curve, k / 64.0));
}

TEST(ConicArc, is_what_its_weight_says) {
    EXPECT_EQ(quarter(0.5).kind, ConicKind::ellipse);
    EXPECT_EQ(quarter(half_root).kind, ConicKind::circle);
    EXPECT_EQ(quarter(0.9).kind, ConicKind::ellipse);
    EXPECT_EQ(quarter(1).kind, ConicKind::parabola);
    EXPECT_EQ(quarter(1.001).kind, ConicKind::hyperbola);
}

TEST(ConicArc, is_a_circle_within_the_tolerance_only) {
    EXPECT_EQ(quarter(half_root * (1 + 0.9 * circle_tolerance)).kind, ConicKind::circle);
    EXPECT_EQ(quarter(half_root * (1 - 0.9 * circle_tolerance)).kind, ConicKind::circle);
    EXPECT_EQ(quarter(half_root * (1 + 1.1 * circle_tolerance)).kind, ConicKind::ellipse);
    EXPECT_EQ(quarter(half_root * (1 - 1.1 * circle_tolerance)).kind, ConicKind::ellipse);
}

TEST(ConicArc, has_the_points_and_ratio_of_the_lecture) {
    const ConicArc arc = quarter(0.5);
    EXPECT_EQ(arc.chord_middle, Point(1.5, 1.5));
    EXPECT_NEAR(arc.form.shoulder_ratio, 1.0 / 3.0, 1e-16);
    EXPECT_NEAR(distance(arc.chord_middle, arc.form.shoulder) / distance(arc.chord_middle, arc.points[1]), 1.0 / 3.0,
                1e-15);
    EXPECT_EQ(arc.legs, (std::array<double, 2>{3, 3}));
}

// Half the angle at P1 and the sine of it, for arcs of 90, 120 and 60 degrees of a circle.
TEST(ConicArc, of_a_circle_has_the_sine_of_its_angle_as_weight) {
    EXPECT_DOUBLE_EQ(quarter(1).half_angle, 45);
    EXPECT_DOUBLE_EQ(quarter(1).circular_weight.value(), half_root);
    const ConicArc third = arc_of(bezier({{1, 0}, {1, root_of_3}, {-0.5, root_of_3 / 2}}, {1, 0.5, 1}));
    EXPECT_NEAR(third.half_angle, 30, 1e-13);
    EXPECT_NEAR(third.circular_weight.value(), 0.5, 1e-15);
    EXPECT_EQ(third.kind, ConicKind::circle);
    const ConicArc sixth = arc_of(bezier({{1, 0}, {1, 1 / root_of_3}, {0.5, root_of_3 / 2}}, {1, 2, 1}));
    EXPECT_NEAR(sixth.half_angle, 60, 1e-13);
    EXPECT_NEAR(sixth.circular_weight.value(), root_of_3 / 2, 1e-15);
    EXPECT_EQ(sixth.kind, ConicKind::hyperbola);
}

TEST(ConicArc, of_unequal_legs_has_no_circular_weight) {
    const ConicArc arc = arc_of(bezier({{4, 0}, {4, 3}, {0, 3}}, {1, half_root, 1}));
    EXPECT_FALSE(arc.circular_weight);
    EXPECT_EQ(arc.kind, ConicKind::ellipse);
    EXPECT_EQ(arc.legs, (std::array<double, 2>{3, 4}));
    EXPECT_DOUBLE_EQ(arc.half_angle, 45);
}

TEST(ConicArc, sees_the_weights_in_standard_form) {
    // w1 / root of (w0 w2) = 1 / root of 2.
    EXPECT_EQ(arc_of(bezier({{3, 0}, {3, 3}, {0, 3}}, {1, 1, 2})).kind, ConicKind::circle);
    EXPECT_EQ(arc_of(bezier({{3, 0}, {3, 3}, {0, 3}}, {4, 2, 1})).kind, ConicKind::parabola);
}

TEST(ConicArc, is_found_far_from_the_origin_and_at_any_size) {
    const double far = 1e6;
    EXPECT_EQ(arc_of(bezier({{far + 3, far}, {far + 3, far + 3}, {far, far + 3}}, {1, half_root, 1})).kind,
              ConicKind::circle);
    EXPECT_EQ(arc_of(bezier({{3e100, 0}, {3e100, 3e100}, {0, 3e100}}, {1, half_root, 1})).kind, ConicKind::circle);
    EXPECT_EQ(arc_of(bezier({{3e-100, 0}, {3e-100, 3e-100}, {0, 3e-100}}, {1, half_root, 1})).kind, ConicKind::circle);
}

TEST(ConicArc, is_refused_as_its_form_is) {
    const Curve straight = bezier({{0, 0}, {1, 1}, {2, 2}});
    EXPECT_EQ(conic_arc(bezier_piece(straight, 2)).error().code, CurveErrorCode::points_collinear);
    const Curve cubic = bezier({{0, 0}, {1, 1}, {2, 0}, {3, 1}});
    EXPECT_EQ(conic_arc(bezier_piece(cubic, 3)).error().code, CurveErrorCode::degree_unsuitable);
}

TEST(Complement, of_a_quarter_is_the_rest_of_the_circle) {
    const auto rest = complement_of(quarter(half_root), 1.0);
    ASSERT_EQ(rest.size(), 1U);
    EXPECT_LT(distance(point_at(rest[0], 0), {3, 0}), 1e-15);
    EXPECT_LT(distance(point_at(rest[0], 1), {0, 3}), 1e-15);
    // Opposite to the shoulder at 45 degrees.
    EXPECT_LT(distance(point_at(rest[0], 0.5), {-3 * half_root, -3 * half_root}), 1e-14);
    visit_points(rest, [](Point point) {
        EXPECT_NEAR(distance(point, {0, 0}), 3, 1e-14);
        EXPECT_LE(point.x + point.y, 3 + 1e-14);
    });
    EXPECT_LT(point_at(rest[0], 0.25).y, 0);
    EXPECT_LT(point_at(rest[0], 0.75).x, 0);
}

// With P0 = (-1, 1), P1 = (0, -1), P2 = (1, 1) it is y = x^2.
TEST(Complement, of_a_parabola_goes_up_on_both_sides) {
    const auto rest = complement_of(arc_of(bezier({{-1, 1}, {0, -1}, {1, 1}})), 100.0);
    ASSERT_EQ(rest.size(), 2U);
    visit_points(rest, [](Point point) { EXPECT_NEAR(point.y, point.x * point.x, 1e-13 * (1 + point.y)); });
    EXPECT_EQ(point_at(rest[0], 0), Point(-1, 1));
    EXPECT_LT(point_at(rest[0], 1).x, -9);
    EXPECT_GE(distance(point_at(rest[0], 1), {0, -1}), 100);
    EXPECT_GT(point_at(rest[1], 0).x, 9);
    EXPECT_EQ(point_at(rest[1], 1), Point(1, 1));
}

TEST(Complement, of_a_hyperbola_has_another_branch) {
    // x^2 - y^2 = 1: the tangents at cosh t = 1.25, sinh t = 0.75 meet in (0.8, 0); w = cosh t.
    const ConicArc arc = arc_of(bezier({{1.25, -0.75}, {0.8, 0}, {1.25, 0.75}}, {1, 1.25, 1}));
    EXPECT_EQ(arc.form.shoulder, Point(1, 0));
    const auto rest = complement_of(arc, 50.0);
    ASSERT_EQ(rest.size(), 3U);
    visit_points(rest, [](Point point) {
        EXPECT_NEAR((point.x - point.y) * (point.x + point.y), 1, 1e-12 * (1 + point.x * point.x));
    });
    EXPECT_LT(distance(point_at(rest[1], 0.5), {-1, 0}), 1e-14);
    visit_points({rest[1]}, [](Point point) { EXPECT_LE(point.x, -1 + 1e-14); });
    visit_points({rest[0]}, [](Point point) { EXPECT_LE(point.y, -0.75 + 1e-14); });
    visit_points({rest[2]}, [](Point point) { EXPECT_GE(point.y, 0.75 - 1e-14); });
    for (const Point end : {point_at(rest[0], 1), point_at(rest[1], 0), point_at(rest[1], 1), point_at(rest[2], 0)})
        EXPECT_GE(distance(end, {0.8, 0}), 50);
}

TEST(Complement, satisfies_the_equation_of_its_arc_for_every_weight) {
    for (const double w : {1e-6, 0.1, 0.7, 0.999, 1 - 1e-9, 1.0, 1 + 1e-9, 1.001, 2.0, 1e3, 1e6}) {
        const ConicArc arc = arc_of(bezier({{1e6, 7}, {1e6 + 4, 9}, {1e6 + 2, 5}}, {2, 2 * w, 2}));
        const auto rest = complement_of(arc, 20.0);
        EXPECT_EQ(rest.size(), w < 1 ? 1U : w == 1 ? 2U : 3U) << w;
        visit_points(rest, [&](Point point) {
            const double x = std::abs(point.x - arc.form.equation.origin.x);
            const double y = std::abs(point.y - arc.form.equation.origin.y);
            const double size = (x + y + 5) * (x + y + 5);
            EXPECT_LT(std::abs(arc.form.equation.value_at(point)), 1e-7 * size) << w;
        });
    }
}

TEST(Complement, of_extreme_sizes_has_no_points_that_are_no_numbers) {
    for (const double w : {1 - 1e-15, 1 + 4e-15, 1e-300, 1e300})
        for (const double size : {1e-150, 1.0, 1e150}) {
            const auto arc = conic_arc(bezier_piece(bezier({{size, 0}, {size, size}, {0, size}}, {1, w, 1}), 2));
            if (!arc) continue;
            visit_points(complement_of(*arc, 10 * size), [](Point point) { EXPECT_TRUE(is_finite(point)); });
        }
}

}  // namespace
}  // namespace batten::core
