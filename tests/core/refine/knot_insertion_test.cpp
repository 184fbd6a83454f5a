#include "core/refine/knot_insertion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/curve/knot_analysis.h"
#include "core/evaluate/evaluate.h"
#include "tests/core/lecture_cubic.h"
#include "tests/core/random_curves.h"
#include "tests/core/reference.h"

namespace batten::core {

namespace {

double largest_change(const Curve& before, const Curve& after, RandomCurves& random) {
    double largest = 0.0;
    for (int k = 0; k < 40; ++k) {
        const double u = random.parameter(after);
        largest = std::max(largest, reference::relative_distance(before, reference::point_at(before, u),
                                                                 reference::point_at(after, u)));
    }
    return largest;
}

CurveError error_of(const Result<Curve>& result) {
    EXPECT_FALSE(result.has_value());
    return result ? CurveError{} : result.error();
}

}  // namespace

TEST(KnotInsertion, alphas_of_the_lecture_notes) {
    // Inserting 1/2 gives alphas 5/6, 1/2, 1/6 for the new points 3, 4, 5.
    const Curve curve = insert_knot(lecture_cubic(), 0.5).value();
    ASSERT_EQ(curve.control_points().size(), 9u);
    const std::vector<Point> expected{{0, 0}, {0, 6}, {6, 6}, {6, 1}, {9, 0}, {12, 1}, {12, 6}, {18, 6}, {18, 0}};
    for (std::size_t i = 0; i < 9; ++i) {
        EXPECT_NEAR(curve.control_points()[i].x, expected[i].x, 1e-14) << i;
        EXPECT_NEAR(curve.control_points()[i].y, expected[i].y, 1e-14) << i;
    }
    EXPECT_EQ(curve.knots()[6], 0.5);
}

TEST(KnotInsertion, keeps_the_shape_of_every_curve) {
    RandomCurves random(50);
    for (int k = 0; k < 500; ++k) {
        const Curve curve = random.curve();
        const double u = random.parameter(curve);
        const int free = curve.degree() - curve.knots().multiplicity(u);
        if (free < 1) continue;
        const int times = random.whole(1, free);
        const auto result = insert_knot(curve, u, times);
        ASSERT_TRUE(result) << describe(result.error());
        EXPECT_EQ(result->knots().multiplicity(u), curve.knots().multiplicity(u) + times);
        EXPECT_EQ(result->control_points().size(), curve.control_points().size() + static_cast<std::size_t>(times));
        EXPECT_EQ(result->domain(), curve.domain());
        EXPECT_EQ(result->is_periodic(), curve.is_periodic());
        EXPECT_LE(largest_change(curve, *result, random), 2e-14);
    }
}

TEST(KnotInsertion, touches_only_p_minus_multiplicity_points) {
    RandomCurves random(57);
    for (int k = 0; k < 50; ++k) {
        auto definition = lecture_cubic().definition();
        for (Point& point : definition.points) point = tip_of(random.number(0.5, 2) * vector_to(point));
        for (double& weight : definition.weights) weight = random.number(0.5, 2);
        const Curve before = Curve::make(definition).value();
        const Curve after = insert_knot(before, 0.4).value();
        for (std::size_t i = 0; i < 9; ++i) {
            if (i == 3 || i == 4) continue;
            EXPECT_EQ(after.control_points()[i], before.control_points()[i < 3 ? i : i - 1]) << i;
            EXPECT_EQ(after.weights()[i], before.weights()[i < 3 ? i : i - 1]) << i;
        }
    }
}

TEST(KnotInsertion, up_to_p_makes_the_curve_point_a_control_point) {
    RandomCurves random(51);
    for (int k = 0; k < 100; ++k) {
        const Curve curve = random.curve();
        const double u = random.number(curve.domain().lower, curve.domain().upper);
        const Curve full = insert_knot(curve, u, curve.degree()).value();
        double nearest = std::numeric_limits<double>::infinity();
        for (const Point& point : full.control_points())
            nearest = std::min(nearest, reference::relative_distance(curve, point, reference::point_at(curve, u)));
        EXPECT_LE(nearest, 1e-14);
    }
}

TEST(KnotInsertion, order_does_not_matter) {
    RandomCurves random(52);
    for (int k = 0; k < 100; ++k) {
        const Curve curve = random.curve();
        const double a = random.number(curve.domain().lower, curve.domain().upper);
        const double b = random.number(curve.domain().lower, curve.domain().upper);
        const Curve ab = insert_knot(insert_knot(curve, a).value(), b).value();
        const Curve ba = insert_knot(insert_knot(curve, b).value(), a).value();
        ASSERT_EQ(ab.knots(), ba.knots());
        for (std::size_t i = 0; i < ab.control_points().size(); ++i)
            EXPECT_LE(reference::relative_distance(curve, ab.control_points()[i], ba.control_points()[i]), 1e-14);
    }
}

TEST(KnotInsertion, into_the_seam_of_periodic_curves) {
    RandomCurves random(53);
    int inserted = 0;
    for (int k = 0; k < 300; ++k) {
        const Curve curve = random.periodic_curve();
        const double u = k % 2 == 0 ? curve.domain().lower : curve.domain().upper;
        const int free = curve.degree() - curve.knots().multiplicity(u);
        if (free < 1) continue;
        ++inserted;
        const Curve result = insert_knot(curve, u, free).value();
        EXPECT_EQ(result.domain(), curve.domain());
        EXPECT_EQ(result.knots().multiplicity(u), curve.degree());
        EXPECT_EQ(least_continuity(result.knots()), 0);
        EXPECT_LE(largest_change(curve, result, random), 2e-14);
    }
    EXPECT_GT(inserted, 100);
}

TEST(KnotInsertion, of_two_periodic_points_by_hand) {
    // Degree 2 over the period 0, 1, 2 with points A, B: unrolled the points are A B A B over -2 -1 0 1 2 3 4.
    // Inserting 1/2 and its repetitions -3/2, 5/2: over the new knots -3/2 -1 0 1/2 1 2 the points are the blossoms
    // b(-1, 0), b(0, 1/2) and b(1/2, 1); b(-1, 0) = A, b(0, 1) = B, b(1, 2) = A, so b(0, 1/2) = (A + 3 B)/4 and b(1/2,
    // 1) = (3 B + A)/4.
    const Curve curve =
        Curve::make({.degree = 2, .knots = {0, 1, 2}, .points = {{0, 0}, {4, 8}}, .periodic = true}).value();
    const Curve result = insert_knot(curve, 0.5).value();
    const auto stored = result.knots().stored();
    EXPECT_EQ(std::vector(stored.begin(), stored.end()), (std::vector<double>{0, 0.5, 1, 2}));
    ASSERT_EQ(result.control_points().size(), 3u);
    EXPECT_EQ(result.control_points()[0], Point(0, 0));
    EXPECT_EQ(result.control_points()[1], Point(3, 6));
    EXPECT_EQ(result.control_points()[2], Point(3, 6));
}

TEST(KnotInsertion, keeps_the_shape_where_a_period_is_far_shorter_than_the_degree) {
    RandomCurves random(56);
    for (const int degree : {13, 25})
        for (const double u : {0.0, 0.3, 1.0, 1.75, 2.0}) {
            const Curve curve = Curve::make({.degree = degree,
                                             .knots = {0, 1, 2},
                                             .points = {{-3, 1}, {4, 8}},
                                             .weights = {1, 2},
                                             .periodic = true})
                                    .value();
            const Curve result = insert_knot(curve, u, 2).value();
            for (int k = 0; k < 10; ++k) {
                const double at = random.number(0, 2);
                EXPECT_LE(reference::relative_distance(curve, point_at(curve, at), point_at(result, at)), 1e-13);
            }
        }
}

TEST(KnotInsertion, ends_may_be_clamped_fully) {
    const Curve curve = Curve::make({.degree = 2,
                                     .knots = {0, 1, 2, 3, 4, 5, 6},
                                     .points = {{0, 0}, {1, 2}, {3, 2}, {4, 0}},
                                     .weights = {1, 3, 2, 1}})
                            .value();
    const Curve clamped = insert_knot(insert_knot(curve, 2, 2).value(), 4, 2).value();
    EXPECT_EQ(clamped.knots().multiplicity(2), 3);
    EXPECT_EQ(clamped.knots().multiplicity(4), 3);
    EXPECT_EQ(clamped.domain(), curve.domain());
    // The control points on the curve's ends are there, but those that act outside the domain still stand around them.
    EXPECT_EQ(clamped.control_points()[2], reference::point_at(curve, 2));
    EXPECT_FALSE(is_clamped(clamped.knots()));
    RandomCurves random(54);
    EXPECT_LE(largest_change(curve, clamped, random), 1e-14);
}

TEST(KnotInsertion, refuses_what_is_not_a_parameter) {
    using Code = CurveErrorCode;
    const Curve curve = lecture_cubic();
    EXPECT_EQ(error_of(insert_knot(curve, std::nan(""))).code, Code::parameter_not_finite);
    EXPECT_EQ(error_of(insert_knot(curve, std::numeric_limits<double>::infinity())).code, Code::parameter_not_finite);
    EXPECT_EQ(error_of(insert_knot(curve, 1.25)),
              (CurveError{.code = Code::parameter_outside_domain, .value = 1.25, .lower = 0, .upper = 1}));
    EXPECT_EQ(error_of(insert_knot(curve, std::nextafter(0.0, -1.0))).code, Code::parameter_outside_domain);
}

TEST(KnotInsertion, refuses_full_multiplicity) {
    using Code = CurveErrorCode;
    const Curve curve = lecture_cubic();
    EXPECT_EQ(error_of(insert_knot(curve, 0.5, 4)),
              (CurveError{.code = Code::multiplicity_full, .value = 0.5, .upper = 3}));
    EXPECT_EQ(error_of(insert_knot(curve, 0.0)), (CurveError{.code = Code::multiplicity_full, .value = 0, .upper = 4}));
    EXPECT_EQ(error_of(insert_knot(insert_knot(curve, 0.5, 3).value(), 0.5)).code, Code::multiplicity_full);
}

TEST(KnotInsertion, kind_stays_where_the_values_still_have_it) {
    const Curve uniform = Curve::make({.degree = 2,
                                       .knots = {0, 0, 0, 1, 2, 2, 2},
                                       .points = {{0, 0}, {1, 1}, {2, 0}, {3, 1}},
                                       .kind = KnotKind::clamped_uniform})
                              .value();
    EXPECT_EQ(insert_knot(uniform, 0.5)->knots().kind(), KnotKind::custom);
    EXPECT_EQ(insert_midpoint_knots(uniform)->knots().kind(), KnotKind::clamped_uniform);
    const Curve pieces = Curve::make({.degree = 2,
                                      .knots = {0, 0, 0, 1, 1, 2, 2, 2},
                                      .points = {{0, 0}, {1, 1}, {2, 0}, {3, 1}, {4, 0}},
                                      .kind = KnotKind::piecewise_bezier})
                             .value();
    EXPECT_EQ(insert_knot(pieces, 0.5, 2)->knots().kind(), KnotKind::piecewise_bezier);
}

TEST(KnotInsertion, tears_only_where_it_is_allowed) {
    const Curve piece =
        Curve::make({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{0, 0}, {0, 8}, {8, 8}, {8, 0}}})
            .value();
    EXPECT_EQ(insert_knot(piece, 0.5, 4).error(),
              (CurveError{.code = CurveErrorCode::multiplicity_full, .value = 0.5, .upper = 3}));
    // De Casteljau's two halves, each with its own copy of the point where they met.
    const Curve torn = insert_knot(piece, 0.5, 4, Tears::allow).value();
    const std::vector<Point> halves{{0, 0}, {0, 4}, {2, 6}, {4, 6}, {4, 6}, {6, 6}, {8, 4}, {8, 0}};
    ASSERT_EQ(torn.control_points().size(), 8U);
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(torn.control_points()[i], halves[i]) << i;
    EXPECT_TRUE(torn.is_torn());
    EXPECT_FALSE(insert_knot(piece, 0.5, 3)->is_torn());
    EXPECT_EQ(point_at(torn, 0.25), point_at(piece, 0.25));
    // No more than that, and what is torn at one place needs leave for another.
    EXPECT_EQ(insert_knot(torn, 0.5, 1, Tears::allow).error(),
              (CurveError{.code = CurveErrorCode::multiplicity_full, .value = 0.5, .upper = 4}));
    EXPECT_EQ(insert_knot(torn, 0.25, 4).error().code, CurveErrorCode::multiplicity_full);
    EXPECT_EQ(insert_knot(torn, 0.25, 4, Tears::allow)->control_points().size(), 12U);
}

TEST(KnotInsertion, torn_or_not_the_curve_stays) {
    RandomCurves random(56);
    for (int k = 0; k < 100; ++k) {
        const Curve curve = random.curve();
        if (curve.is_periodic()) continue;
        const double u = random.parameter(curve);
        const int times = curve.degree() + 1 - curve.knots().multiplicity(u);
        if (times < 1) continue;
        const Curve torn = insert_knot(curve, u, times, Tears::allow).value();
        EXPECT_LE(largest_change(curve, torn, random), 2e-14);
    }
}

TEST(KnotInsertion, a_period_never_tears) {
    const Curve ring =
        Curve::make({.degree = 2, .knots = {0, 1, 2, 3}, .points = {{0, 0}, {1, 0}, {0, 1}}, .periodic = true}).value();
    EXPECT_EQ(insert_knot(ring, 1.5, 3, Tears::allow).error(),
              (CurveError{.code = CurveErrorCode::multiplicity_full, .value = 1.5, .upper = 2}));
}

TEST(KnotInsertion, midpoints_halve_every_span) {
    RandomCurves random(55);
    for (int k = 0; k < 100; ++k) {
        const Curve curve = random.curve();
        const Curve result = insert_midpoint_knots(curve).value();
        EXPECT_EQ(segment_count(result.knots()), 2 * segment_count(curve.knots()));
        EXPECT_EQ(result.domain(), curve.domain());
        EXPECT_LE(largest_change(curve, result, random), 2e-14);
    }
}

TEST(KnotInsertion, midpoints_leave_out_spans_too_short_to_halve) {
    const double next = std::nextafter(1.0, 2.0);
    const Curve curve =
        Curve::make({.degree = 1, .knots = {0, 0, 1, next, 2, 2}, .points = {{0, 0}, {1, 0}, {1, 1}, {2, 1}}}).value();
    EXPECT_EQ(segment_count(insert_midpoint_knots(curve)->knots()), 5u);
}

}  // namespace batten::core
