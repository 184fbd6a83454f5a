#include "core/edit/straighten.h"

#include <gtest/gtest.h>

#include "core/measure/collinear.h"
#include "tests/core/uniform_curves.h"

namespace batten::core {

TEST(Straighten, makes_a_straight_piece_between_two_points) {
    const Curve curve = open_curve(3, {{0, 0}, {1, 3}, {2, -1}, {4, 0}, {5, 5}});
    const Curve result = straighten(curve, 0, 3).value();
    EXPECT_EQ(result.control_points()[1], Point(1, 0));
    EXPECT_EQ(result.control_points()[2], Point(2, 0));
    EXPECT_EQ(result.control_points()[4], Point(5, 5));
    EXPECT_EQ(collinear_runs(result).front().straight, (Interval{0, 1}));
    EXPECT_EQ(straighten(curve, 3, 0)->control_points()[1], Point(1, 0));
    const Curve ring = closed_curve(2, {{0, 0}, {3, 1}, {3, 3}, {1, 3}});
    const Curve straight = straighten(ring, 3, 1).value();
    EXPECT_EQ(straight.control_points()[0], Point(2, 2));
    EXPECT_EQ(straight.control_points()[2], Point(3, 3));
}

TEST(Straighten, refuses_what_makes_no_line) {
    using Code = CurveErrorCode;
    const Curve curve = open_curve(2, {{0, 0}, {1, 3}, {0, 0}, {4, 0}});
    EXPECT_EQ(straighten(curve, 0, 2).error(), (CurveError{.code = Code::points_coincide, .index = 2, .value = 0}));
    EXPECT_EQ(straighten(curve, 0, 1).error(), (CurveError{.code = Code::too_few_points, .value = 2, .lower = 3}));
    EXPECT_EQ(straighten(curve, 0, 4).error().code, Code::point_index_out_of_range);
}

}  // namespace batten::core
