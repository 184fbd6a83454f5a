#include "core/bounds.h"

#include <gtest/gtest.h>

#include "core/evaluate.h"
#include "random_curves.h"

namespace batten::core {
namespace {

double cross(Point a, Point b, Point c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
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
        box.lower -= 1e-14 * 8.0;
        box.upper += 1e-14 * 8.0;
        for (int k = 0; k < 20; ++k) EXPECT_TRUE(box.contains(point_at(curve, random.parameter(curve))));
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

}  // namespace
}  // namespace batten::core
