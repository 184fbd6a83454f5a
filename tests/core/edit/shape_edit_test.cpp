#include "core/edit/shape_edit.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/evaluate/evaluate.h"
#include "core/evaluate/rational_basis.h"
#include "core/make/conics.h"
#include "core/measure/continuity.h"
#include "core/refine/periodic.h"
#include "tests/core/random_curves.h"
#include "tests/core/smooth_shapes.h"

namespace batten::core {

namespace {

double change_between(const Curve& a, const Curve& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.control_points().size(); ++i) {
        const Vector move = b.control_points()[i] - a.control_points()[i];
        sum += dot(move, move);
    }
    return std::sqrt(sum);
}

double size_of(const Curve& curve) {
    double largest = 0.0;
    for (const Point& point : curve.control_points()) largest = std::max(largest, distance(point, {}));
    return largest;
}

}  // namespace

TEST(RationalBasis, makes_the_derivatives_of_the_curve) {
    RandomCurves random(101);
    for (int trial = 0; trial < 100; ++trial) {
        const Curve curve = random.curve();
        const double u = random.parameter(curve);
        const int order = std::min(curve.degree(), 3);
        const auto expected = derivatives_at(curve, u, order);
        const RationalBasis basis = rational_basis(curve, u, order);
        for (int r = 0; r <= order; ++r) {
            Vector sum{};
            double scale = 0.0;
            const auto& row = basis.derivatives[static_cast<std::size_t>(r)];
            for (std::size_t j = 0; j < row.size(); ++j) {
                const Point point = curve.control_points()[(basis.first + j) % curve.control_points().size()];
                sum += row[j] * vector_to(point);
                scale = std::max(scale, std::abs(row[j]) * distance(point, {}));
            }
            const Vector wanted = r == 0 ? vector_to(expected.point) : expected[static_cast<std::size_t>(r)];
            EXPECT_LT(length(sum - wanted), 1e-12 * scale);
        }
    }
}

// On a line from (0, 0) to (4, 0) of degree 1 the middle is half of each end: both move by the same.
TEST(MoveCurvePoint, moves_the_control_points_by_their_shares) {
    const Curve line = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {4, 0}}}).value();
    const Curve moved = move_curve_point(line, 0.5, {2, 1}).value();
    EXPECT_EQ(moved.control_points()[0], Point(0, 1));
    EXPECT_EQ(moved.control_points()[1], Point(4, 1));
    // A quarter of the way the shares are 3/4 and 1/4: the moves are (3/4) / (10/16) = 6/5 and 2/5.
    const Curve tilted = move_curve_point(line, 0.25, {1, 1}).value();
    EXPECT_DOUBLE_EQ(tilted.control_points()[0].y, 1.2);
    EXPECT_DOUBLE_EQ(tilted.control_points()[1].y, 0.4);
}

TEST(MoveCurvePoint, reaches_the_target_with_the_least_change) {
    RandomCurves random(102);
    for (int trial = 0; trial < 200; ++trial) {
        const Curve curve = random.curve();
        const double u = random.parameter(curve);
        const Point target(random.number(-9, 9), random.number(-9, 9));
        const Curve moved = move_curve_point(curve, u, target).value();
        EXPECT_LT(distance(point_at(moved, u), target), 1e-14 * size_of(moved));
        EXPECT_TRUE(std::ranges::equal(moved.weights(), curve.weights()));
        EXPECT_EQ(moved.knots(), curve.knots());
        // Any other change that keeps C(u) is larger: trade between two points that act there.
        const RationalBasis basis = rational_basis(curve, u);
        const std::size_t n = curve.control_points().size();
        if (n <= static_cast<std::size_t>(curve.degree())) continue;
        for (std::size_t j = 1; j < basis.derivatives[0].size(); ++j) {
            CurveDefinition other = moved.definition();
            other.points[(basis.first + j) % n] += 1e-3 * basis.derivatives[0][j - 1] * Vector(1, 1);
            other.points[(basis.first + j - 1) % n] -= 1e-3 * basis.derivatives[0][j] * Vector(1, 1);
            EXPECT_GE(change_between(curve, Curve::make(other).value()), change_between(curve, moved) * (1 - 1e-12));
        }
    }
}

TEST(MoveCurvePoint, leaves_what_does_not_act_there) {
    const Curve curve = Curve::make({.degree = 2,
                                     .knots = {0, 0, 0, 1, 2, 3, 3, 3},
                                     .points = {{0.1, 0.7}, {1.3, 2.1}, {3.3, 0.9}, {4.7, 2.3}, {6.1, 0.3}},
                                     .weights = {1, 3, 0.3, 2, 1}})
                            .value();
    const Curve moved = move_curve_point(curve, 0.5, {2, 2}).value();
    EXPECT_EQ(moved.control_points()[3], curve.control_points()[3]);
    EXPECT_EQ(moved.control_points()[4], curve.control_points()[4]);
    const Curve at_end = move_curve_point(curve, 3.0, {0.1, 0.2}).value();
    EXPECT_EQ(at_end.control_points()[4], Point(0.1, 0.2));
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(at_end.control_points()[i], curve.control_points()[i]);
}

TEST(MoveCurvePoint, is_as_exact_far_from_the_origin_and_over_any_domain) {
    RandomCurves random(104);
    for (const double scale : {1e-9, 1e9})
        for (int trial = 0; trial < 50; ++trial) {
            CurveDefinition definition = random.curve().definition();
            for (double& knot : definition.knots) knot *= scale;
            for (Point& point : definition.points) point += Vector(1e6, -1e6);
            const Curve curve = Curve::make(std::move(definition)).value();
            const double u = random.parameter(curve);
            const Point target = point_at(curve, u) + Vector(1, 2);
            const Curve moved = move_curve_point(curve, u, target).value();
            EXPECT_LT(distance(point_at(moved, u), target), 3e-9);
            const Vector tangent = derivatives_at(curve, u, 1)[1];
            const auto kept = move_curve_point_and_tangent(curve, u, target, tangent);
            if (!kept) continue;
            EXPECT_LT(distance(point_at(*kept, u), target), 3e-9);
        }
}

TEST(MoveCurvePoint, refuses_places_off_the_domain) {
    const Curve line = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {4, 0}}}).value();
    EXPECT_EQ(move_curve_point(line, 1.5, {0, 0}).error().code, CurveErrorCode::parameter_outside_domain);
    EXPECT_EQ(move_curve_point(line, NAN, {0, 0}).error().code, CurveErrorCode::parameter_not_finite);
    EXPECT_EQ(move_curve_point(line, 0.5, {0, NAN}).error().code, CurveErrorCode::vector_not_finite);
}

TEST(MovePointAndTangent, reaches_both_with_the_least_change) {
    RandomCurves random(103);
    for (int trial = 0; trial < 200; ++trial) {
        const Curve curve = random.curve();
        if (curve.is_periodic() && curve.control_points().size() < 4) continue;
        const double u = random.parameter(curve);
        const Side side = random.whole(0, 1) == 0 ? Side::left : Side::right;
        const Point target(random.number(-9, 9), random.number(-9, 9));
        const Vector tangent(random.number(-9, 9), random.number(-9, 9));
        const auto result = move_curve_point_and_tangent(curve, u, target, tangent, side);
        ASSERT_TRUE(result);
        const auto found = derivatives_at(*result, u, 1, side);
        double size = 10.0;
        for (const Point& point : result->control_points()) size = std::max(size, distance(point, {}));
        EXPECT_LT(distance(found.point, target), 1e-13 * size);
        const RationalBasis basis = rational_basis(curve, u, 1, side);
        double steepest = 1.0;
        for (const double slope : basis.derivatives[1]) steepest = std::max(steepest, std::abs(slope));
        EXPECT_LT(length(found[1] - tangent), 1e-13 * size * steepest);
        // The change is a combination of shares and slopes, which is what makes it least.
        const std::size_t n = curve.control_points().size();
        if (n <= static_cast<std::size_t>(curve.degree()) || basis.derivatives[0].size() < 3) continue;
        const auto& r = basis.derivatives[0];
        const auto& s = basis.derivatives[1];
        for (std::size_t j = 2; j < r.size(); ++j) {
            const double a = r[j - 1] * s[j] - r[j] * s[j - 1];
            const double b = r[j] * s[j - 2] - r[j - 2] * s[j];
            const double c = r[j - 2] * s[j - 1] - r[j - 1] * s[j - 2];
            CurveDefinition other = result->definition();
            const double step = 1e-3 / (std::abs(a) + std::abs(b) + std::abs(c) + 1e-300);
            other.points[(basis.first + j - 2) % n].x += step * a;
            other.points[(basis.first + j - 1) % n].x += step * b;
            other.points[(basis.first + j) % n].x += step * c;
            EXPECT_GE(change_between(curve, Curve::make(other).value()), change_between(curve, *result) * (1 - 1e-9));
        }
    }
}

TEST(MovePointAndTangent, refuses_where_the_tangent_does_not_depend_on_the_points) {
    const Curve two =
        Curve::make({.degree = 2, .knots = {0, 1, 2}, .points = {{0, 0}, {4, 0}}, .periodic = true}).value();
    EXPECT_EQ(move_curve_point_and_tangent(two, 0.5, {0, 0}, {1, 0}).error().code, CurveErrorCode::tangent_not_free);
}

TEST(MoveCurvePoint, keeps_the_smoothness_of_the_shape) {
    RandomCurves random(396);
    for (const int degree : {2, 3, 4, 7})
        for (int k = 0; k < 30; ++k) {
            const Curve curve = smooth_by_shape(degree, 12, random);
            const double u = random.parameter(curve);
            const Point target = point_at(curve, u) + Vector{0.5, -0.8};
            const Curve moved = move_curve_point(curve, u, target).value();
            EXPECT_LE(distance(point_at(moved, u), target), 1e-12);
            EXPECT_TRUE(smoothness_losses(curve, moved).empty()) << degree << " at " << u;
            const Vector derivative = 1.1 * derivatives_at(curve, u, 1)[1] + Vector{0.3, 0.2};
            const Curve turned = move_curve_point_and_tangent(curve, u, target, derivative).value();
            EXPECT_LE(distance(point_at(turned, u), target), 1e-12);
            EXPECT_LE(length(derivatives_at(turned, u, 1)[1] - derivative), 1e-9);
        }
}

TEST(MoveCurvePoint, moves_no_more_of_a_smooth_shape_than_simple_knots_would) {
    RandomCurves random(397);
    const Curve curve = smooth_by_shape(3, 12, random);
    std::vector<double> distinct = stored(curve);
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    const double u = 0.5 * (distinct[5] + distinct[6]);
    const Curve moved = move_curve_point(curve, u, point_at(curve, u) + Vector{1.0, 1.0}).value();
    for (std::size_t i = 0; i + 1 < distinct.size(); ++i) {
        const double middle = 0.5 * (distinct[i] + distinct[i + 1]);
        const bool is_near = i >= 2 && i <= 8;
        EXPECT_EQ(point_at(curve, middle) != point_at(moved, middle), is_near) << i;
    }
}

// Closed curves of two points stay on a line, so they are G2 wherever the points are. With one double knot a quarter of
// the way the shares are 23/64 and 41/64: the moves are 23 * 64 / (23^2 + 41^2) and 41 * 64 / (23^2 + 41^2).
TEST(MoveCurvePoint, moves_two_points_of_a_closed_curve_by_their_shares) {
    for (const double period : {1.0, 1e9})
        for (const double origin : {0.0, 1e6}) {
            const Curve curve = Curve::make({.degree = 3,
                                             .knots = {0, period, period},
                                             .points = {{origin, 1}, {origin - 3, 0}},
                                             .weights = {2.5, 2.5},
                                             .periodic = true})
                                    .value();
            const Curve moved =
                move_curve_point(curve, 0.25 * period, {origin - 123.0 / 64.0 + 1.0, 23.0 / 64.0 - 2.0}).value();
            const std::array<double, 2> shares{736.0 / 1105.0, 1312.0 / 1105.0};
            for (std::size_t i = 0; i < 2; ++i) {
                const Point wanted = curve.control_points()[i] + shares[i] * Vector(1.0, -2.0);
                EXPECT_LE(distance(moved.control_points()[i], wanted), 1e-15 * (4.0 + origin)) << i;
            }
        }
}

// The moves of the corners of the circle's square are 1 beside the ends, -1/7 on the far side, and each point between
// two corners moves by their mean: 6 a + (1 + a) = 0 makes 2 a^2 + (1 + a)^2 / 2 + a^2 least.
TEST(MoveCurvePoint, of_a_closed_curve_keeps_its_ends_one_point) {
    const Curve round = circle({0, 0}, 1.0).value();
    const std::array<double, 9> moves{1.0, 1.0, 3.0 / 7.0, -1.0 / 7.0, -1.0 / 7.0, -1.0 / 7.0, 3.0 / 7.0, 1.0, 1.0};
    for (const double u : {0.0, 1.0}) {
        const Curve moved = move_curve_point(round, u, {1, 1}).value();
        EXPECT_EQ(moved.control_points().front(), Point(1, 1));
        EXPECT_EQ(moved.control_points().back(), Point(1, 1));
        for (std::size_t i = 0; i < moves.size(); ++i)
            EXPECT_LE(distance(moved.control_points()[i], round.control_points()[i] + Vector(0, moves[i])), 1e-12) << i;
    }
    const Curve triangle =
        Curve::make({.degree = 1, .knots = {0, 0, 1, 2, 3, 3}, .points = {{0, 0}, {1, 0}, {0, 1}, {0, 0}}}).value();
    const Curve moved = move_curve_point(triangle, 3.0, {0.1, -0.2}).value();
    EXPECT_EQ(moved.control_points().front(), Point(0.1, -0.2));
    EXPECT_EQ(moved.control_points()[1], Point(1, 0));
    EXPECT_EQ(moved.control_points()[2], Point(0, 1));
    EXPECT_EQ(moved.control_points().back(), Point(0.1, -0.2));
}

TEST(MoveCurvePoint, of_a_closed_curve_keeps_its_ends_smooth) {
    const Curve round = circle({0, 0}, 1.0).value();
    for (const double u : {0.0, 0.1, 0.5, 0.9, 1.0}) {
        const Curve moved = move_curve_point(round, u, {1, 1}).value();
        const Curve turned = move_curve_point_and_tangent(round, u, {1, 1}, {3, 2}).value();
        for (const Curve& curve : {moved, turned}) {
            EXPECT_LE(distance(point_at(curve, u), {1, 1}), 1e-12) << u;
            EXPECT_EQ(curve.control_points().front(), curve.control_points().back()) << u;
            EXPECT_LE(std::abs(continuity_of_ends(curve).angle.value()), 1e-12) << u;
        }
    }
    RandomCurves random(398);
    for (int k = 0; k < 200; ++k) {
        const Curve ring = random.curve();
        if (!ring.is_periodic() || ring.control_points().size() < 4) continue;
        const Curve curve = to_clamped(ring).value();
        const double u = random.parameter(curve);
        const Curve moved = move_curve_point(curve, u, point_at(curve, u) + Vector(0.3, -0.2)).value();
        EXPECT_EQ(moved.control_points().front(), moved.control_points().back());
        for (const SmoothnessLoss& loss : smoothness_losses(curve, moved))
            EXPECT_EQ(loss.after.geometric, curve.degree() - 1) << curve.degree();
    }
}

TEST(MoveCurvePoint, pulls_a_curve_that_is_a_single_point_apart) {
    const Curve point = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{2, 1}, {2, 1}}}).value();
    const Curve moved = move_curve_point(point, 1.0, {5, 5}).value();
    EXPECT_EQ(moved.control_points().front(), Point(2, 1));
    EXPECT_EQ(moved.control_points().back(), Point(5, 5));
}

TEST(MoveCurvePoint, of_a_straight_polyline_makes_the_corner_that_it_must) {
    const Curve straight =
        Curve::make({.degree = 1, .knots = {0, 0, 1, 2, 2}, .points = {{0, 0}, {1, 0}, {2, 0}}}).value();
    const Curve bent = move_curve_point(straight, 1.0, {1, 1}).value();
    EXPECT_EQ(bent.control_points()[1], Point(1, 1));
    EXPECT_EQ(smoothness_losses(straight, bent).size(), 1U);
}

// On a cubic piece at 1/2 the functions are 1/8, 3/8, 3/8, 1/8; with P_1 pinned the others move in proportion to
// theirs, and the sum of their squares is 11/64.
TEST(MoveCurvePoint, pinned_points_stay_and_the_others_make_up_for_them) {
    const Curve curve =
        Curve::make({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{0, 0}, {1, 2}, {3, 2}, {4, 0}}})
            .value();
    const std::vector<std::size_t> pinned{1};
    const Curve moved = move_curve_point(curve, 0.5, {2.0, 2.6}, pinned).value();
    EXPECT_EQ(moved.control_points()[1], curve.control_points()[1]);
    EXPECT_LT(distance(point_at(moved, 0.5), {2.0, 2.6}), 1e-15);
    const double unit = (2.6 - 1.5) / (11.0 / 64.0);
    EXPECT_NEAR(moved.control_points()[0].y, unit / 8.0, 1e-14);
    EXPECT_NEAR(moved.control_points()[2].y, 2.0 + 3.0 * unit / 8.0, 1e-14);
    EXPECT_NEAR(moved.control_points()[3].y, unit / 8.0, 1e-14);
}

TEST(MoveCurvePoint, is_refused_where_all_that_act_are_pinned) {
    const Curve curve =
        Curve::make(
            {.degree = 2, .knots = {0, 0, 0, 1, 2, 3, 3, 3}, .points = {{0, 0}, {1, 2}, {3, 2}, {4, 0}, {5, 1}}})
            .value();
    const std::vector<std::size_t> last_three{2, 3, 4};
    const auto refused = move_curve_point(curve, 2.5, {0, 0}, last_three);
    EXPECT_EQ(refused.error().code, CurveErrorCode::points_pinned);
    EXPECT_EQ(refused.error().value, 2.5);
    EXPECT_EQ(move_curve_point_and_tangent(curve, 2.5, {0, 0}, {1, 0}, Side::right, last_three).error().code,
              CurveErrorCode::points_pinned);
    EXPECT_TRUE(move_curve_point(curve, 1.5, {0, 0}, last_three));
    const std::vector<std::size_t> first{0};
    EXPECT_EQ(move_curve_point(curve, 0.0, {0, 1}, first).error().code, CurveErrorCode::points_pinned);
}

TEST(MoveCurvePoint, pinned_points_of_any_curve_keep_every_bit) {
    RandomCurves random(77);
    for (int trial = 0; trial < 300; ++trial) {
        const Curve curve = trial % 3 == 0 ? smooth_by_shape(3, 6, random) : random.curve();
        const double u = random.parameter(curve);
        const std::vector<std::size_t> pinned{1, curve.control_points().size() - 1};
        const Vector tangent = derivatives_at(curve, u, 1)[1];
        for (const auto& moved :
             {move_curve_point(curve, u, {3.0, 4.0}, pinned),
              move_curve_point_and_tangent(curve, u, {3.0, 4.0}, 2.0 * tangent, Side::right, pinned)}) {
            if (!moved) continue;
            EXPECT_LT(distance(point_at(*moved, u), {3.0, 4.0}), 1e-8 * (1.0 + size_of(*moved))) << trial;
            for (const std::size_t i : pinned) EXPECT_EQ(moved->control_points()[i], curve.control_points()[i]);
        }
    }
}

}  // namespace batten::core
