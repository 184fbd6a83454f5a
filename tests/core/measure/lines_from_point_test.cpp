#include "core/measure/lines_from_point.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/evaluate/evaluate.h"
#include "core/make/conics.h"
#include "core/make/shapes.h"
#include "core/measure/nearest.h"
#include "core/refine/degree.h"
#include "tests/core/golden.h"
#include "tests/core/random_curves.h"

namespace batten::core {
namespace {

/// y = x^2 with x = 4u - 2, moved by `offset`.
Curve parabola(Vector offset = {0, 0}) {
    return Curve::make({.degree = 2,
                        .knots = {0, 0, 0, 1, 1, 1},
                        .points = {Point(-2, 4) + offset, Point(0, -4) + offset, Point(2, 4) + offset}})
        .value();
}

void expect_places(const std::vector<CurveSample>& found, const std::vector<Point>& wanted, double tolerance) {
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_LE(distance(found[i].point, wanted[i]), tolerance) << found[i].point.x << ", " << found[i].point.y;
}

// The foot at x = a of the perpendicular from (x0, y0): a - x0 + 2a(a^2 - y0) = 0.
TEST(PerpendicularFeet, of_a_parabola) {
    expect_places(perpendicular_feet(parabola(), {0, 1.5}), {{-1, 1}, {0, 0}, {1, 1}}, 1e-14);
    expect_places(perpendicular_feet(parabola(), {3, 0}), {{1, 1}}, 1e-14);
    EXPECT_NEAR(perpendicular_feet(parabola(), {3, 0})[0].u, 0.75, 1e-14);
    expect_places(perpendicular_feet(parabola({1e6, -1e6}), {1e6 + 3, -1e6}), {{1e6 + 1, 1 - 1e6}}, 1e-9);
}

// The tangent at x = a passes (x0, y0) where a^2 - 2 a x0 + y0 = 0.
TEST(TangentPoints, of_a_parabola) {
    expect_places(tangent_points(parabola(), {1, -3}), {{-1, 1}}, 1e-14);
    const double root = std::sqrt(0.8125);
    expect_places(tangent_points(parabola(), {0.25, -0.75}),
                  {{0.25 - root, 0.875 - 0.5 * root}, {0.25 + root, 0.875 + 0.5 * root}}, 1e-14);
    EXPECT_TRUE(tangent_points(parabola(), {0, 1}).empty());
    expect_places(tangent_points(parabola({1e6, 1e6}), {1e6 + 1, 1e6 - 3}), {{1e6 - 1, 1e6 + 1}}, 1e-9);
}

TEST(LinesFromPoint, to_a_circle) {
    const Curve circle = core::circle({0, 0}, 1.0).value();
    expect_places(perpendicular_feet(circle, {0, -3}), {{0, 1}, {0, -1}}, 1e-14);
    expect_places(tangent_points(circle, {0, 2}), {{std::sqrt(0.75), 0.5}, {-std::sqrt(0.75), 0.5}}, 1e-14);
    EXPECT_TRUE(tangent_points(circle, {0.5, 0.2}).empty());
    EXPECT_TRUE(perpendicular_feet(circle, {0, 0}).empty());
}

TEST(LinesFromPoint, to_a_line_of_any_degree) {
    Curve line = core::line({0, 0}, {4, 0}).value();
    for (int degree = 1; degree <= 25; degree += 8) {
        if (degree > 1) line = elevate_degree(line, 8).value();
        expect_places(perpendicular_feet(line, {3, 7}), {{3, 0}}, 1e-13);
        EXPECT_TRUE(perpendicular_feet(line, {5, 7}).empty());
        EXPECT_TRUE(tangent_points(line, {3, 7}).empty());
        EXPECT_TRUE(tangent_points(line, {9, 0}).empty());  // all of it
    }
}

// Corners and ends aside, the nearest place is the foot of a perpendicular.
TEST(LinesFromPoint, are_what_they_say_on_any_curve) {
    RandomCurves random(77);
    for (int i = 0; i < 200; ++i) {
        const Curve curve = random.curve();
        const double size = 1e-3 + golden::largest_coordinate(curve.control_points());
        const double x = random.number(-size, size);
        const Point from(x, random.number(-size, size));
        for (const CurveSample& foot : perpendicular_feet(curve, from)) {
            const Vector tangent = derivatives_at(curve, foot.u, 1)[1];
            EXPECT_NEAR(dot(foot.point - from, tangent), 0.0, 1e-9 * size * (size + length(tangent)));
        }
        for (const CurveSample& touch : tangent_points(curve, from)) {
            const Vector tangent = derivatives_at(curve, touch.u, 1)[1];
            EXPECT_NEAR(cross(touch.point - from, tangent), 0.0, 1e-9 * size * (size + length(tangent)));
        }
        const CurveSample nearest = nearest_point(curve, from);
        const auto stored = curve.knots().stored();
        const bool is_at_knot = std::ranges::any_of(
            stored, [&](double u) { return std::abs(u - nearest.u) < 1e-6 * curve.domain().length(); });
        if (is_at_knot) continue;
        EXPECT_TRUE(std::ranges::any_of(perpendicular_feet(curve, from), [&](const CurveSample& foot) {
            return distance(foot.point, nearest.point) <= 1e-6 * size;
        }));
    }
}

}  // namespace
}  // namespace batten::core
