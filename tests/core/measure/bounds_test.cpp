#include "core/measure/bounds.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"
#include "tests/core/random_curves.h"

namespace batten::core {
namespace {

double cross(Point a, Point b, Point c) {
    return cross(b - a, c - a);
}

TEST(Bounds, control_box_is_that_of_the_points) {
    const Curve curve =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{-1, 5}, {7, 2}, {3, -4}}}).value();
    EXPECT_EQ(control_box(curve).lower, Point(-1, -4));
    EXPECT_EQ(control_box(curve).upper, Point(7, 5));
}

TEST(Bounds, control_box_contains_the_curve) {
    RandomCurves random(41);
    for (int i = 0; i < 100; ++i) {
        const Curve curve = random.curve();
        Box box = control_box(curve);
        const Vector slack(1e-14 * 8.0, 1e-14 * 8.0);
        box.lower -= slack;
        box.upper += slack;
        for (int k = 0; k < 20; ++k) EXPECT_TRUE(box.contains(point_at(curve, random.parameter(curve))));
    }
}

TEST(Bounds, tight_box_of_a_parabola_and_of_an_ellipse) {
    // x = 2u(1-u) * 3 + u^2, greatest where x' = 6 - 10u vanishes: 9/5.
    const Curve arc =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {3, 1}, {1, 2}}}).value();
    EXPECT_EQ(tight_box(arc).lower, Point(0, 0));
    EXPECT_NEAR(tight_box(arc).upper.x, 1.8, 1e-15);
    EXPECT_EQ(tight_box(arc).upper.y, 2.0);
    const double root = std::sqrt(0.5);
    // The unit circle turned by 45 degrees, so that its extremes are inside the pieces.
    const Curve circle = Curve::make({.degree = 2,
                                      .knots = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4},
                                      .points = {{root, root},
                                                 {0, 2 * root},
                                                 {-root, root},
                                                 {-2 * root, 0},
                                                 {-root, -root},
                                                 {0, -2 * root},
                                                 {root, -root},
                                                 {2 * root, 0},
                                                 {root, root}},
                                      .weights = {1, root, 1, root, 1, root, 1, root, 1}})
                             .value();
    EXPECT_NEAR(tight_box(circle).lower.x, -1.0, 1e-15);
    EXPECT_NEAR(tight_box(circle).lower.y, -1.0, 1e-15);
    EXPECT_NEAR(tight_box(circle).upper.x, 1.0, 1e-15);
    EXPECT_NEAR(tight_box(circle).upper.y, 1.0, 1e-15);
}

TEST(Bounds, tight_box_contains_the_curve_and_touches_it_on_all_sides) {
    RandomCurves random(43);
    for (int i = 0; i < 200; ++i) {
        CurveDefinition definition = random.curve().definition();
        const bool is_far = i % 2 == 1;
        if (is_far)
            for (Point& point : definition.points) point += Vector(1e6, -2e6);
        const Curve curve = Curve::make(definition).value();
        const Box box = tight_box(curve);
        const double rounding = is_far ? 2e-9 : 2e-14;
        Box sampled;
        for (int k = 0; k <= 2000; ++k) {
            const double u = curve.domain().lower + curve.domain().length() * k / 2000.0;
            sampled.include(point_at(curve, u));
            sampled.include(point_at(curve, u, Side::left));
        }
        EXPECT_LE(box.lower.x, sampled.lower.x + rounding) << i;
        EXPECT_LE(box.lower.y, sampled.lower.y + rounding) << i;
        EXPECT_GE(box.upper.x, sampled.upper.x - rounding) << i;
        EXPECT_GE(box.upper.y, sampled.upper.y - rounding) << i;
        EXPECT_NEAR(box.lower.x, sampled.lower.x, 0.2) << i;
        EXPECT_NEAR(box.upper.y, sampled.upper.y, 0.2) << i;
    }
}

TEST(Bounds, tight_box_is_empty_where_numbers_overflow_on_the_way) {
    // C(1/2).x = -1e308 * 100 / 202 + ..., left of both ends, but 100 * 1e308 is no double.
    const Curve curve = Curve::make({.degree = 2,
                                     .knots = {0, 0, 0, 1, 1, 1},
                                     .points = {{0, 0}, {-1e308, 1}, {1e308, 0}},
                                     .weights = {1, 100, 1}})
                            .value();
    EXPECT_TRUE(tight_box(curve).is_empty());
}

TEST(Bounds, every_piece_lies_in_the_hull_of_its_span) {
    RandomCurves random(44);
    for (int i = 0; i < 60; ++i) {
        const Curve curve = random.curve();
        const auto hulls = span_hulls(curve);
        EXPECT_EQ(hulls.front().interval.lower, curve.domain().lower);
        EXPECT_EQ(hulls.back().interval.upper, curve.domain().upper);
        for (const SpanHull& span : hulls)
            for (int k = 0; k < 20; ++k) {
                const Point point = point_at(curve, span.interval.lower + span.interval.length() * k / 20.0);
                if (span.hull.size() < 3) continue;
                for (std::size_t j = 0; j < span.hull.size(); ++j)
                    EXPECT_GE(cross(span.hull[j], span.hull[(j + 1) % span.hull.size()], point), -1e-12);
            }
    }
}

TEST(Bounds, hull_of_a_square_is_counter_clockwise_and_leaves_out_the_rest) {
    const std::vector<Point> points{{2, 2}, {0, 0}, {1, 1}, {2, 0}, {1, 0}, {0, 2}, {0, 1}, {0, 0}, {1, 2}};
    const std::vector<Point> expected{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    EXPECT_EQ(convex_hull(points), expected);
}

TEST(Bounds, few_points_come_back) {
    const std::vector<Point> two{{3, 1}, {1, 2}};
    EXPECT_EQ(convex_hull(two), two);
    EXPECT_TRUE(convex_hull({}).empty());
}

TEST(Bounds, hull_of_collinear_points_is_their_ends) {
    const std::vector<Point> line{{1, 1}, {3, 3}, {0, 0}, {2, 2}, {3, 3}};
    const std::vector<Point> ends{{0, 0}, {3, 3}};
    EXPECT_EQ(convex_hull(line), ends);
    const std::vector<Point> same(4, Point(5, 6));
    EXPECT_EQ(convex_hull(same), std::vector<Point>{Point(5, 6)});
}

TEST(Bounds, hull_turns_left_everywhere_and_has_all_points_inside) {
    RandomCurves random(42);
    for (int i = 0; i < 50; ++i) {
        std::vector<Point> points;
        for (int k = 0; k < 30; ++k) {
            const double x = random.number(-5.0, 5.0);
            points.emplace_back(x, random.number(-5.0, 5.0));
        }
        const auto hull = convex_hull(points);
        ASSERT_GE(hull.size(), 3U);
        for (std::size_t k = 0; k < hull.size(); ++k) {
            const Point a = hull[k];
            const Point b = hull[(k + 1) % hull.size()];
            EXPECT_GT(cross(a, b, hull[(k + 2) % hull.size()]), 0.0);
            for (const Point& point : points) EXPECT_GE(cross(a, b, point), -1e-12);
        }
    }
}

TEST(Bounds, a_polygon_is_convex_or_not) {
    const auto at_scale = [](double factor, double shift, std::vector<Point> points) {
        for (Point& point : points) point = Point(factor * point.x + shift, factor * point.y);
        return is_convex(points);
    };
    for (const double factor : {1.0, -3.0, 1e-200, 1e150}) {
        EXPECT_TRUE(at_scale(factor, 0.0, {{0, 0}, {4, 0}, {4, 2}, {0, 3}}));
        EXPECT_TRUE(at_scale(factor, 0.0, {{0, 3}, {4, 2}, {4, 0}, {0, 0}})) << "run through the other way";
        EXPECT_TRUE(at_scale(factor, 0.0, {{0, 0}, {2, 0}, {4, 0}, {4, 0}, {4, 2}})) << "a point on an edge, one twice";
        EXPECT_FALSE(at_scale(factor, 0.0, {{0, 0}, {4, 0}, {1, 1}, {0, 3}})) << "a dent";
        EXPECT_FALSE(at_scale(factor, 0.0, {{0, 0}, {3, 3}, {3, 0}, {0, 3}})) << "it crosses itself";
        EXPECT_TRUE(at_scale(factor, 0.0, {{0, 0}, {1, 2}, {2, 4}})) << "there and back";
        EXPECT_FALSE(at_scale(factor, 0.0, {{0, 0}, {2, 4}, {1, 2}, {3, 6}})) << "there and back, twice";
    }
    EXPECT_TRUE(at_scale(1.0, 1e6, {{0, 0}, {4, 0}, {4, 2}, {0, 3}}));
    EXPECT_TRUE(is_convex({}));
    std::vector<Point> star;
    for (int k = 0; k < 5; ++k) star.emplace_back(std::cos(k * 2.4 * M_PI / 3.0), std::sin(k * 2.4 * M_PI / 3.0));
    EXPECT_FALSE(is_convex(star)) << "it always turns to the left, but goes around twice";
}

TEST(Bounds, a_polygon_may_turn_back_by_an_angle) {
    const std::vector<Point> dented{{0, 0}, {2, 1e-4}, {4, 0}, {4, 2}};
    EXPECT_FALSE(is_convex(dented));
    EXPECT_TRUE(is_convex(dented, 1.01e-4)) << "it turns by twice 1e-4 / 2 there";
}

}  // namespace
}  // namespace batten::core
