#include "core/edit/end_vertices.h"

#include <gtest/gtest.h>

#include "core/evaluate/evaluate.h"

namespace batten::core {

namespace {

Curve sample(std::vector<double> weights = {}, Point start = {}) {
    return Curve::make({.degree = 3,
                        .knots = {-3, -2, -1, 0, 1, 2, 3, 4, 5},
                        .points = {start, start + Vector(6, 18), start + Vector(24, 18), start + Vector(30, -6),
                                   start + Vector(42, 12)},
                        .weights = std::move(weights),
                        .kind = KnotKind::uniform})
        .value();
}

void expect_close(Vector found, Vector expected, double tolerance = 1e-14) {
    EXPECT_LE(length(found - expected), tolerance)
        << found.x << ' ' << found.y << " instead of " << expected.x << ' ' << expected.y;
}

void expect_close(Point found, Point expected, double tolerance = 1e-14) {
    expect_close(vector_to(found), vector_to(expected), tolerance);
}

// The old part of the curve is bit-equal.
void expect_kept(const Curve& before, const Curve& after) {
    for (const double u : {0.0, 0.4, 1.0, 1.9, 2.0}) EXPECT_EQ(point_at(after, u), point_at(before, u)) << u;
    EXPECT_EQ(after.knots().kind(), KnotKind::uniform);
}

}  // namespace

TEST(EndVertices, doubled_begins_a_sixth_along_the_first_leg_without_curvature) {
    const Curve curve = add_end_vertex(sample(), CurveEnd::start, EndVertex::doubled).value();
    EXPECT_EQ(curve.domain(), (Interval{-1, 2}));
    const auto start = derivatives_at(curve, -1.0, 2);
    expect_close(start.point, {1, 3});
    expect_close(start[1], {3, 9});
    EXPECT_NEAR(curvature_at(curve, -1.0).value(), 0.0, 1e-14);
    expect_kept(sample(), curve);
    // Unequal weights: the share is w1 / (5 w0 + w1) = 5 / 15.
    const Curve rational = add_end_vertex(sample({2, 5, 1, 1, 1}), CurveEnd::start, EndVertex::doubled).value();
    expect_close(point_at(rational, -1.0), {2, 6});
}

TEST(EndVertices, tripled_begins_in_the_point_and_is_straight_over_a_span) {
    const Curve curve = add_end_vertex(sample(), CurveEnd::start, EndVertex::tripled).value();
    EXPECT_EQ(curve.domain(), (Interval{-2, 2}));
    const auto start = derivatives_at(curve, -2.0, 1);
    expect_close(start.point, {0, 0});
    expect_close(start[1], {0, 0});
    expect_close(point_at(curve, -1.0), {1, 3});
    // t^3 / 6 of the leg.
    expect_close(point_at(curve, -1.5), {0.125, 0.375});
    expect_kept(sample(), curve);
}

TEST(EndVertices, phantom_begins_in_the_point_without_second_derivative) {
    const Curve curve = add_end_vertex(sample(), CurveEnd::start, EndVertex::phantom).value();
    EXPECT_EQ(curve.control_points()[0], Point(-6, -18));
    const auto start = derivatives_at(curve, -1.0, 2);
    expect_close(start.point, {0, 0});
    expect_close(start[1], {6, 18});
    expect_close(start[2], {0, 0});
    expect_kept(sample(), curve);
    const Curve rational = add_end_vertex(sample({2, 5, 1, 1, 1}), CurveEnd::start, EndVertex::phantom).value();
    const auto rational_start = derivatives_at(rational, -1.0, 2);
    expect_close(rational_start.point, {0, 0});
    expect_close(rational_start[2], {0, 0}, 1e-13);
    EXPECT_GT(length(rational_start[1]), 1.0);
}

TEST(EndVertices, act_at_the_other_end_likewise) {
    const Curve phantom = add_end_vertex(sample(), CurveEnd::end, EndVertex::phantom).value();
    EXPECT_EQ(phantom.domain(), (Interval{0, 3}));
    EXPECT_EQ(phantom.control_points().back(), Point(54, 30));
    const auto end = derivatives_at(phantom, 3.0, 2, Side::left);
    expect_close(end.point, {42, 12});
    expect_close(end[1], {12, 18});
    expect_close(end[2], {0, 0}, 1e-13);
    expect_kept(sample(), phantom);
    const Curve doubled = add_end_vertex(sample(), CurveEnd::end, EndVertex::doubled).value();
    expect_close(point_at(doubled, 3.0), {40, 9});
    const Curve tripled = add_end_vertex(sample(), CurveEnd::end, EndVertex::tripled).value();
    expect_close(point_at(tripled, 4.0), {42, 12});
}

TEST(EndVertices, work_far_from_the_origin) {
    const Point offset(1048576, -1048576);
    const Curve curve = add_end_vertex(sample({}, offset), CurveEnd::start, EndVertex::phantom).value();
    EXPECT_EQ(point_at(curve, -1.0), offset);
    expect_close(derivatives_at(curve, -1.0, 2)[2], {0, 0}, 1e-9);
}

TEST(EndVertices, are_refused_where_the_curve_is_not_a_uniform_cubic) {
    const auto clamped =
        Curve::make({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{0, 0}, {1, 1}, {2, 1}, {3, 0}}})
            .value();
    const auto periodic =
        Curve::make(
            {.degree = 3, .knots = {0, 1, 2, 3, 4}, .points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, .periodic = true})
            .value();
    for (const Curve& curve : {clamped, periodic}) {
        EXPECT_EQ(add_end_vertex(curve, CurveEnd::start, EndVertex::doubled).error().code,
                  CurveErrorCode::curve_not_uniform_cubic);
        EXPECT_EQ(share_end_vertices(sample(), CurveEnd::start, curve).error().code,
                  CurveErrorCode::curve_not_uniform_cubic);
        EXPECT_EQ(share_end_vertices(curve, CurveEnd::start, sample()).error().code,
                  CurveErrorCode::curve_not_uniform_cubic);
    }
}

TEST(EndVertices, the_joint_is_told_without_making_the_curve) {
    const std::array vertices{EndVertex::doubled, EndVertex::tripled, EndVertex::phantom};
    for (const CurveEnd end : {CurveEnd::start, CurveEnd::end}) {
        const bool is_start = end == CurveEnd::start;
        const auto expect_joint = [&](const Anticentroid& joint, const Curve& made) {
            const double u = is_start ? made.domain().lower : made.domain().upper;
            const Jet jet = derivatives_at(made, u, 2, is_start ? Side::right : Side::left);
            expect_close(joint.anticentroid, jet.point, 1e-13);
            expect_close(joint.tangent, jet[1], 1e-13);
            expect_close(joint.second_derivative, jet[2], 1e-13);
        };
        const Anticentroid plain = end_joint(sample(), end);
        EXPECT_EQ(plain.index, is_start ? 1u : 3u);
        EXPECT_EQ(plain.u, is_start ? 0.0 : 2.0);
        expect_joint(plain, sample());
        for (const EndVertex vertex : vertices)
            expect_joint(end_joint(sample(), end, vertex), add_end_vertex(sample(), end, vertex).value());
    }
    // 2 P0 - P1 is the third corner of the triangle.
    EXPECT_EQ(end_joint(sample(), CurveEnd::start, EndVertex::phantom).before, Point(-6, -18));
    EXPECT_EQ(end_joint(sample(), CurveEnd::end, EndVertex::doubled).after, Point(42, 12));
}

TEST(EndVertices, shared_ones_join_with_c2) {
    const Curve other = Curve::make({.degree = 3,
                                     .knots = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9},
                                     .points = {{0, 0}, {9, 9}, {1, 8}, {2, 7}, {5, 3}, {7, -4}}})
                            .value();
    const Curve after = share_end_vertices(sample(), CurveEnd::start, other).value();
    EXPECT_EQ(std::vector(after.control_points().begin(), after.control_points().end()),
              (std::vector<Point>{{2, 7}, {5, 3}, {7, -4}, {30, -6}, {42, 12}}));
    const Jet left = derivatives_at(other, 6.0, 2, Side::left);
    const Jet right = derivatives_at(after, 0.0, 2);
    expect_close(right.point, left.point);
    for (std::size_t r = 1; r <= 2; ++r) expect_close(right[r], left[r], 1e-13);
    const Curve before = share_end_vertices(sample(), CurveEnd::end, other).value();
    EXPECT_EQ(std::vector(before.control_points().begin(), before.control_points().end()),
              (std::vector<Point>{{0, 0}, {6, 18}, {0, 0}, {9, 9}, {1, 8}}));
    EXPECT_EQ(share_end_vertices(sample({1, 2, 1, 1, 1}), CurveEnd::end, other).error().code,
              CurveErrorCode::curve_rational);
    EXPECT_EQ(share_end_vertices(other, CurveEnd::end, sample({1, 2, 1, 1, 1})).error().code,
              CurveErrorCode::curve_rational);
}

}  // namespace batten::core
