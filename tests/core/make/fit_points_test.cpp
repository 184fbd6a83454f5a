#include "core/make/fit_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/evaluate/evaluate.h"
#include "core/make/through_points.h"
#include "tests/core/random_curves.h"

namespace batten::core {

namespace {

const std::vector<Point> zigzag{{0, 0}, {3, 4}, {3, 13}, {15, 18}};  // chords 5, 9 and 13

FitPoints fit_of(std::span<const Point> places, FitKind kind, bool closed = false,
                 Parametrization parametrization = Parametrization::chordal) {
    return fit_points_at(places, {kind, parametrization, closed}).value();
}

std::string sentence_of(const Result<FitPoints>& result) {
    return result ? "none" : describe(result.error());
}

}  // namespace

TEST(FitPoints, parameters_are_sums_of_chords) {
    EXPECT_EQ(fit_of(zigzag, FitKind::c2).parameters, (std::vector<double>{0, 5, 14, 27}));
    EXPECT_EQ(fit_of(zigzag, FitKind::c2, false, Parametrization::uniform).parameters,
              (std::vector<double>{0, 1, 2, 3}));
    EXPECT_DOUBLE_EQ(fit_of(zigzag, FitKind::c2, false, Parametrization::centripetal).parameters[2],
                     std::sqrt(5.0) + 3.0);
    const Point triangle[] = {{0, 0}, {3, 0}, {3, 4}};
    EXPECT_EQ(fit_of(triangle, FitKind::fair, true).parameters, (std::vector<double>{0, 3, 7, 12}));
}

TEST(FitPoints, says_what_is_wrong_with_points) {
    const Point one[] = {{0, 0}};
    EXPECT_EQ(sentence_of(fit_points_at(one, {})), "one point was found; at least 2 are needed");
    const Point two[] = {{0, 0}, {1, 0}};
    EXPECT_EQ(sentence_of(fit_points_at(two, {.closed = true})), "2 points were found; at least 3 are needed");
    const Point equal[] = {{0, 0}, {1, 0}, {1, 0}, {2, 0}};
    EXPECT_EQ(sentence_of(fit_points_at(equal, {})), "point 2 lies on point 1; the two must differ");
    EXPECT_EQ(sentence_of(fit_points_at(equal, {.parametrization = Parametrization::uniform})), "none");
    const Point back[] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}};
    EXPECT_EQ(sentence_of(fit_points_at(back, {.closed = true})), "point 0 lies on point 3; the two must differ");
    const Point lost[] = {{0, 0}, {1, std::numeric_limits<double>::quiet_NaN()}};
    EXPECT_EQ(sentence_of(fit_points_at(lost, {})),
              "point 1 has a coordinate that is not finite; every coordinate must be finite");
}

TEST(FitPoints, says_which_point_there_is_not) {
    const FitPoints fit = fit_of(zigzag, FitKind::c2);
    const std::string sentence = "there is no fit point 5; the last one is 3";
    EXPECT_EQ(sentence_of(move_fit_point(fit, 5, {0, 0})), sentence);
    EXPECT_EQ(sentence_of(insert_fit_point(fit, 5, {0, 0})), sentence);
    EXPECT_EQ(sentence_of(delete_fit_point(fit, 5)), sentence);
    EXPECT_EQ(sentence_of(set_fit_joint(fit, 5, FitJoint::corner)), sentence);
    EXPECT_EQ(sentence_of(move_fit_point(fit, 1, {0, 0})), "point 1 lies on point 0; the two must differ");
    EXPECT_EQ(sentence_of(move_fit_point(fit_of(zigzag, FitKind::local), 1, {3, 13})),
              "point 2 lies on point 1; the two must differ");
    EXPECT_EQ(sentence_of(insert_fit_point(fit_of(zigzag, FitKind::local), 4, {15, 18})),
              "point 4 lies on point 3; the two must differ");
    const Point pair[] = {{0, 0}, {1, 0}};
    EXPECT_EQ(sentence_of(delete_fit_point(fit_of(pair, FitKind::c2), 0)),
              "one point was found; at least 2 are needed");
}

TEST(FitPoints, parameters_are_made_anew_but_of_the_local_kind) {
    const Point place{3, 5};  // chords 34^0.5, 8, 13
    EXPECT_EQ(move_fit_point(fit_of(zigzag, FitKind::c2), 1, place)->parameters[2], std::sqrt(34.0) + 8.0);
    const FitPoints local = fit_of(zigzag, FitKind::local);
    EXPECT_EQ(move_fit_point(local, 1, {3, 4})->parameters, local.parameters);
    const std::vector<double> moved = move_fit_point(local, 1, place)->parameters;
    EXPECT_DOUBLE_EQ(moved[1], 14.0 * std::sqrt(34.0) / (std::sqrt(34.0) + 8.0));
    EXPECT_EQ(moved[2], 14.0);
    // The last span is 13 long for a chord of 13, the first 5 for one of 5.
    EXPECT_EQ(move_fit_point(local, 3, {3, 20})->parameters, (std::vector<double>{0, 5, 14, 21}));
    EXPECT_EQ(move_fit_point(local, 0, {3, -6})->parameters, (std::vector<double>{-5, 5, 14, 27}));
}

// The way around is 5 + 9 + 13 + root 549; with point 0 at (15, 0) those beside it are 18 and root 160 long.
TEST(FitPoints, the_first_point_of_a_closed_local_curve_is_as_any_other) {
    const Point place{15, 0};
    const FitPoints moved = move_fit_point(fit_of(zigzag, FitKind::local, true), 0, place).value();
    const double way_in = std::sqrt(549.0);
    const double share = 18.0 / (18.0 + std::sqrt(160.0));
    EXPECT_NEAR(moved.parameters[0], -way_in + share * (way_in + 5.0), 1e-13);
    EXPECT_EQ(moved.parameters[1], 5.0);
    EXPECT_EQ(moved.parameters[3], 27.0);
    EXPECT_NEAR(moved.parameters[4] - moved.parameters[0], 27.0 + way_in, 1e-13);
    const std::vector<Point> turned{zigzag[2], zigzag[3], zigzag[0], zigzag[1]};
    const FitPoints other = move_fit_point(fit_of(turned, FitKind::local, true), 2, place).value();
    const Curve curve = through_points(moved).value();
    const Curve same = through_points(other).value();
    const double shift = other.parameters[2] - moved.parameters[0];
    for (int k = 0; k <= 40; ++k) {
        const double u = moved.parameters[0] + (27.0 + way_in) * k / 40.0;
        const Point expected = point_at(same, same.knots().into_domain(u + shift));
        EXPECT_LT(distance(point_at(curve, curve.knots().into_domain(u)), expected), 1e-12) << k;
    }
}

TEST(FitPoints, points_are_put_in_and_taken_out) {
    const FitPoints local = fit_of(zigzag, FitKind::local);
    EXPECT_EQ(insert_fit_point(local, 2, {3, 7})->parameters, (std::vector<double>{0, 5, 8, 14, 27}));
    EXPECT_EQ(insert_fit_point(local, 4, {15, 20})->parameters, (std::vector<double>{0, 5, 14, 27, 29}));
    EXPECT_EQ(insert_fit_point(local, 0, {0, -2})->parameters, (std::vector<double>{-2, 0, 5, 14, 27}));
    EXPECT_EQ(delete_fit_point(local, 1)->parameters, (std::vector<double>{0, 14, 27}));
    EXPECT_EQ(delete_fit_point(local, 3)->parameters, (std::vector<double>{0, 5, 14}));
    const FitPoints c2 = insert_fit_point(fit_of(zigzag, FitKind::c2), 2, {3, 7}).value();
    EXPECT_EQ(c2.parameters, (std::vector<double>{0, 5, 8, 14, 27}));
    EXPECT_EQ(c2.points[2].place, Point(3, 7));
    EXPECT_EQ(delete_fit_point(c2, 2).value(), fit_of(zigzag, FitKind::c2));
    const Point square[] = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    const FitPoints ring = fit_of(square, FitKind::local, true);
    EXPECT_EQ(insert_fit_point(ring, 0, {0, 1})->points.back().place, Point(0, 1));
    EXPECT_EQ(insert_fit_point(ring, 4, {0, 1})->parameters, (std::vector<double>{0, 4, 8, 12, 15, 16}));
    EXPECT_EQ(delete_fit_point(ring, 0)->parameters, (std::vector<double>{4, 8, 12, 20}));
}

TEST(FitPoints, a_line_that_is_parted_stays_one) {
    const FitPoints fit = set_fit_joint(fit_of(zigzag, FitKind::c2), 1, FitJoint::straight).value();
    EXPECT_EQ(insert_fit_point(fit, 2, {3, 9})->points[2].joint, FitJoint::straight);
    EXPECT_EQ(insert_fit_point(fit, 1, {1, 2})->points[1].joint, FitJoint::smooth);
}

TEST(FitPoints, a_handle_is_a_third_of_the_derivative_over_the_mean_span) {
    FitPoints fit = set_fit_joint(fit_of(zigzag, FitKind::c2), 1, FitJoint::tangent, {7, 14}).value();
    EXPECT_EQ(span_beside(fit, 1), 7.0);
    EXPECT_EQ(derivative_of_handle(fit, 1), Vector(3, 6));
    EXPECT_LT(length(handle_of_derivative(fit, 1, {3, 6}) - Vector(7, 14)), 1e-14);
    EXPECT_EQ(span_beside(fit, 0), 5.0);
    EXPECT_EQ(span_beside(fit, 3), 13.0);
    const Point triangle[] = {{0, 0}, {3, 0}, {3, 4}};
    EXPECT_EQ(span_beside(fit_of(triangle, FitKind::c2, true), 0), 4.0);
    EXPECT_EQ(span_beside(fit_of(triangle, FitKind::c2, true), 2), 4.5);
}

// Every bit of the control points and knots of spans farther than two away, whichever point moves and however often.
TEST(FitPoints, spans_farther_than_two_away_keep_every_bit_of_the_local_kind) {
    RandomCurves random(7);
    std::vector<Point> places;
    for (int k = 0; k < 30; ++k) {
        const double x = random.number(-8.0, 8.0);
        places.emplace_back(x, random.number(-8.0, 8.0));
    }
    for (const bool closed : {false, true}) {
        FitPoints fit = fit_of(places, FitKind::local, closed);
        fit = set_fit_joint(fit, 9, FitJoint::tangent, {1, 1}).value();
        fit = set_fit_joint(fit, 20, FitJoint::corner).value();
        for (std::size_t i = 0; i < 30; ++i) {
            const Curve before = through_points(fit).value();
            const double x = random.number(-8.0, 8.0);
            const FitPoints moved = move_fit_point(fit, i, {x, random.number(-8.0, 8.0)}).value();
            const Curve after = through_points(moved).value();
            const auto old_points = before.control_points();
            const auto points = after.control_points();
            ASSERT_EQ(points.size(), old_points.size());
            std::size_t changed = 0;
            for (std::size_t k = 0; k < points.size(); ++k) changed += points[k] == old_points[k] ? 0U : 1U;
            EXPECT_LE(changed, 9U) << i;  // two handles for each of four spans, and a corner
            EXPECT_GE(changed, 3U) << i;
            std::size_t knots_changed = 0;
            for (std::size_t k = 0; k < fit.parameters.size(); ++k)
                knots_changed += fit.parameters[k] == moved.parameters[k] ? 0U : 1U;
            EXPECT_LE(knots_changed, closed && i == 0 ? 2U : 1U) << i;  // of the seam at both ends of the period
            fit = moved;
        }
    }
}

TEST(FitPoints, another_form_keeps_points_and_joints) {
    const FitPoints fit = set_fit_joint(fit_of(zigzag, FitKind::local), 2, FitJoint::corner).value();
    const FitPoints fair = set_fit_form(fit, {FitKind::fair, Parametrization::uniform, true}).value();
    EXPECT_EQ(fair.points, fit.points);
    EXPECT_EQ(fair.kind, FitKind::fair);
    EXPECT_TRUE(fair.closed);
    EXPECT_EQ(fair.parameters, (std::vector<double>{0, 1, 2, 3, 4}));
}

TEST(FitPoints, are_checked) {
    FitPoints fit = fit_of(zigzag, FitKind::c2);
    EXPECT_TRUE(check_fit_points(fit));
    fit.parameters[2] = 5.0;
    EXPECT_EQ(describe(check_fit_points(fit).error()),
              "parameter 2 is not above the one before it; parameters must be finite and increase from point to point");
    fit.parameters.pop_back();
    EXPECT_EQ(check_fit_points(fit).error().code, CurveErrorCode::parameter_count_mismatch);
    EXPECT_EQ(through_points(fit).error().code, CurveErrorCode::parameter_count_mismatch);
    fit = fit_of(zigzag, FitKind::c2);
    fit.points[1].handle.x = std::numeric_limits<double>::infinity();
    EXPECT_EQ(check_fit_points(fit).error().code, CurveErrorCode::vector_not_finite);
}

}  // namespace batten::core
