#include "core/make/conics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/detail/angle.h"
#include "core/curve/knot_analysis.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/conic_form.h"

namespace batten::core {

namespace {

constexpr double half_root = std::numbers::sqrt2 / 2.0;

template <class T>
CurveErrorCode code_of(const Result<T>& result) {
    EXPECT_FALSE(result.has_value());
    return result ? CurveErrorCode{} : result.error().code;
}

// The largest | |C - center| / radius - 1 | over many parameters.
double worst_radius(const Curve& curve, Point center, double radius) {
    double worst = 0.0;
    for (int k = 0; k <= 400; ++k) {
        const double u = curve.domain().lower + curve.domain().length() * k / 400;
        worst = std::max(worst, std::abs(distance(point_at(curve, u), center) / radius - 1.0));
    }
    return worst;
}

}  // namespace

TEST(Angle, is_exact_at_quarters_eighths_and_twelfths) {
    EXPECT_EQ(unit_vector(0), Vector(1, 0));
    EXPECT_EQ(unit_vector(90), Vector(0, 1));
    EXPECT_EQ(unit_vector(180), Vector(-1, 0));
    EXPECT_EQ(unit_vector(-90), Vector(0, -1));
    EXPECT_EQ(unit_vector(3690), Vector(0, 1));
    EXPECT_EQ(unit_vector(45), Vector(half_root, half_root));
    EXPECT_EQ(unit_vector(-135), Vector(-half_root, -half_root));
    EXPECT_EQ(unit_vector(30).y, 0.5);
    EXPECT_EQ(unit_vector(60).x, 0.5);
    EXPECT_EQ(unit_vector(120).x, -0.5);
    EXPECT_EQ(unit_vector(210).y, -0.5);
    EXPECT_EQ(unit_vector(300).x, 0.5);
    for (double angle = 0.5; angle < 360; angle += 7.25) {
        const long double radians = angle * std::numbers::pi_v<long double> / 180.0L;
        EXPECT_NEAR(unit_vector(angle).x, static_cast<double>(std::cos(radians)), 1.2e-16);
        EXPECT_NEAR(unit_vector(angle).y, static_cast<double>(std::sin(radians)), 1.2e-16);
        EXPECT_EQ(unit_vector(-angle), Vector(unit_vector(angle).x, -unit_vector(angle).y));
    }
}

TEST(Conics, circle_of_nine_points_is_the_one_of_the_textbooks) {
    const Curve curve = circle({2, 3}, 4.0).value();
    EXPECT_TRUE(std::ranges::equal(
        curve.control_points(),
        std::vector<Point>{{6, 3}, {6, 7}, {2, 7}, {-2, 7}, {-2, 3}, {-2, -1}, {2, -1}, {6, -1}, {6, 3}}));
    EXPECT_TRUE(std::ranges::equal(curve.weights(),
                                   std::vector<double>{1, half_root, 1, half_root, 1, half_root, 1, half_root, 1}));
    EXPECT_TRUE(std::ranges::equal(curve.knots().values(),
                                   std::vector<double>{0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1}));
    EXPECT_EQ(curve.knots().kind(), KnotKind::piecewise_bezier);
    EXPECT_LE(worst_radius(curve, {2, 3}, 4.0), 4e-16);
}

TEST(Conics, circle_of_seven_points_has_a_triangle_around_it) {
    const Curve curve = circle({0, 0}, 1.0, CirclePolygon::triangle).value();
    ASSERT_EQ(curve.control_points().size(), 7u);
    const double h = std::sqrt(3.0);
    const std::vector<Point> expected{{1, 0}, {1, h}, {-0.5, h / 2}, {-2, 0}, {-0.5, -h / 2}, {1, -h}, {1, 0}};
    for (std::size_t i = 0; i < 7; ++i) {
        EXPECT_NEAR(curve.control_points()[i].x, expected[i].x, 1e-15) << i;
        EXPECT_NEAR(curve.control_points()[i].y, expected[i].y, 1e-15) << i;
        EXPECT_EQ(curve.weights()[i], i % 2 == 0 ? 1.0 : 0.5) << i;
    }
    EXPECT_EQ(curve.control_points().front(), curve.control_points().back());
    EXPECT_LE(worst_radius(curve, {0, 0}, 1.0), 4e-16);
}

TEST(Conics, arcs_of_all_angles_have_the_right_ends_pieces_and_weights) {
    const struct {
        double sweep;
        std::size_t points;
        double weight;
    } expectations[] = {{30, 3, std::cos(std::numbers::pi / 12)},          {90, 3, half_root},
                        {91, 5, std::cos(45.5 * std::numbers::pi / 360)},  {180, 5, half_root},
                        {200, 7, std::cos(std::numbers::pi / 5.4)},        {270, 7, half_root},
                        {300, 9, std::cos(37.5 * std::numbers::pi / 180)}, {360, 9, half_root}};
    for (const auto& [sweep, points, weight] : expectations)
        for (const double sign : {1.0, -1.0}) {
            const Curve arc = circular_arc({1, 1}, 2.0, {.start = 20.0, .sweep = sign * sweep}).value();
            EXPECT_EQ(arc.control_points().size(), points) << sweep;
            EXPECT_NEAR(arc.weights()[1], weight, 2e-16) << sweep;
            EXPECT_EQ(arc.domain(), (Interval{0, 1}));
            const Point end = Point(1, 1) + 2.0 * unit_vector(20.0 + sign * sweep);
            EXPECT_LE(distance(arc.control_points().back(), end), 2e-15) << sweep;
            EXPECT_LE(worst_radius(arc, {1, 1}, 2.0), 6e-16) << sweep;
            // Turns the way that the sign says.
            const auto curvature = curvature_at(arc, 0.3);
            ASSERT_TRUE(curvature.has_value());
            EXPECT_NEAR(*curvature, sign * 0.5, 1e-14) << sweep;
        }
}

TEST(Conics, ellipse_lies_on_its_axes) {
    const EllipseFrame frame{.center = {1, 2}, .first_axis = 5, .second_axis = 3, .rotation = 90};
    const Curve curve = ellipse(frame).value();
    EXPECT_EQ(curve.control_points()[0], Point(1, 7));
    EXPECT_EQ(curve.control_points()[1], Point(-2, 7));
    EXPECT_EQ(curve.control_points()[2], Point(-2, 2));
    EXPECT_EQ(curve.control_points()[4], Point(1, -3));
    for (int k = 0; k <= 100; ++k) {
        const Point at = point_at(curve, k / 100.0);
        EXPECT_NEAR(std::pow((at.y - 2) / 5, 2) + std::pow((at.x - 1) / 3, 2), 1.0, 1e-15);
    }
    // The angle of an elliptic arc is the one of the circle behind it.
    const Curve arc = elliptic_arc(frame, {.start = 30, .sweep = 120}).value();
    EXPECT_NEAR(arc.control_points().front().x, 1 - 1.5, 1e-15);
    EXPECT_NEAR(arc.control_points().front().y, 2 + 5 * std::sqrt(0.75), 2e-15);
    EXPECT_NEAR(arc.control_points().back().y, 2 - 5 * std::sqrt(0.75), 2e-15);
}

TEST(Conics, parabola_follows_its_formula) {
    // Opening upwards, with focal length 1/2: y = x^2 / 2.
    const Curve up = parabola_arc({0, 0}, 0.5, 90.0, {-1, 3}).value();
    EXPECT_TRUE(std::ranges::equal(up.control_points(), std::vector<Point>{{-1, 0.5}, {1, -1.5}, {3, 4.5}}));
    EXPECT_FALSE(up.is_rational());
    for (const double t : {-1.0, -0.25, 0.0, 2.0, 3.0}) EXPECT_EQ(point_at(up, t), Point(t, t * t / 2));
    // Opening to the right, from its vertex to t on the lower side.
    const Curve right = parabola_arc({1, 1}, 0.25, 0.0, {0, 2}).value();
    EXPECT_EQ(right.control_points().back(), Point(5, -1));
}

TEST(Conics, hyperbola_follows_its_formula) {
    const EllipseFrame frame{.center = {1, 0}, .first_axis = 2, .second_axis = 3};
    const Curve arc = hyperbola_arc(frame, {-1, 1.5}).value();
    EXPECT_NEAR(arc.weights()[1], std::cosh(1.25), 1e-15);
    EXPECT_NEAR(arc.control_points()[0].x, 1 + 2 * std::cosh(1.0), 1e-15);
    EXPECT_NEAR(arc.control_points()[0].y, -3 * std::sinh(1.0), 1e-15);
    EXPECT_NEAR(arc.control_points()[2].y, 3 * std::sinh(1.5), 2e-15);
    for (int k = 0; k <= 100; ++k) {
        const Point at = point_at(arc, -1 + 2.5 * k / 100);
        EXPECT_NEAR(std::pow((at.x - 1) / 2, 2) - std::pow(at.y / 3, 2), 1.0, 1e-14);
    }
}

TEST(Conics, shoulder_point_divides_by_the_weight) {
    for (const double weight : {0.01, 0.5, 1.0, 3.0, 100.0}) {
        const Curve curve = conic({0, 0}, {1, 2}, {2, 0}, weight).value();
        const ConicForm form = conic_form(bezier_piece(curve, 2)).value();
        EXPECT_NEAR(form.shoulder_ratio, weight / (1.0 + weight), 1e-16);
        EXPECT_NEAR(form.weight, weight, 1e-15 * weight);
        EXPECT_NEAR(form.shoulder.y, 2.0 * weight / (1.0 + weight), 1e-15);
        EXPECT_NEAR(point_at(curve, 0.5).y, form.shoulder.y, 1e-15);
        EXPECT_EQ(form.type, weight < 1 ? ConicType::ellipse : weight > 1 ? ConicType::hyperbola : ConicType::parabola);
    }
}

TEST(ConicForm, finds_type_and_equation_whatever_the_weights_are_scaled_by) {
    // Weights (4, 1, 1/4) make the same parabola as (1, 1, 1): y = x^2 between (-1, 1) and (1, 1).
    const Curve curve =
        Curve::make(
            {.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{-1, 1}, {0, -1}, {1, 1}}, .weights = {4, 1, 0.25}})
            .value();
    const ConicForm form = conic_form(bezier_piece(curve, 2)).value();
    EXPECT_EQ(form.type, ConicType::parabola);
    EXPECT_NEAR(form.shoulder.y, 0.0, 1e-16);
    const ImplicitConic equation = form.equation.seen_from({0, 0});
    EXPECT_NEAR(equation.a, 1.0, 1e-15);
    EXPECT_NEAR(equation.b, 0.0, 1e-15);
    EXPECT_NEAR(equation.c, 0.0, 1e-15);
    EXPECT_NEAR(equation.d, 0.0, 1e-15);
    EXPECT_NEAR(equation.e, -1.0, 1e-15);
    EXPECT_NEAR(equation.f, 0.0, 1e-15);
}

TEST(ConicForm, vanishes_on_the_curve_far_from_the_origin) {
    const Curve curve = elliptic_arc({{1e6, -1e6}, 3, 2, 30}, {.start = 10, .sweep = 80}).value();
    const ConicForm form = conic_form(bezier_piece(curve, 2)).value();
    EXPECT_EQ(form.type, ConicType::ellipse);
    for (int k = 0; k <= 50; ++k)
        // The coordinates are rounded to 1e-10, and the gradient is at most about 2 * 3.
        EXPECT_NEAR(form.equation.value_at(point_at(curve, k / 50.0)), 0.0, 2e-9);
    // Off the curve it is not zero.
    EXPECT_GT(std::abs(form.equation.value_at({1e6, -1e6})), 1.0);
}

TEST(Conics, refuse_what_is_degenerate) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(code_of(circle({0, 0}, 0.0)), CurveErrorCode::length_not_positive);
    EXPECT_EQ(code_of(circle({0, 0}, nan)), CurveErrorCode::length_not_positive);
    EXPECT_EQ(code_of(circle({0, nan}, 1.0)), CurveErrorCode::point_not_finite);
    EXPECT_EQ(code_of(ellipse({{0, 0}, 1.0, -1.0, 0.0})), CurveErrorCode::length_not_positive);
    EXPECT_EQ(code_of(circular_arc({0, 0}, 1.0, {0, 0})), CurveErrorCode::angle_out_of_range);
    EXPECT_EQ(code_of(circular_arc({0, 0}, 1.0, {0, 361})), CurveErrorCode::angle_out_of_range);
    EXPECT_EQ(code_of(circular_arc({0, 0}, 1.0, {0, nan})), CurveErrorCode::angle_out_of_range);
    EXPECT_EQ(code_of(circular_arc({0, 0}, 1.0, {nan, 90})), CurveErrorCode::point_not_finite);
    EXPECT_EQ(code_of(parabola_arc({0, 0}, 0.0, 0.0, {0, 1})), CurveErrorCode::length_not_positive);
    EXPECT_EQ(code_of(parabola_arc({0, 0}, 1.0, 0.0, {1, 1})), CurveErrorCode::range_empty);
    EXPECT_EQ(code_of(hyperbola_arc({}, {1, -1})), CurveErrorCode::range_empty);
    EXPECT_EQ(code_of(hyperbola_arc({}, {-2000, 2000})), CurveErrorCode::point_not_finite);
    EXPECT_EQ(code_of(conic({0, 0}, {1, 1}, {2, 2}, 1.0)), CurveErrorCode::points_collinear);
    EXPECT_EQ(code_of(conic({0, 0}, {0, 0}, {2, 2}, 1.0)), CurveErrorCode::points_collinear);
    EXPECT_EQ(code_of(conic({0, 0}, {1, 2}, {2, 0}, -0.5)), CurveErrorCode::weight_not_positive);
    EXPECT_EQ(code_of(conic({0, 0}, {nan, 2}, {2, 0}, 1.0)), CurveErrorCode::points_collinear);
    const Curve cubic =
        Curve::make({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{0, 0}, {1, 1}, {2, 1}, {3, 0}}})
            .value();
    EXPECT_EQ(code_of(conic_form(bezier_piece(cubic, 3))), CurveErrorCode::degree_unsuitable);
    const Curve straight =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {1, 1}, {3, 3}}}).value();
    EXPECT_EQ(code_of(conic_form(bezier_piece(straight, 2))), CurveErrorCode::points_collinear);
}

}  // namespace batten::core
