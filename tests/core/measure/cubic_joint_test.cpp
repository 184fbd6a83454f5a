#include "core/measure/cubic_joint.h"

#include <gtest/gtest.h>

#include "core/evaluate/evaluate.h"
#include "tests/core/uniform_curves.h"

namespace batten::core {

namespace {

// The middle joint of five vertices, at u = 1.
Curve around(Point before, Point vertex, Point after) {
    return open_curve(3, {{-7, 3}, before, vertex, after, {31, -5}});
}

void expect_joint(Point before, Point vertex, Point after, CubicJointCase expected, Point joint, Vector tangent,
                  Vector second) {
    const Curve curve = around(before, vertex, after);
    EXPECT_EQ(case_of(anticentroid(curve, 2)), expected);
    const Jet jet = derivatives_at(curve, 1.0, 2);
    EXPECT_LE(distance(jet.point, joint), 1e-14);
    EXPECT_LE(length(jet[1] - tangent), 1e-14);
    EXPECT_LE(length(jet[2] - second), 1e-14);
}

}  // namespace

TEST(CubicJoint, tells_what_three_vertices_are_to_each_other) {
    using enum CubicJointCase;
    expect_joint({0, 0}, {6, 12}, {12, 6}, triangle, {6, 9}, {6, 3}, {0, -18});
    expect_joint({0, 0}, {6, 12}, {9, 18}, collinear, {5.5, 11}, {4.5, 9}, {-3, -6});
    expect_joint({0, 0}, {6, 12}, {12, 24}, centered, {6, 12}, {6, 12}, {0, 0});
    expect_joint({0, 0}, {6, 12}, {6, 12}, doubled, {5, 10}, {3, 6}, {-6, -12});
    expect_joint({6, 12}, {6, 12}, {0, 0}, doubled, {5, 10}, {-3, -6}, {-6, -12});
    expect_joint({0, 0}, {6, 12}, {0, 0}, folded, {4, 8}, {0, 0}, {-12, -24});
    expect_joint({6, 12}, {6, 12}, {6, 12}, tripled, {6, 12}, {0, 0}, {0, 0});
}

TEST(CubicJoint, forgives_rounding_alone) {
    using enum CubicJointCase;
    const Vector far(1e6, -1e6);
    const auto moved = [&](Point a, Point b, Point c) { return case_of(anticentroid_of(a + far, b + far, c + far)); };
    EXPECT_EQ(moved({0.1, 0.2}, {0.3, 0.6}, {0.4, 0.8}), collinear);
    EXPECT_EQ(moved({0.1, 0.2}, {0.25, 0.5}, {0.4, 0.8}), centered);
    EXPECT_EQ(moved({0.1, 0.2}, {0.3, 0.6}, {0.4, 0.8001}), triangle);
    EXPECT_EQ(case_of(anticentroid_of({0, 0}, {1, 1e-9}, {3, 0})), triangle);
    EXPECT_EQ(case_of(anticentroid_of({0, 0}, {1e-9, 0}, {0, 3})), triangle);
    EXPECT_EQ(case_of(anticentroid_of({0, 0}, {1e-200, 0}, {3e-200, 0})), collinear);
}

TEST(CubicJoint, four_vertices_on_a_line_make_a_straight_segment) {
    const Curve curve = open_curve(3, {{0, 0}, {1, 2}, {4, 8}, {2, 4}, {3, 3}});
    EXPECT_TRUE(is_straight_segment(curve, 0));
    EXPECT_FALSE(is_straight_segment(curve, 1));
    // Of a triple vertex both neighbors are straight, and of a ring also those past the seam.
    const Curve ring = closed_curve(3, {{0, 0}, {0, 0}, {6, 1}, {7, 7}, {0, 0}});
    EXPECT_TRUE(is_straight_segment(ring, 3));
    EXPECT_TRUE(is_straight_segment(ring, 4));
    EXPECT_FALSE(is_straight_segment(ring, 0));
    EXPECT_FALSE(is_straight_segment(ring, 2));
}

TEST(CubicMeeting, three_common_vertices_join_with_c2) {
    const Curve first = open_curve(3, {{0, 0}, {6, 18}, {24, 18}, {30, -6}, {42, 12}});
    const Curve second = open_curve(3, {{24, 18}, {30, -6}, {42, 12}, {60, 0}});
    const CubicMeeting meeting = meeting_of_cubics(first, second);
    EXPECT_EQ(meeting.first.index, 3u);
    EXPECT_EQ(meeting.second.index, 1u);
    EXPECT_EQ(meeting.first.anticentroid, Point(31, 1));
    EXPECT_EQ(meeting.second.anticentroid, Point(31, 1));
    EXPECT_EQ(meeting.continuity, 2);
    EXPECT_TRUE(meeting.has_equal_steps);
    const Jet before = derivatives_at(first, 2.0, 2, Side::left);
    const Jet after = derivatives_at(second, 0.0, 2);
    for (std::size_t r = 1; r <= 2; ++r) EXPECT_LE(length(before[r] - after[r]), 1e-13);
    CurveDefinition slow = second.definition();
    for (double& knot : slow.knots) knot *= 2.0;
    EXPECT_FALSE(meeting_of_cubics(first, Curve::make(slow).value()).has_equal_steps);
}

TEST(CubicMeeting, fewer_equations_join_less_smoothly) {
    const Curve first = open_curve(3, {{9, 9}, {0, 0}, {6, 12}, {12, 0}});
    const auto with = [&](Point a, Point b, Point c) {
        return meeting_of_cubics(first, open_curve(3, {a, b, c, {30, 30}})).continuity;
    };
    EXPECT_EQ(with({0, 0}, {6, 12}, {12, 0}), 2);
    // V0 + 4 V1 + V2 and V2 - V0 as before, V0 - 2 V1 + V2 not.
    EXPECT_EQ(with({-2, 2}, {7, 11}, {10, 2}), 1);
    EXPECT_EQ(with({4, 2}, {6, 11}, {8, 2}), 0);
    EXPECT_EQ(with({0, 0}, {6, 12}, {12, 1}), -1);
}

}  // namespace batten::core
