#include "exchange/cad/conic_equation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/evaluate/evaluate.h"

namespace batten::exchange {

namespace {

using core::Point;

ConicArcOfEquation arc_of(const ConicEquation& equation, ConicName name, Point start, Point end) {
    auto arc = arc_of_equation(equation, name, start, end);
    EXPECT_TRUE(arc) << arc.error();
    return arc.value();
}

std::string reason_for(const ConicEquation& equation, Point start, Point end) {
    const auto arc = arc_of_equation(equation, ConicName::none, start, end);
    return arc ? "" : arc.error();
}

std::vector<Point> polygon_of(const core::Curve& curve) {
    return {curve.control_points().begin(), curve.control_points().end()};
}

Point at_part(const core::Curve& curve, double share) {
    const core::Interval domain = curve.domain();
    return core::point_at(curve, domain.lower + share * (domain.upper - domain.lower));
}

// A conic of these half-axes, of which the first points in the direction `angle`.
struct Axes {
    Point center;
    double first;
    double second;
    double angle;
    double sign;  // 1: ellipse, -1: hyperbola

    ConicEquation equation() const {
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        const double p = 1.0 / (first * first);
        const double q = sign / (second * second);
        ConicEquation e{.a = p * c * c + q * s * s, .b = 2.0 * (p - q) * c * s, .c = p * s * s + q * c * c};
        e.d = -2.0 * e.a * center.x - e.b * center.y;
        e.e = -2.0 * e.c * center.y - e.b * center.x;
        e.f = e.a * center.x * center.x + e.b * center.x * center.y + e.c * center.y * center.y - 1.0;
        return e;
    }
    Point at(double t) const {
        const double u = first * (sign > 0.0 ? std::cos(t) : std::cosh(t));
        const double v = second * (sign > 0.0 ? std::sin(t) : std::sinh(t));
        return {center.x + u * std::cos(angle) - v * std::sin(angle),
                center.y + u * std::sin(angle) + v * std::cos(angle)};
    }
    // How far a point is from the conic, measured along the ray from the center.
    double distance_of(Point point) const {
        const core::Vector d = point - center;
        const double u = (d.x * std::cos(angle) + d.y * std::sin(angle)) / first;
        const double v = (-d.x * std::sin(angle) + d.y * std::cos(angle)) / second;
        return core::length(d) * std::abs(1.0 - 1.0 / std::sqrt(std::abs(u * u + sign * v * v)));
    }
};

void expect_on(const Axes& axes, const ConicArcOfEquation& arc) {
    EXPECT_GT(arc.error, 0.0);
    EXPECT_LT(arc.error, 1e-12);
    for (int i = 0; i <= 20; ++i) EXPECT_LE(axes.distance_of(at_part(arc.curve, i / 20.0)), arc.error + 1e-15);
}

}  // namespace

// Of x^2 = 4 y, whose tangents at x = -2 and x = 2 meet in (0, -1).
TEST(ConicEquation, ParabolasAreOnePolynomialPiece) {
    const ConicArcOfEquation upward = arc_of({.a = 1, .e = -4}, ConicName::parabola, {-2, 1}, {2, 1});
    EXPECT_EQ(polygon_of(upward.curve), (std::vector<Point>{{-2, 1}, {0, -1}, {2, 1}}));
    EXPECT_FALSE(upward.curve.is_rational());
    EXPECT_LT(upward.error, 1e-12);
    // (y - 1)^2 = 4 x, from (0, 1) to (1, 3): the tangents are x = 0 and y = x + 2.
    const ConicArcOfEquation aside = arc_of({.c = 1, .d = -4, .e = -2, .f = 1}, ConicName::parabola, {0, 1}, {1, 3});
    EXPECT_EQ(polygon_of(aside.curve), (std::vector<Point>{{0, 1}, {0, 2}, {1, 3}}));
    // (x + y)^2 = x - y, from (0, 0) to (1, 0): the tangents are y = x and y = -(x - 1) / 3.
    const ConicArcOfEquation turned =
        arc_of({.a = 1, .b = 2, .c = 1, .d = -1, .e = 1}, ConicName::none, {0, 0}, {1, 0});
    EXPECT_NEAR(turned.curve.control_points()[1].x, 0.25, 1e-16);
    EXPECT_NEAR(turned.curve.control_points()[1].y, 0.25, 1e-16);
    // The same with all signs turned, and far away.
    const ConicArcOfEquation far = arc_of({.a = -1, .d = 2e6, .e = 4, .f = -1e12 - 4e6}, ConicName::parabola,
                                          {1e6 - 2, 1e6 + 1}, {1e6 + 2, 1e6 + 1});
    EXPECT_EQ(polygon_of(far.curve), (std::vector<Point>{{1e6 - 2, 1e6 + 1}, {1e6, 1e6 - 1}, {1e6 + 2, 1e6 + 1}}));
}

// Coefficients of six digits are no parabola's but by their name; the error says how far they are off.
TEST(ConicEquation, RoundedParabolasAreThoseThatTheirNameSays) {
    const ConicEquation rounded{.a = 0.333333, .b = 0.666667, .c = 0.333333, .d = -1, .e = 1};
    const ConicArcOfEquation arc = arc_of(rounded, ConicName::parabola, {0, 0}, {3, 0});
    EXPECT_EQ(arc.curve.degree(), 2);
    EXPECT_FALSE(arc.curve.is_rational());
    for (int i = 0; i <= 20; ++i) {
        const Point p = at_part(arc.curve, i / 20.0);
        const double value = rounded.a * p.x * p.x + rounded.b * p.x * p.y + rounded.c * p.y * p.y - p.x + p.y;
        const double by_x = 2.0 * rounded.a * p.x + rounded.b * p.y - 1.0;
        const double by_y = rounded.b * p.x + 2.0 * rounded.c * p.y + 1.0;
        EXPECT_LE(std::abs(value) / std::hypot(by_x, by_y), arc.error);
    }
    EXPECT_GT(arc.error, 1e-7);
    EXPECT_LT(arc.error, 1e-5);
}

TEST(ConicEquation, EllipsesRunCounterclockwiseWhereverTheirAxesPoint) {
    for (const double angle : {0.0, 0.5, -0.5, 1.6, 2.1, 3.0})
        for (const double end : {0.4, 1.2, 3.5, 6.5}) {
            const Axes axes{{1, 2}, 2, 1, angle, 1};
            const ConicArcOfEquation arc = arc_of(axes.equation(), ConicName::ellipse, axes.at(0.3), axes.at(end));
            expect_on(axes, arc);
            const Point middle = axes.at(0.5 * (0.3 + end));
            EXPECT_LT(core::distance(at_part(arc.curve, 0.5), middle), 1e-13) << angle << " " << end;
            EXPECT_EQ(arc.curve.control_points().front(), axes.at(0.3));
            EXPECT_EQ(arc.curve.control_points().back(), axes.at(end));
        }
}

// x^2 + y^2 / 4 = 1 is higher than wide.
TEST(ConicEquation, EllipsesAreWholeWhereTheirEndsAreOnePoint) {
    const ConicArcOfEquation whole = arc_of({.a = -1, .c = -0.25, .f = 1}, ConicName::none, {1, 0}, {1, 0});
    EXPECT_LT(core::distance(at_part(whole.curve, 0.25), {0, 2}), 1e-15);
    EXPECT_LT(core::distance(at_part(whole.curve, 0.5), {-1, 0}), 1e-15);
    EXPECT_EQ(at_part(whole.curve, 1.0), (Point{1, 0}));
}

TEST(ConicEquation, HyperbolasGoFromOneEndToTheOther) {
    for (const double angle : {0.0, 0.5, -0.5, 1.6, 2.1, 3.0})
        for (const double end : {1.2, -0.4}) {
            const Axes axes{{1, 2}, 2, 1, angle, -1};
            const ConicArcOfEquation arc = arc_of(axes.equation(), ConicName::hyperbola, axes.at(0.3), axes.at(end));
            expect_on(axes, arc);
            EXPECT_LT(core::distance(at_part(arc.curve, 0.5), axes.at(0.5 * (0.3 + end))), 1e-13);
            EXPECT_NEAR(arc.curve.weights()[1], std::cosh(0.5 * (end - 0.3)), 1e-14);
        }
}

// The unit circle, and an end a thousandth beside it.
TEST(ConicEquation, EndsBesideTheConicAreInTheError) {
    const ConicArcOfEquation arc = arc_of({.a = 1, .c = 1, .f = -1}, ConicName::ellipse, {1, 0}, {0, 1.001});
    EXPECT_EQ(arc.curve.control_points().back(), (Point{0, 1.001}));
    EXPECT_GE(arc.error, 0.001);
    EXPECT_LT(arc.error, 0.004);
    const ConicArcOfEquation begun = arc_of({.a = 1, .c = 1, .f = -1}, ConicName::ellipse, {1.001, 0}, {0, 1});
    EXPECT_GE(begun.error, 0.001);
    EXPECT_LT(begun.error, 0.004);
}

TEST(ConicEquation, SaysWhyThereIsNoArc) {
    EXPECT_EQ(reason_for({.d = 1}, {0, 0}, {1, 0}), "its equation is that of a line");
    EXPECT_EQ(reason_for({.a = 1, .c = -1}, {0, 0}, {1, 1}), "its equation is that of lines or of a point");
    EXPECT_EQ(reason_for({.a = 1, .f = -1}, {1, 0}, {1, 5}), "its equation is that of lines");
    EXPECT_EQ(reason_for({.a = 1, .c = -1, .f = -1}, {1, 0}, {-1, 0}), "its ends are not on one branch of a hyperbola");
    EXPECT_EQ(reason_for({.a = 1, .e = -4}, {0, 0}, {0, 0}), "its ends are one point");
    EXPECT_EQ(reason_for({.a = 1, .c = 1, .f = 5}, {1, 0}, {0, 1}), "its ends are not on the conic of its equation");
}

}  // namespace batten::exchange
