#include "core/edit/joint_keeping.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/edit/point_edit.h"
#include "core/evaluate/evaluate.h"
#include "tests/core/made_curve.h"
#include "tests/core/near_points.h"

namespace batten::core {
namespace {

using Points = std::vector<Point>;

/// Two cubic Bézier pieces that meet at u = 1.
Curve two_pieces(Points points) {
    return made_curve({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2}, .points = std::move(points)});
}

KeptJoint at_knot(double u, int level, std::size_t curve = 0) {
    return {{curve, u, Side::left}, {curve, u, Side::right}, level};
}

EditedCurve edited(const Curve& old, const Curve& now, std::vector<std::size_t> held = {}) {
    return {now, std::make_shared<const Curve>(old), std::move(held)};
}

Curve with_point(const Curve& curve, std::size_t i, Point place) {
    return set_control_point(curve, i, place).value();
}

Points points_of(const Curve& curve) {
    return {curve.control_points().begin(), curve.control_points().end()};
}

Curve kept_alone(const Curve& old, const Curve& now, int level, std::vector<std::size_t> held = {}) {
    const KeptJoints kept = keep_joints({edited(old, now, std::move(held))}, {at_knot(1, level)});
    EXPECT_TRUE(kept.lost.empty());
    return kept.curves.front();
}

/// The sine of the angle between the directions on both sides of a joint, which do not turn back.
double turn_at(const Curve& before, double u, Side side, const Curve& after, double v, Side other) {
    const Vector arriving = (side == Side::left ? 1.0 : -1.0) * derivatives_at(before, u, 1, side)[1];
    const Vector leaving = (other == Side::right ? 1.0 : -1.0) * derivatives_at(after, v, 1, other)[1];
    EXPECT_GT(dot(arriving, leaving), 0.0);
    return cross(arriving, leaving) / (length(arriving) * length(leaving));
}

double turn_at(const Curve& curve, double u) {
    return turn_at(curve, u, Side::left, curve, u, Side::right);
}

/// Relatively, or beside the curvature of a circle as large as the curves here.
void expect_same_curvature(const Curve& curve, double u, double relative = 1e-9) {
    const double left = curvature_at(curve, u, Side::left).value();
    const double right = curvature_at(curve, u, Side::right).value();
    EXPECT_NEAR(left, right, relative * std::max({std::abs(left), std::abs(right), 0.1}));
}

const Points smooth_points{{-6, 0}, {-5, 3}, {-1, 0}, {0, 0}, {2, 0}, {5, 3}, {6, 0}};

TEST(KeepJoints, turns_the_other_neighbor_and_keeps_its_distance) {
    const Curve old = two_pieces(smooth_points);
    const Curve kept = kept_alone(old, with_point(old, 4, {0, 3}), 1);
    expect_near(kept.control_points()[2], {0, -1});
    EXPECT_EQ(kept.control_points()[4], Point(0, 3));
    for (const std::size_t i : {0U, 1U, 3U, 5U, 6U}) EXPECT_EQ(kept.control_points()[i], smooth_points[i]);
    // And likewise the other way, by more than a right angle.
    const Curve back = kept_alone(old, with_point(old, 2, {3, 4}), 1);
    expect_near(back.control_points()[4], {-1.2, -1.6});
    EXPECT_EQ(back.control_points()[2], Point(3, 4));
}

TEST(KeepJoints, takes_the_neighbors_along) {
    const Curve old = two_pieces(smooth_points);
    const Curve kept = kept_alone(old, with_point(old, 3, {4, 7}), 1);
    EXPECT_EQ(points_of(kept), (Points{{-6, 0}, {-5, 3}, {3, 7}, {4, 7}, {6, 7}, {5, 3}, {6, 0}}));
}

TEST(KeepJoints, puts_the_joint_between_neighbors_that_both_moved) {
    const Curve old = two_pieces(smooth_points);
    const Curve kept = kept_alone(old, with_point(with_point(old, 2, {-1, 0.5}), 4, {2, 3.5}), 1);
    // The nearest place of the line y = x + 1.5.
    expect_near(kept.control_points()[3], {-0.75, 0.75});
    EXPECT_EQ(kept.control_points()[2], Point(-1, 0.5));
    EXPECT_EQ(kept.control_points()[4], Point(2, 3.5));
}

TEST(KeepJoints, leaves_alone_what_agrees) {
    const Curve old = two_pieces(smooth_points);
    const Curve moved = with_point(with_point(old, 0, {9, 9}), 4, {1, 0});
    EXPECT_EQ(kept_alone(old, moved, 1), moved);
    EXPECT_EQ(kept_alone(old, with_point(old, 2, {5, 5}), 0), with_point(old, 2, {5, 5}));
}

/// (2/3) distance of the second next point from the tangent over the squared length of the leg: of a cubic piece.
double curvature_by_points(Point end, Point next, Point second) {
    const Vector leg = next - end;
    return 2.0 / 3.0 * cross(leg, second - end) / std::pow(length(leg), 3);
}

TEST(KeepJoints, keeps_the_curvature) {
    // (2/3) 3 = (2/3) 12 / 2^2.
    const Points points{{-6, 0}, {-5, 3}, {-1, 0}, {0, 0}, {2, 0}, {5, 12}, {6, 0}};
    const Curve old = two_pieces(points);
    const Curve kept = kept_alone(old, with_point(old, 5, {4, -4}), 2);
    const Points now = points_of(kept);
    EXPECT_EQ(now[5], Point(4, -4));
    EXPECT_EQ(now[3], Point(0, 0));
    EXPECT_EQ(now[0], Point(-6, 0));
    EXPECT_EQ(now[6], Point(6, 0));
    EXPECT_NEAR(turn_at(kept, 1), 0.0, 1e-13);
    EXPECT_NEAR(curvature_by_points(now[3], now[4], now[5]), -curvature_by_points(now[3], now[2], now[1]), 1e-10);
    expect_same_curvature(kept, 1);
}

TEST(KeepJoints, keeps_the_curvature_far_from_the_origin) {
    Points points{{-6, 0}, {-5, 3}, {-1, 0}, {0, 0}, {2, 0}, {5, 12}, {6, 0}};
    for (Point& point : points) point += Vector(1e6, -1e6);
    const Curve old = two_pieces(points);
    const Points now = points_of(kept_alone(old, with_point(old, 4, points[3] + Vector(0, 2)), 2));
    EXPECT_EQ(now[3], points[3]);
    EXPECT_NEAR(cross(now[3] - now[2], now[4] - now[3]), 0.0, 1e-9);
    EXPECT_NEAR(curvature_by_points(now[3], now[4], now[5]), -curvature_by_points(now[3], now[2], now[1]), 1e-9);
}

TEST(KeepJoints, makes_a_corner_smooth) {
    const Points points{{-6, 0}, {-5, 3}, {-3, 0}, {0, 0}, {0, 3}, {5, 3}, {6, 0}};
    const Curve corner = two_pieces(points);
    KeptJoint joint = at_knot(1, 1);
    // Nothing changed, so nothing is mended...
    EXPECT_EQ(keep_joints({edited(corner, corner)}, {joint}).curves.front(), corner);
    joint.is_new = true;
    const KeptJoints kept = keep_joints({edited(corner, corner)}, {joint});
    // ... but where the joint is to be made: both neighbors turn by 45 degrees.
    const double a = 3.0 * std::sqrt(0.5);
    expect_near(kept.curves.front().control_points()[2], {-a, -a});
    expect_near(kept.curves.front().control_points()[4], {a, a});
    EXPECT_EQ(kept.curves.front().control_points()[3], Point(0, 0));
}

TEST(KeepJoints, moved_points_give_way_to_held_ones) {
    const Curve old = two_pieces(smooth_points);
    const Curve kept = kept_alone(old, with_point(old, 4, {0, 3}), 1, {2, 3});
    EXPECT_EQ(kept.control_points()[2], Point(-1, 0));
    EXPECT_EQ(kept.control_points()[3], Point(0, 0));
    expect_near(kept.control_points()[4], {3, 0});
    // And where nothing can move the joint is lost.
    const Curve moved = with_point(old, 4, {0, 3});
    const KeptJoints none = keep_joints({edited(old, moved, {2, 3, 4})}, {at_knot(1, 1)});
    EXPECT_EQ(none.lost, std::vector<std::size_t>{0});
    EXPECT_EQ(none.curves.front(), moved);
}

TEST(KeepJoints, is_lost_where_the_curve_stands_still) {
    const Curve old = two_pieces(smooth_points);
    const Curve moved = with_point(old, 4, {0, 0});
    const KeptJoints kept = keep_joints({edited(old, moved, {2})}, {at_knot(1, 2)});
    EXPECT_EQ(kept.lost, std::vector<std::size_t>{0});
}

TEST(KeepJoints, ends_of_two_curves_stay_together) {
    const Curve first =
        made_curve({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{-6, 0}, {-5, 3}, {-1, 0}, {0, 0}}});
    // Runs toward the joint, too.
    const Curve second = made_curve({.degree = 2, .knots = {0, 0, 0, 4, 4, 4}, .points = {{6, 3}, {2, 0}, {0, 0}}});
    const KeptJoint joint{{0, 1, Side::left}, {1, 4, Side::left}, 2};
    const Curve moved = with_point(first, 3, {0.1, 1.0 / 3.0});
    const KeptJoints kept = keep_joints({edited(first, moved), edited(second, second)}, {joint});
    ASSERT_TRUE(kept.lost.empty());
    EXPECT_EQ(kept.curves[0].control_points()[3], Point(0.1, 1.0 / 3.0));
    EXPECT_EQ(kept.curves[1].control_points()[2], Point(0.1, 1.0 / 3.0));
    EXPECT_EQ(kept.curves[0].control_points()[0], Point(-6, 0));
    EXPECT_NEAR(turn_at(kept.curves[0], 1, Side::left, kept.curves[1], 4, Side::left), 0.0, 1e-12);
    EXPECT_NEAR(curvature_at(kept.curves[0], 1).value(), -curvature_at(kept.curves[1], 4).value(), 1e-10);
    // The curve that was moved leads, also where it is the second.
    const KeptJoints back = keep_joints({edited(first, first), edited(second, with_point(second, 2, {0, 5}))},
                                        {{joint.before, joint.after, 0}});
    EXPECT_EQ(back.curves[0].control_points()[3], Point(0, 5));
    // To a curve that is locked the other one goes back.
    std::vector<EditedCurve> curves{edited(first, moved), edited(second, second)};
    curves[1].is_held = true;
    const KeptJoints stuck = keep_joints(curves, {joint});
    EXPECT_TRUE(stuck.lost.empty());
    EXPECT_EQ(stuck.curves[1], second);
    EXPECT_EQ(stuck.curves[0].control_points()[3], Point(0, 0));
}

TEST(KeepJoints, of_one_simple_knot_less_only_the_curvature_is_mended) {
    // A double knot of a cubic: C1 by its knots.
    const Curve old = made_curve({.degree = 3,
                                  .knots = {0, 0, 0, 0, 1, 1, 2, 2, 2, 2},
                                  .points = {{0, 0}, {1, 2}, {3, 3}, {5, 3}, {7, 2}, {8, 0}}});
    KeptJoint joint = at_knot(1, 2);
    joint.is_new = true;
    const Curve start = keep_joints({edited(old, old)}, {joint}).curves.front();
    expect_same_curvature(start, 1);
    joint.is_new = false;
    const Curve moved = with_point(start, 4, {7, -3});
    const KeptJoints kept = keep_joints({edited(start, moved)}, {joint});
    ASSERT_TRUE(kept.lost.empty());
    expect_same_curvature(kept.curves.front(), 1);
    EXPECT_EQ(kept.curves.front().control_points()[4], Point(7, -3));
    EXPECT_EQ(kept.curves.front().control_points()[0], Point(0, 0));
    EXPECT_EQ(kept.curves.front().control_points()[5], Point(8, 0));
}

TEST(KeepJoints, the_seam_of_a_periodic_curve_is_a_knot) {
    const Curve old = made_curve({.degree = 2,
                                  .knots = {0, 0, 1, 1, 2, 2, 3},
                                  .points = {{4, 0}, {4, 4}, {0, 4}, {-4, 4}, {-4, 0}, {0, -4}},
                                  .periodic = true});
    std::size_t before = 0;
    for (std::size_t i = 0; i < 6; ++i)
        if (old.control_points()[i] == point_at(old, 0)) before = i;
    KeptJoint joint = at_knot(0, 1);
    joint.is_new = true;
    const KeptJoints kept = keep_joints({edited(old, old)}, {joint});
    ASSERT_TRUE(kept.lost.empty());
    EXPECT_EQ(kept.curves.front().control_points()[before], old.control_points()[before]);
    EXPECT_NEAR(turn_at(kept.curves.front(), 0), 0.0, 1e-12);
}

TEST(KeepJoints, a_polyline_keeps_a_vertex_straight) {
    const Curve old = made_curve({.degree = 1, .knots = {0, 0, 1, 2, 2}, .points = {{-1, 0}, {0, 0}, {3, 0}}});
    const Curve kept = kept_alone(old, with_point(old, 2, {0, 2}), 2);
    EXPECT_EQ(kept.control_points()[1], Point(0, 0));
    expect_near(kept.control_points()[0], {0, -1});
}

/// Random pieces, smooth at their joints once they are kept, and random edits of them.
class RandomJoints {
  public:
    double between(double lower, double upper) { return std::uniform_real_distribution(lower, upper)(random_); }
    std::size_t below(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }

    CurveDefinition pieces(int degree, int multiplicity, int count, Vector away) {
        CurveDefinition definition{.degree = degree};
        const auto put = [&](double u, int times) {
            definition.knots.insert(definition.knots.end(), static_cast<std::size_t>(times), u);
        };
        put(0, degree + 1);
        for (int k = 1; k < count; ++k) put(k + between(0, 0.5), multiplicity);
        put(count, degree + 1);
        const std::size_t n = definition.knots.size() - static_cast<std::size_t>(degree) - 1;
        for (std::size_t i = 0; i < n; ++i) {
            const double x = static_cast<double>(i);
            definition.points.push_back(Point(x + between(-0.2, 0.2), 2.0 * std::sin(0.7 * x) + between(-0.2, 0.2)) +
                                        away);
            if (count % 2 == 0) definition.weights.push_back(between(0.5, 2.0));
        }
        return definition;
    }

  private:
    std::mt19937 random_{7};
};

Curve seen_from(const Curve& curve, Point origin) {
    CurveDefinition definition = curve.definition();
    for (Point& point : definition.points) point = core::seen_from(point, origin);
    return made_curve(std::move(definition));
}

TEST(KeepJoints, of_random_curves_all_stay_through_random_edits) {
    RandomJoints random;
    std::size_t edits = 0;
    std::size_t lost = 0;
    for (const int degree : {2, 3, 4, 5, 8})
        for (const int level : {1, 2})
            for (const int count : {3, 4})
                for (const double away : {0.0, 1e6}) {
                    const int multiplicity = degree - static_cast<int>(random.below(level == 2 && degree > 2 ? 2 : 1));
                    Curve curve = made_curve(random.pieces(degree, multiplicity, count, {away, away}));
                    std::vector<KeptJoint> joints;
                    for (const double u : curve.knots().values())
                        if (0.0 < u && u < count && (joints.empty() || joints.back().before.u != u)) {
                            joints.push_back(at_knot(u, level));
                            joints.back().is_new = true;
                        }
                    KeptJoints kept = keep_joints({edited(curve, curve)}, joints);
                    if (!kept.lost.empty()) continue;
                    for (KeptJoint& joint : joints) joint.is_new = false;
                    curve = kept.curves.front();
                    for (int k = 0; k < 25; ++k, ++edits) {
                        const std::size_t i = random.below(curve.control_points().size());
                        const Point target =
                            curve.control_points()[i] + Vector(random.between(-0.3, 0.3), random.between(-0.3, 0.3));
                        kept = keep_joints({edited(curve, with_point(curve, i, target))}, joints);
                        if (!kept.lost.empty()) {
                            ++lost;
                            continue;
                        }
                        curve = kept.curves.front();
                        EXPECT_EQ(curve.control_points()[i], target);
                        // Seen from near, which is exact, so that the test itself rounds little.
                        const Curve seen = seen_from(curve, {away, away});
                        for (const KeptJoint& joint : joints) {
                            EXPECT_NEAR(turn_at(seen, joint.before.u), 0.0, away == 0.0 ? 1e-12 : 1e-8);
                            if (level == 2 && away == 0.0) expect_same_curvature(seen, joint.before.u);
                        }
                    }
                }
    EXPECT_GT(edits, 500U);
    EXPECT_LE(lost, edits / 200) << lost << " of " << edits;
}

TEST(KeepJoints, a_thousand_joints_far_away_keep_every_bit) {
    RandomJoints random;
    Curve curve = made_curve(random.pieces(3, 3, 1001, {}));
    std::vector<KeptJoint> joints;
    for (const double u : curve.knots().values())
        if (0.0 < u && u < 1001 && (joints.empty() || joints.back().before.u != u)) joints.push_back(at_knot(u, 2));
    for (KeptJoint& joint : joints) joint.is_new = true;
    const KeptJoints start = keep_joints({edited(curve, curve)}, joints);
    for (KeptJoint& joint : joints) joint.is_new = false;
    curve = start.curves.front();
    const Curve moved = with_point(curve, 1500, curve.control_points()[1500] + Vector(0.2, 0.4));
    const KeptJoints kept = keep_joints({edited(curve, moved)}, joints);
    for (std::size_t i = 0; i < curve.control_points().size(); ++i)
        if (i < 1300 || i > 1700) {
            ASSERT_EQ(kept.curves.front().control_points()[i], curve.control_points()[i]) << i;
        }
}

}  // namespace
}  // namespace batten::core
