#include "core/evaluate/uniform_cubic.h"

#include <gtest/gtest.h>

#include "core/evaluate/evaluate.h"

namespace batten::core {

namespace {

Curve coons() {
    // Multiples of 6, so that sixths are whole numbers.
    return Curve::make({.degree = 3,
                        .knots = {-3, -2, -1, 0, 1, 2, 3, 4, 5},
                        .points = {{0, 0}, {6, 18}, {24, 18}, {30, -6}, {42, 12}},
                        .kind = KnotKind::uniform})
        .value();
}

Curve ring() {
    return Curve::make({.degree = 3,
                        .knots = {0, 2, 4, 6, 8},
                        .points = {{0, 0}, {12, 0}, {12, 12}, {0, 12}},
                        .periodic = true,
                        .kind = KnotKind::periodic})
        .value();
}

}  // namespace

TEST(UniformCubic, matrix_form_is_exact) {
    const auto segments = cubic_segments(coons()).value();
    ASSERT_EQ(segments.size(), 2u);
    EXPECT_EQ(segments[0].interval, (Interval{0, 1}));
    EXPECT_EQ(segments[1].first_point, 1u);
    // (P0 + 4 P1 + P2) / 6, (P2 - P0) / 2, (P0 - 2 P1 + P2) / 2, (-P0 + 3 P1 - 3 P2 + P3) / 6.
    EXPECT_EQ(segments[0].coefficients[0], HomogeneousPoint(8, 15, 1));
    EXPECT_EQ(segments[0].coefficients[1], HomogeneousPoint(12, 9, 0));
    EXPECT_EQ(segments[0].coefficients[2], HomogeneousPoint(6, -9, 0));
    EXPECT_EQ(segments[0].coefficients[3], HomogeneousPoint(-4, -1, 0));
}

TEST(UniformCubic, matrix_form_gives_the_points_of_rational_and_periodic_curves) {
    CurveDefinition definition = ring().definition();
    definition.weights = {1, 2, 3, 0.5};
    const Curve curve = Curve::make(std::move(definition)).value();
    const auto segments = cubic_segments(curve).value();
    ASSERT_EQ(segments.size(), 4u);
    for (const CubicSegment& segment : segments)
        for (const double t : {0.0, 0.3, 0.9}) {
            const auto& a = segment.coefficients;
            const Point point = project(a[0] + t * (a[1] + t * (a[2] + t * a[3])));
            const double u = segment.interval.lower + t * segment.interval.length();
            EXPECT_LE(distance(point, point_at(curve, u)), 1e-14);
        }
}

TEST(UniformCubic, one_weight_for_all_points_is_no_factor) {
    CurveDefinition definition = coons().definition();
    definition.weights.assign(5, 2.5);
    const auto segments = cubic_segments(Curve::make(std::move(definition)).value()).value();
    EXPECT_EQ(segments[0].coefficients[0], HomogeneousPoint(8, 15, 1));
    EXPECT_EQ(segments[0].coefficients[1], HomogeneousPoint(12, 9, 0));
    EXPECT_EQ(segments[0].coefficients[2], HomogeneousPoint(6, -9, 0));
    EXPECT_EQ(segments[0].coefficients[3], HomogeneousPoint(-4, -1, 0));
}

TEST(UniformCubic, ferguson_form_and_back) {
    const auto segments = ferguson_segments(coons()).value();
    ASSERT_EQ(segments.size(), 2u);
    EXPECT_EQ(segments[0].start, Point(8, 15));
    EXPECT_EQ(segments[0].end, Point(22, 14));
    EXPECT_EQ(segments[0].start_tangent, Vector(12, 9));
    EXPECT_EQ(segments[0].end_tangent, Vector(12, -12));
    EXPECT_EQ(segments[1].start, segments[0].end);
    const auto points = uniform_control_points(segments[1]);
    for (std::size_t j = 0; j < 4; ++j) EXPECT_LE(distance(points[j], coons().control_points()[j + 1]), 1e-13) << j;
    const Curve again = curve_from_ferguson(segments).value();
    EXPECT_EQ(again.domain(), coons().domain());
    for (const double u : {0.0, 0.25, 1.0, 1.7, 2.0})
        EXPECT_LE(distance(point_at(again, u), point_at(coons(), u)), 1e-14);
    EXPECT_EQ(curve_from_ferguson({}).error().code, CurveErrorCode::too_few_points);
}

TEST(UniformCubic, anticentroids_are_the_joints) {
    const auto joints = anticentroids(coons()).value();
    ASSERT_EQ(joints.size(), 3u);
    EXPECT_EQ(joints[0].index, 1u);
    EXPECT_EQ(joints[0].u, 0.0);
    EXPECT_EQ(joints[0].vertex, Point(6, 18));
    EXPECT_EQ(joints[0].base_middle, Point(12, 9));
    EXPECT_EQ(joints[0].anticentroid, Point(8, 15));
    EXPECT_EQ(joints[0].tangent, Vector(12, 9));
    EXPECT_EQ(joints[0].second_derivative, Vector(12, -18));
    const auto derivatives = derivatives_at(coons(), 0.0, 2);
    EXPECT_LE(length(joints[0].tangent - derivatives[1]), 1e-14);
    EXPECT_LE(length(joints[0].second_derivative - derivatives[2]), 1e-14);

    const auto around = anticentroids(ring()).value();
    ASSERT_EQ(around.size(), 4u);
    for (const Anticentroid& joint : around) {
        EXPECT_LE(distance(joint.anticentroid, point_at(ring(), joint.u)), 1e-14) << joint.index;
        // Knot steps of 2.
        EXPECT_LE(length(joint.tangent - 2.0 * derivatives_at(ring(), joint.u, 1)[1]), 1e-14) << joint.index;
    }
}

TEST(UniformCubic, gives_one_segment_or_joint_by_itself) {
    EXPECT_EQ(cubic_segment_count(coons()), 2u);
    EXPECT_EQ(cubic_segment_index(coons(), 0.0), 0u);
    EXPECT_EQ(cubic_segment_index(coons(), 1.0), 1u);
    EXPECT_EQ(cubic_segment_index(coons(), 2.0), 1u);
    // (P1 + 4 P2 + P3) / 6 and so on.
    EXPECT_EQ(cubic_segment(coons(), 1).coefficients[0], HomogeneousPoint(22, 14, 1));
    EXPECT_EQ(cubic_segment(coons(), 1).interval, (Interval{1, 2}));
    EXPECT_EQ(ferguson_segment(coons(), 1).end_tangent, Vector(9, -3));
    const Anticentroid joint = anticentroid(coons(), 2);
    EXPECT_EQ(joint.index, 2u);
    EXPECT_EQ(joint.u, 1.0);
    EXPECT_EQ(joint.before, Point(6, 18));
    EXPECT_EQ(joint.after, Point(30, -6));
    EXPECT_EQ(joint.anticentroid, Point(22, 14));
}

TEST(UniformCubic, counts_on_past_the_seam) {
    EXPECT_EQ(cubic_segment_count(ring()), 4u);
    EXPECT_EQ(cubic_segment_index(ring(), 7.0), 3u);
    EXPECT_EQ(cubic_segment_index(ring(), 8.5), 0u);
    // The last segment has the points 3, 0, 1, 2: it begins at (P3 + 4 P0 + P1) / 6.
    const FergusonSegment last = ferguson_segment(ring(), 3);
    EXPECT_EQ(last.interval, (Interval{6, 8}));
    EXPECT_EQ(last.start, Point(2, 2));
    EXPECT_EQ(last.end, Point(10, 2));
    EXPECT_EQ(last.start_tangent, Vector(6, -6));
    const Anticentroid seam = anticentroid(ring(), 4);
    EXPECT_EQ(seam.index, 0u);
    EXPECT_EQ(seam.anticentroid, Point(2, 2));
    EXPECT_EQ(seam.u, 6.0);
}

TEST(UniformCubic, the_anticentroid_of_three_points_needs_no_curve) {
    const Anticentroid joint = anticentroid_of({0, 0}, {3, 9}, {12, 0});
    EXPECT_EQ(joint.base_middle, Point(6, 0));
    EXPECT_EQ(joint.anticentroid, Point(4, 6));
    EXPECT_EQ(joint.tangent, Vector(6, 0));
    EXPECT_EQ(joint.second_derivative, Vector(6, -18));
    // Far from the origin, where equal points give themselves.
    const Point far(1e6 + 0.1, -1e6 - 0.3);
    EXPECT_EQ(anticentroid_of(far, far, far).anticentroid, far);
}

TEST(UniformCubic, refuses_other_curves) {
    using Code = CurveErrorCode;
    CurveDefinition clamped = coons().definition();
    clamped.knots = {0, 0, 0, 0, 1, 2, 2, 2, 2};
    EXPECT_EQ(cubic_segments(Curve::make(clamped).value()).error().code, Code::curve_not_uniform_cubic);
    const auto quadratic =
        Curve::make({.degree = 2, .knots = {0, 1, 2, 3, 4, 5}, .points = {{0, 0}, {1, 1}, {2, 0}}}).value();
    EXPECT_EQ(anticentroids(quadratic).error().code, Code::curve_not_uniform_cubic);
    CurveDefinition rational = coons().definition();
    rational.weights = {1, 2, 1, 1, 1};
    EXPECT_EQ(ferguson_segments(Curve::make(rational).value()).error().code, Code::curve_rational);
    EXPECT_EQ(anticentroids(Curve::make(rational).value()).error().code, Code::curve_rational);
}

}  // namespace batten::core
