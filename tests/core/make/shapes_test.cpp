#include "core/make/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/evaluate/evaluate.h"

namespace batten::core {

TEST(Shapes, line_runs_evenly_from_end_to_end) {
    const Curve curve = line({1, 2}, {5, -2}).value();
    EXPECT_EQ(curve.degree(), 1);
    EXPECT_EQ(curve.domain(), (Interval{0, 1}));
    EXPECT_EQ(point_at(curve, 0.25), Point(2, 1));
}

TEST(Shapes, polyline_has_a_leg_for_each_unit_of_the_parameter) {
    const std::vector<Point> points{{0, 0}, {2, 0}, {2, 4}};
    const Curve open = polyline(points).value();
    EXPECT_EQ(open.domain(), (Interval{0, 2}));
    EXPECT_EQ(point_at(open, 1.5), Point(2, 2));
    EXPECT_EQ(open.knots().kind(), KnotKind::clamped_uniform);

    const Curve closed = polyline(points, true).value();
    EXPECT_TRUE(closed.is_periodic());
    EXPECT_EQ(closed.domain(), (Interval{0, 3}));
    EXPECT_EQ(point_at(closed, 0), Point(0, 0));
    EXPECT_EQ(point_at(closed, 1), Point(2, 0));
    EXPECT_EQ(point_at(closed, 2.5), Point(1, 2));
}

TEST(Shapes, regular_polygon_has_its_corners_on_the_circle) {
    const Curve hexagon = regular_polygon({1, 1}, 2.0, 6).value();
    ASSERT_EQ(hexagon.control_points().size(), 6u);
    EXPECT_EQ(hexagon.control_points()[0], Point(1, 3));
    EXPECT_EQ(hexagon.control_points()[3], Point(1, -1));
    // Counter-clockwise.
    EXPECT_NEAR(hexagon.control_points()[1].x, 1 - std::sqrt(3.0), 1e-15);
    EXPECT_EQ(hexagon.control_points()[1].y, 2);
    const Curve square = regular_polygon({0, 0}, 1.0, 4, 0.0).value();
    EXPECT_TRUE(std::ranges::equal(square.control_points(), std::vector<Point>{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}));
}

TEST(Shapes, refuse_what_is_degenerate) {
    using Code = CurveErrorCode;
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(line({1, 1}, {1, 1}).error(), (CurveError{.code = Code::points_coincide, .index = 1, .value = 0}));
    EXPECT_EQ(line({1, 1}, {1, infinity}).error().code, Code::point_not_finite);
    EXPECT_EQ(polyline(std::vector<Point>{{0, 0}}).error().code, Code::too_few_points);
    EXPECT_EQ(polyline(std::vector<Point>{{0, 0}, {1, 0}}, true).error(),
              (CurveError{.code = Code::too_few_points, .value = 2, .lower = 3}));
    const std::vector<Point> triangle{{0, 0}, {1, 0}, {0, 0}};
    EXPECT_TRUE(polyline(triangle).has_value());
    EXPECT_EQ(polyline(triangle, true).error(), (CurveError{.code = Code::points_coincide, .index = 2, .value = 0}));
    EXPECT_EQ(regular_polygon({0, 0}, 1.0, 2).error().code, Code::too_few_points);
    EXPECT_EQ(regular_polygon({0, 0}, -1.0, 5).error(), (CurveError{.code = Code::length_not_positive, .value = -1.0}));
    EXPECT_EQ(regular_polygon({1e20, 0}, 1.0, 5).error().code, Code::points_coincide);
}

TEST(Shapes, bezier_paths_are_their_pieces) {
    const Point open[] = {{0, 0}, {1, 1}, {2, 1}, {3, 0}, {4, -1}, {5, -1}, {6, 0}};
    const Curve path = bezier_path(open).value();
    EXPECT_EQ(path.knots().kind(), KnotKind::piecewise_bezier);
    EXPECT_EQ(path.domain(), (Interval{0.0, 2.0}));
    EXPECT_EQ(point_at(path, 1.5), Point(4.5, -0.75));
    const Point ring[] = {{0, 0}, {1, 1}, {2, 1}, {4, 0}, {3, -3}, {0, -3}};
    const Curve closed = bezier_path(ring, true).value();
    EXPECT_EQ(closed.knots().multiplicity(1.0), 3);
    EXPECT_EQ(point_at(closed, 0.5), Point(13.0 / 8.0, 6.0 / 8.0));
    EXPECT_EQ(point_at(closed, 1.5), Point(13.0 / 8.0, -18.0 / 8.0));
    EXPECT_EQ(derivatives_at(closed, 0.0, 1)[1], Vector(3, 3));
    const Point loop[] = {{0, 0}, {3, 0}, {0, 3}};
    EXPECT_EQ(point_at(bezier_path(loop, true).value(), 0.5), Point(9.0 / 8.0, 9.0 / 8.0));
    for (const std::size_t count : {0U, 1U, 2U, 3U, 5U, 6U})
        EXPECT_EQ(bezier_path(std::span(open).first(count)).error().code, CurveErrorCode::kind_not_possible);
    EXPECT_EQ(bezier_path(open, true).error().code, CurveErrorCode::kind_not_possible);
}

}  // namespace batten::core
