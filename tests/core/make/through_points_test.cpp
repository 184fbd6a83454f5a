#include "core/make/through_points.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/evaluate/evaluate.h"
#include "core/make/interpolate.h"
#include "tests/core/random_curves.h"

namespace batten::core {

namespace {

std::vector<Point> random_places(RandomCurves& random, std::size_t count, double at = 0.0) {
    std::vector<Point> places;
    for (std::size_t k = 0; k < count; ++k) {
        const double x = at + random.number(-8.0, 8.0);
        places.emplace_back(x, at + random.number(-8.0, 8.0));
    }
    return places;
}

FitPoints fit_of(std::span<const Point> places, FitKind kind, bool closed = false,
                 Parametrization parametrization = Parametrization::chordal) {
    return fit_points_at(places, {kind, parametrization, closed}).value();
}

double largest_miss(const Curve& curve, const FitPoints& fit) {
    double largest = 0.0;
    for (std::size_t k = 0; k < fit.points.size(); ++k)
        largest = std::max(largest, distance(point_at(curve, fit.parameters[k]), fit.points[k].place));
    return largest;
}

double largest_difference(const Curve& a, const Curve& b) {
    double largest = 0.0;
    for (int k = 0; k <= 1000; ++k) {
        const double share = k / 1000.0;
        const auto at = [share](const Curve& curve) {
            const Interval domain = curve.domain();
            return point_at(curve, domain.lower + share * domain.length());
        };
        largest = std::max(largest, distance(at(a), at(b)));
    }
    return largest;
}

// By Simpson's rule between the parameters, of the square of the derivative of this order.
double energy(const Curve& curve, std::span<const double> parameters, int order) {
    double sum = 0.0;
    for (std::size_t k = 1; k < parameters.size(); ++k) {
        constexpr int steps = 64;
        const double h = (parameters[k] - parameters[k - 1]) / steps;
        for (int j = 0; j <= steps; ++j) {
            const double u = parameters[k - 1] + j * h;
            const auto d = derivatives_at(curve, u, order, j == steps ? Side::left : Side::right);
            const double weight = j == 0 || j == steps ? 1.0 : j % 2 == 1 ? 4.0 : 2.0;
            sum += weight * h / 3.0 * dot(d[static_cast<std::size_t>(order)], d[static_cast<std::size_t>(order)]);
        }
    }
    return sum;
}

constexpr std::array kinds{FitKind::c2, FitKind::local, FitKind::fair};

}  // namespace

// S(u) = 3/2 u - 1/2 u^3 on the first span, by the equation 4 M_1 = 6 (y_0 - 2 y_1 + y_2) for the second derivative.
TEST(ThroughPoints, c2_is_the_natural_spline) {
    const Point places[] = {{0, 0}, {1, 1}, {2, 0}};
    const FitPoints fit = fit_of(places, FitKind::c2, false, Parametrization::uniform);
    const Curve curve = through_points(fit).value();
    EXPECT_EQ(std::vector(curve.knots().values().begin(), curve.knots().values().end()),
              (std::vector<double>{0, 0, 0, 0, 1, 2, 2, 2, 2}));
    EXPECT_NEAR(point_at(curve, 0.5).y, 11.0 / 16.0, 1e-15);
    EXPECT_NEAR(point_at(curve, 0.5).x, 0.5, 1e-15);
    EXPECT_NEAR(point_at(curve, 1.75).y, 1.5 * 0.25 - 0.5 / 64.0, 1e-15);
}

TEST(ThroughPoints, c2_agrees_with_the_interpolation_with_natural_ends) {
    RandomCurves random(11);
    for (const std::size_t count : {3U, 4U, 12U, 50U}) {
        const std::vector<Point> places = random_places(random, count);
        const Curve curve = through_points(fit_of(places, FitKind::c2)).value();
        const InterpolationRequest request{.ends = NaturalEnds{}};
        const Curve natural = interpolate(places, request).value().curve;
        EXPECT_EQ(curve.control_points().size(), natural.control_points().size());
        EXPECT_LT(largest_difference(curve, natural), 1e-12);
    }
}

// The natural spline of degree 5 is a parabola and c ((u)^5 - 3 (u-1)^5 + 3 (u-2)^5 - (u-3)^5), each from its knot on;
// c = 1/66 for the values 0, 0, 0, 1, whose third difference is 1.
TEST(ThroughPoints, fair_is_the_natural_spline_of_degree_five) {
    const Point places[] = {{0, 0}, {1, 0}, {2, 0}, {3, 1}};
    const FitPoints fit = fit_of(places, FitKind::fair, false, Parametrization::uniform);
    const Curve curve = through_points(fit).value();
    EXPECT_EQ(curve.degree(), 5);
    EXPECT_NEAR(point_at(curve, 0.5).y, 31.0 / 704.0, 1e-14);
    EXPECT_NEAR(point_at(curve, 0.5).x, 0.5, 1e-14);
    const Point parabola[] = {{0, 0}, {1, 1}, {2, 0}};
    const Curve arc = through_points(fit_of(parabola, FitKind::fair, false, Parametrization::uniform)).value();
    EXPECT_NEAR(point_at(arc, 0.5).y, 0.75, 1e-14);
}

TEST(ThroughPoints, passes_all_points_however_they_are_joined) {
    RandomCurves random(5);
    for (int round = 0; round < 200; ++round) {
        const bool closed = random.number(0.0, 1.0) < 0.5;
        const std::size_t count = 3 + static_cast<std::size_t>(random.number(0.0, 9.0));
        FitPoints fit = fit_of(random_places(random, count), kinds[static_cast<std::size_t>(round) % 3], closed);
        for (std::size_t i = 0; i < count; ++i) {
            const auto joint = static_cast<FitJoint>(std::min(7.0, random.number(0.0, 8.0)));
            const double x = random.number(-2.0, 2.0);
            if (joint <= FitJoint::corner_straight)
                fit = set_fit_joint(fit, i, joint, {x, random.number(-2.0, 2.0)}).value();
        }
        const auto curve = through_points(fit);
        ASSERT_TRUE(curve) << describe(curve.error());
        EXPECT_EQ(curve->is_periodic(), closed);
        EXPECT_EQ(curve->domain().lower, fit.parameters.front());
        EXPECT_EQ(curve->domain().upper, fit.parameters.back());
        EXPECT_LT(largest_miss(*curve, fit), 1e-9) << round;
        for (std::size_t i = 0; i < count; ++i) {
            const double u = fit.parameters[i];
            const bool is_end = !closed && (i == 0 || i + 1 == count);
            if (fit.points[i].joint == FitJoint::smooth && !is_end) {
                const Vector left = derivatives_at(*curve, u, 1, Side::left)[1];
                const Vector right = derivatives_at(*curve, u, 1, Side::right)[1];
                const std::size_t before = i == 0 ? count - 1 : i - 1;
                const bool is_alone = fit.points[before].joint != FitJoint::straight;
                if (is_alone) {
                    EXPECT_LT(length(left - right), 1e-8 * (1.0 + length(left))) << round << ' ' << i;
                }
            }
        }
    }
}

TEST(ThroughPoints, has_the_smoothness_of_its_kind) {
    RandomCurves random(3);
    for (const bool closed : {false, true})
        for (const FitKind kind : kinds) {
            const FitPoints fit = fit_of(random_places(random, 7), kind, closed);
            const Curve curve = through_points(fit).value();
            const int order = kind == FitKind::c2 ? 2 : kind == FitKind::local ? 1 : 4;
            for (std::size_t i = closed ? 0 : 1; i + (closed ? 0 : 1) < 7; ++i) {
                const auto left = derivatives_at(curve, fit.parameters[i], order + 1, Side::left);
                const auto right = derivatives_at(curve, fit.parameters[i], order + 1, Side::right);
                for (std::size_t k = 1; k <= static_cast<std::size_t>(order); ++k)
                    EXPECT_LT(length(left[k] - right[k]), 1e-8 * (1.0 + length(left[k])));
                EXPECT_GT(
                    length(left[static_cast<std::size_t>(order) + 1] - right[static_cast<std::size_t>(order) + 1]),
                    1e-6);
            }
        }
}

// Of all curves through the points over these parameters; the other kinds are some of them.
TEST(ThroughPoints, fair_and_c2_have_the_least_integrals) {
    RandomCurves random(17);
    for (const bool closed : {false, true}) {
        const std::vector<Point> places = random_places(random, 9);
        const auto curve = [&](FitKind kind) { return through_points(fit_of(places, kind, closed)).value(); };
        const std::vector<double> u = fit_of(places, FitKind::c2, closed).parameters;
        EXPECT_LT(energy(curve(FitKind::c2), u, 2), 0.999 * energy(curve(FitKind::fair), u, 2));
        EXPECT_LT(energy(curve(FitKind::c2), u, 2), 0.999 * energy(curve(FitKind::local), u, 2));
        EXPECT_LT(energy(curve(FitKind::fair), u, 3), 0.999 * energy(curve(FitKind::c2), u, 3));
        EXPECT_LT(energy(curve(FitKind::fair), u, 3), 0.999 * energy(curve(FitKind::local), u, 3));
    }
}

TEST(ThroughPoints, two_points_give_a_line_run_through_evenly) {
    const Point places[] = {{1, 1}, {4, 5}};
    for (const FitKind kind : kinds) {
        const Curve curve = through_points(fit_of(places, kind)).value();
        EXPECT_EQ(curve.control_points().size(), static_cast<std::size_t>(curve.degree()) + 1);
        EXPECT_EQ(curve.domain(), (Interval{0.0, 5.0}));
        EXPECT_LT(distance(point_at(curve, 1.0), Point(1.6, 1.8)), 1e-15);
    }
}

TEST(ThroughPoints, points_on_a_line_stay_on_it) {
    const Point places[] = {{0, 0}, {1, 2}, {1.5, 3}, {4, 8}, {10, 20}};
    for (const FitKind kind : kinds) {
        const Curve curve = through_points(fit_of(places, kind)).value();
        for (const Point point : curve.control_points()) EXPECT_NEAR(point.y, 2.0 * point.x, 1e-13);
    }
}

// A turn by one point keeps the curve. Of four points on the unit circle, midway between two: 5/8, 11/16 and 361/512 of
// the square root of 2, by the values of the B-splines at halves, and of the local kind by those of Hermite's cubics.
TEST(ThroughPoints, symmetric_points_give_a_symmetric_curve) {
    const Point places[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const std::array expected{11.0 / 16.0, 5.0 / 8.0, 361.0 / 512.0};
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        const FitPoints fit = fit_of(places, kinds[k], true);
        const Curve curve = through_points(fit).value();
        EXPECT_EQ(curve.control_points().size(), kinds[k] == FitKind::local ? 8U : 4U);
        const double step = fit.parameters[1];
        EXPECT_LT(distance(point_at(curve, 0.5 * step), Point(expected[k], expected[k])), 1e-14);
        for (int j = 0; j < 100; ++j) {
            const double u = j * step / 25.0;
            const Point point = point_at(curve, u);
            EXPECT_LT(distance(point_at(curve, u + step), Point(-point.y, point.x)), 1e-13);
        }
    }
}

TEST(ThroughPoints, reversed_points_give_the_reversed_curve) {
    RandomCurves random(23);
    for (const bool closed : {false, true})
        for (const FitKind kind : kinds) {
            std::vector<Point> places = random_places(random, 8);
            const FitPoints fit = fit_of(places, kind, closed);
            std::reverse(places.begin() + (closed ? 1 : 0), places.end());
            const Curve there = through_points(fit).value();
            const Curve back = through_points(fit_of(places, kind, closed)).value();
            const double end = fit.parameters.back();
            for (int k = 0; k <= 100; ++k)
                EXPECT_LT(distance(point_at(there, end * k / 100.0), point_at(back, end * (100 - k) / 100.0)), 1e-11);
        }
}

TEST(ThroughPoints, is_moved_with_its_points) {
    RandomCurves random(29);
    for (const FitKind kind : kinds) {
        std::vector<Point> places = random_places(random, 10);
        for (Point& place : places) place = {std::round(place.x * 64.0) / 64.0, std::round(place.y * 64.0) / 64.0};
        const Curve curve = through_points(fit_of(places, kind)).value();
        for (Point& place : places) place += Vector(1e6, -1e6);
        const Curve moved = through_points(fit_of(places, kind)).value();
        for (std::size_t i = 0; i < curve.control_points().size(); ++i)
            EXPECT_LT(distance(moved.control_points()[i], curve.control_points()[i] + Vector(1e6, -1e6)), 1e-9);
        EXPECT_EQ(moved.knots(), curve.knots());
    }
}

TEST(ThroughPoints, any_size_of_points_will_do) {
    for (const double size : {1e-150, 1e-9, 1e9, 1e100})
        for (const FitKind kind : {FitKind::c2, FitKind::local}) {
            const Point places[] = {{0, 0}, {size, size}, {2 * size, 0}, {3 * size, size}};
            const FitPoints fit = fit_of(places, kind);
            const Curve curve = through_points(fit).value();
            EXPECT_LT(distance(point_at(curve, fit.parameters[1]), places[1]), 1e-14 * size);
        }
}

TEST(ThroughPoints, a_given_tangent_is_that_of_the_handle) {
    const Point places[] = {{0, 0}, {3, 0}, {5, 4}, {9, 4}};
    for (const FitKind kind : kinds) {
        FitPoints fit = fit_of(places, kind, false, Parametrization::uniform);
        fit = set_fit_joint(fit, 1, FitJoint::tangent, {0.5, 2.0}).value();
        fit = set_fit_joint(fit, 3, FitJoint::tangent, {0.0, -1.0}).value();
        const Curve curve = through_points(fit).value();
        for (const Side side : {Side::left, Side::right})
            EXPECT_LT(length(derivatives_at(curve, 1.0, 1, side)[1] - Vector(1.5, 6.0)), 1e-12);
        EXPECT_LT(length(derivatives_at(curve, 3.0, 1, Side::left)[1] - Vector(0.0, -3.0)), 1e-12);
        EXPECT_EQ(curve.knots().multiplicity(1.0), curve.degree() - 1);
    }
}

TEST(ThroughPoints, corners_and_lines_make_a_polygon) {
    const Point places[] = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
    for (const FitKind kind : kinds)
        for (const FitJoint joint : {FitJoint::corner, FitJoint::straight, FitJoint::corner_straight}) {
            FitPoints fit = fit_of(places, kind, true);
            for (std::size_t i = 0; i < 4; ++i) fit = set_fit_joint(fit, i, joint).value();
            const Curve curve = through_points(fit).value();
            EXPECT_EQ(curve.knots().multiplicity(4.0), curve.degree());
            EXPECT_LT(distance(point_at(curve, 1.0), Point(1, 0)), 1e-14);
            EXPECT_LT(distance(point_at(curve, 8.0), Point(3, 3)), 1e-14);
            EXPECT_LT(distance(point_at(curve, 13.5), Point(0, 0.5)), 1e-14);
        }
}

TEST(ThroughPoints, a_line_goes_on_smoothly_but_from_a_corner) {
    const Point places[] = {{0, 0}, {2, 1}, {6, 1}, {8, -2}, {9, -2}};
    for (const FitKind kind : kinds) {
        FitPoints fit = set_fit_joint(fit_of(places, kind), 1, FitJoint::straight).value();
        Curve curve = through_points(fit).value();
        const auto [from, to] = std::pair(fit.parameters[1], fit.parameters[2]);
        EXPECT_LT(length(derivatives_at(curve, from, 1, Side::left)[1] - Vector(1, 0)), 1e-13);
        EXPECT_LT(length(derivatives_at(curve, to, 1, Side::right)[1] - Vector(1, 0)), 1e-13);
        EXPECT_LT(distance(point_at(curve, from + 1.0), Point(3, 1)), 1e-13);
        fit = set_fit_joint(fit, 1, FitJoint::corner_straight).value();
        curve = through_points(fit).value();
        EXPECT_GT(length(derivatives_at(curve, from, 1, Side::left)[1] - Vector(1, 0)), 0.1);
        EXPECT_LT(length(derivatives_at(curve, to, 1, Side::right)[1] - Vector(1, 0)), 1e-13);
    }
}

// The overshoot of a step: a local curve stays within its neighbors' rise, c2 rings on with a factor of sqrt(3) - 2.
TEST(ThroughPoints, a_step_rings_as_it_is_known_to) {
    std::vector<Point> places;
    for (int k = 0; k < 24; ++k) places.emplace_back(k, k < 12 ? 0.0 : 1.0);
    const auto height = [&](FitKind kind, double u) {
        return point_at(through_points(fit_of(places, kind, false, Parametrization::uniform)).value(), u).y;
    };
    EXPECT_NEAR(height(FitKind::c2, 14.5) - 1.0, (std::sqrt(3.0) - 2.0) * (height(FitKind::c2, 13.5) - 1.0), 1e-6);
    EXPECT_GT(height(FitKind::c2, 12.5), 1.05);
    EXPECT_EQ(height(FitKind::local, 13.5), 1.0);
    EXPECT_NEAR(height(FitKind::local, 12.5), 1.0625, 1e-14);  // 1 + 1/2 times 1/8
}

// Where only the joint beside a part changes, it keeps every bit.
TEST(ThroughPoints, corners_part_a_curve) {
    RandomCurves random(31);
    FitPoints fit = set_fit_joint(fit_of(random_places(random, 12), FitKind::c2), 6, FitJoint::corner).value();
    const Curve before = through_points(fit).value();
    fit.points[9].place += Vector(0.25, 0.5);
    const Curve after = through_points(fit).value();
    for (std::size_t i = 0; i <= 8; ++i) EXPECT_EQ(after.control_points()[i], before.control_points()[i]);
    EXPECT_NE(after.control_points()[10], before.control_points()[10]);
}

}  // namespace batten::core
