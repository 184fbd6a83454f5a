#include "core/measure/area.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "core/evaluate/evaluate.h"
#include "core/refine/degree.h"
#include "tests/core/known_curves.h"
#include "tests/core/random_curves.h"

namespace batten::core {
namespace {

using std::numbers::pi;

Curve triangle() {
    return Curve::make({.degree = 1, .knots = {0, 0, 1, 2, 3, 3}, .points = {{0, 0}, {6, 0}, {0, 3}, {0, 0}}}).value();
}

TEST(Area, of_triangle_and_ellipse) {
    const Area flat = enclosed_area(triangle()).value();
    EXPECT_NEAR(flat.signed_area, 9.0, 1e-14);
    EXPECT_NEAR(flat.centroid->x, 2.0, 1e-14);
    EXPECT_NEAR(flat.centroid->y, 1.0, 1e-14);
    const Area round = enclosed_area(moved(ellipse(3, 2), {5, -7})).value();
    EXPECT_NEAR(round.signed_area, 6 * pi, 1e-13);
    EXPECT_NEAR(round.centroid->x, 5.0, 1e-14);
    EXPECT_NEAR(round.centroid->y, -7.0, 1e-14);
}

TEST(Area, of_a_half_disc_and_its_centroid) {
    const double w = std::sqrt(0.5);
    const Curve half = Curve::make({.degree = 2,
                                    .knots = {0, 0, 0, 1, 1, 2, 2, 3, 3, 3},
                                    .points = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {0, 0}, {1, 0}},
                                    .weights = {1, w, 1, w, 1, 1, 1}})
                           .value();
    for (const Curve& curve : {half, moved(half, {1e6, 1e6})}) {
        const Area area = enclosed_area(curve).value();
        const bool is_far = curve.control_points()[0].x > 1e3;
        EXPECT_NEAR(area.signed_area, pi / 2, is_far ? 1e-9 : 1e-15);
        EXPECT_NEAR(area.centroid->x, is_far ? 1e6 : 0.0, is_far ? 1e-9 : 1e-15);
        EXPECT_NEAR(area.centroid->y, 4 / (3 * pi) + (is_far ? 1e6 : 0.0), is_far ? 1e-9 : 1e-15);
    }
}

// Weights (1, w c, c^2) of an arc give the same arc at other parameters.
TEST(Area, does_not_depend_on_how_far_apart_the_weights_are) {
    const double w = std::sqrt(0.5);
    for (const auto& [c, d, e] : {std::tuple(30.0, 1e-3, 0.5), {1e3, 1e-5, 30.0}, {1e-8, 1e12, 1e6}}) {
        const double q = c * c * d * d;
        const Curve half = Curve::make({.degree = 2,
                                        .knots = {0, 0, 0, 1, 1, 2, 2, 3, 3, 3},
                                        .points = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {0, 0}, {1, 0}},
                                        .weights = {1, w * c, c * c, c * c * w * d, q, q * e, q * e * e}})
                               .value();
        const Area area = enclosed_area(half).value();
        EXPECT_NEAR(area.signed_area, pi / 2, 1e-13) << c;
        EXPECT_NEAR(area.centroid->x, 0.0, 1e-13) << c;
        EXPECT_NEAR(area.centroid->y, 4 / (3 * pi), 1e-13) << c;
        EXPECT_LE(std::abs(area.signed_area - pi / 2), area.error) << c;
    }
}

TEST(Area, of_a_parabola_segment_in_every_degree) {
    // y = x (2 - x) and the chord back: area 4/3, centroid (1, 2/5).
    const Curve segment =
        Curve::make(
            {.degree = 2, .knots = {0, 0, 0, 1, 1, 2, 2, 2}, .points = {{2, 0}, {1, 2}, {0, 0}, {1, 0}, {2, 0}}})
            .value();
    for (const int by : {0, 1, 8, 23}) {
        const Area area = enclosed_area(by == 0 ? segment : elevate_degree(segment, by).value()).value();
        EXPECT_NEAR(area.signed_area, 4.0 / 3.0, 1e-12);
        EXPECT_NEAR(area.centroid->x, 1.0, 1e-12);
        EXPECT_NEAR(area.centroid->y, 0.4, 1e-12);
    }
}

TEST(Area, clockwise_is_negative_and_a_figure_8_has_no_centroid) {
    CurveDefinition reversed = triangle().definition();
    std::reverse(reversed.points.begin(), reversed.points.end());
    const Area area = enclosed_area(Curve::make(reversed).value()).value();
    EXPECT_NEAR(area.signed_area, -9.0, 1e-14);
    EXPECT_NEAR(area.centroid->x, 2.0, 1e-14);
    const Curve eight =
        Curve::make({.degree = 1, .knots = {0, 0, 1, 2, 3, 4, 4}, .points = {{0, 0}, {2, 2}, {2, 0}, {0, 2}, {0, 0}}})
            .value();
    EXPECT_NEAR(enclosed_area(eight)->signed_area, 0.0, 1e-15);
    EXPECT_FALSE(enclosed_area(eight)->centroid.has_value());
}

TEST(Area, agrees_with_a_fine_polygon) {
    RandomCurves random(331);
    for (int i = 0; i < 60; ++i) {
        const Curve curve = random.periodic_curve();
        const Interval domain = curve.domain();
        double doubled = 0.0;
        Point last = point_at(curve, domain.lower);
        for (int k = 1; k <= 2000; ++k) {
            const Point next = point_at(curve, domain.lower + domain.length() * k / 2000.0);
            doubled += cross(vector_to(last), vector_to(next));
            last = next;
        }
        EXPECT_NEAR(enclosed_area(curve)->signed_area, 0.5 * doubled, 0.1);
    }
}

TEST(Area, open_and_torn_curves_are_refused) {
    const Curve open =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {1, 1}, {2, 0}}}).value();
    EXPECT_EQ(enclosed_area(open).error().code, CurveErrorCode::curve_not_closed);
    const Curve torn = Curve::make({.degree = 1,
                                    .knots = {0, 0, 1, 1, 2, 2},
                                    .points = {{0, 0}, {1, 0}, {1, 3}, {0, 0}},
                                    .tears = Tears::allow})
                           .value();
    EXPECT_EQ(enclosed_area(torn).error().code, CurveErrorCode::curve_not_closed);
    const Curve point = Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {3, Point(1, 1)}}).value();
    EXPECT_EQ(enclosed_area(point)->signed_area, 0.0);
}

}  // namespace
}  // namespace batten::core
