#include "core/edit/knot_edit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/curve/knot_analysis.h"
#include "core/curve/knot_kinds.h"
#include "core/evaluate/evaluate.h"
#include "tests/core/random_curves.h"
#include "tests/core/stored_knots.h"

namespace batten::core {
namespace {

using Knots = std::vector<double>;

std::vector<Point> wave(std::size_t count) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < count; ++i) points.emplace_back(static_cast<double>(i), i % 2 == 0 ? 0.0 : 2.0);
    return points;
}

Curve open_curve(int degree, Knots knots, KnotKind kind = KnotKind::custom) {
    const std::size_t count = knots.size() - static_cast<std::size_t>(degree) - 1;
    return Curve::make({.degree = degree, .knots = std::move(knots), .points = wave(count), .kind = kind}).value();
}

Curve periodic_curve(int degree, Knots period) {
    const std::size_t count = period.size() - 1;
    return Curve::make({.degree = degree, .knots = std::move(period), .points = wave(count), .periodic = true}).value();
}

Knots moved(const Curve& curve, std::size_t index, double u, KnotMove mode, double snap_distance = 0.0) {
    return stored(move_knot(curve, index, u, mode, snap_distance).value());
}

void expect_near(const Knots& found, const Knots& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-14) << "knot " << i;
}

const Knots cubic{0, 0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1};

TEST(MoveKnot, moves_freely_between_neighbors) {
    const Curve curve = open_curve(3, cubic, KnotKind::clamped_uniform);
    for (const KnotMove mode : {KnotMove::stop, KnotMove::push, KnotMove::snap})
        EXPECT_EQ(moved(curve, 5, 0.6, mode), (Knots{0, 0, 0, 0, 0.25, 0.6, 0.75, 1, 1, 1, 1}));
    const Curve result = move_knot(curve, 5, 0.6, KnotMove::stop).value();
    EXPECT_EQ(result.knots().kind(), KnotKind::custom);
    EXPECT_TRUE(std::ranges::equal(result.control_points(), curve.control_points()));
}

TEST(MoveKnot, knot_that_does_not_move_keeps_the_kind) {
    const Curve curve = open_curve(3, cubic, KnotKind::clamped_uniform);
    EXPECT_EQ(move_knot(curve, 5, 0.5, KnotMove::stop).value(), curve);
}

TEST(MoveKnot, snap_joins_the_neighbor) {
    const Curve curve = open_curve(3, cubic);
    EXPECT_EQ(moved(curve, 5, 0.9, KnotMove::snap), (Knots{0, 0, 0, 0, 0.25, 0.75, 0.75, 1, 1, 1, 1}));
    EXPECT_EQ(moved(curve, 5, 0.1, KnotMove::snap), (Knots{0, 0, 0, 0, 0.25, 0.25, 0.75, 1, 1, 1, 1}));
}

TEST(MoveKnot, stop_never_joins) {
    const Curve curve = open_curve(3, cubic);
    EXPECT_EQ(moved(curve, 5, 0.75, KnotMove::stop), (Knots{0, 0, 0, 0, 0.25, 0.745, 0.75, 1, 1, 1, 1}));
    EXPECT_EQ(moved(curve, 5, 0.9, KnotMove::stop), (Knots{0, 0, 0, 0, 0.25, 0.745, 0.75, 1, 1, 1, 1}));
    EXPECT_EQ(moved(curve, 5, 0.1, KnotMove::stop), (Knots{0, 0, 0, 0, 0.25, 0.255, 0.75, 1, 1, 1, 1}));
    EXPECT_EQ(moved(curve, 3, 0.5, KnotMove::stop), (Knots{0, 0, 0, 0.245, 0.25, 0.5, 0.75, 1, 1, 1, 1}));
    EXPECT_EQ(stored(move_knot(curve, 5, 0.75, KnotMove::stop, 0.1, Tears::allow).value())[5], 0.745);
    const Curve ring = periodic_curve(3, {0, 1, 2, 3, 4});
    expect_near(moved(ring, 3, 4.0, KnotMove::stop), {0, 1, 2, 3.98, 4});
}

TEST(MoveKnot, stop_leaves_room_to_move_among_dense_knots) {
    Knots knots{0, 0, 0};
    for (int i = 1; i < 1000; ++i) knots.push_back(i);
    knots.insert(knots.end(), {1000, 1000, 1000});
    const Curve curve = open_curve(2, knots);
    EXPECT_NEAR(moved(curve, 500, 700.0, KnotMove::stop)[500], 498.8, 1e-12);
    EXPECT_NEAR(moved(curve, 500, 100.0, KnotMove::stop)[500], 497.2, 1e-12);
}

TEST(MoveKnot, stop_does_not_join_a_knot_that_is_only_a_rounding_error_away) {
    const double near = std::nextafter(0.5, 0.0);
    const Curve curve = open_curve(2, {0, 0, 0, near, 0.5, 1, 1, 1});
    EXPECT_EQ(move_knot(curve, 3, 0.7, KnotMove::stop).value(), curve);
    EXPECT_EQ(move_knot(curve, 4, 0.3, KnotMove::stop).value(), curve);
    const Curve tiny = open_curve(1, {1e16, 1e16, 1e16 + 2, 1e16 + 4, 1e16 + 4});
    EXPECT_EQ(move_knot(tiny, 2, 2e16, KnotMove::stop).value(), tiny);
}

TEST(MoveKnot, joined_knots_lose_one_order_of_continuity) {
    const Curve curve = open_curve(3, cubic);
    EXPECT_EQ(least_continuity(curve.knots()), 2);
    EXPECT_EQ(least_continuity(move_knot(curve, 5, 0.8, KnotMove::snap)->knots()), 1);
}

TEST(MoveKnot, full_stack_is_approached_but_not_joined) {
    const Curve curve = open_curve(2, {0, 0, 0, 0.25, 0.5, 0.5, 1, 1, 1});
    EXPECT_EQ(moved(curve, 3, 0.7, KnotMove::stop), (Knots{0, 0, 0, 0.495, 0.5, 0.5, 1, 1, 1}));
    EXPECT_EQ(moved(curve, 3, 0.499, KnotMove::stop), (Knots{0, 0, 0, 0.495, 0.5, 0.5, 1, 1, 1}));
    const Curve near = open_curve(2, {0, 0, 0, 0.499, 0.5, 0.5, 1, 1, 1});
    EXPECT_EQ(move_knot(near, 3, 0.7, KnotMove::stop).value(), near) << "what is nearer already stays";
    EXPECT_EQ(moved(near, 3, 0.2, KnotMove::stop)[3], 0.2);
    const Curve mirrored = open_curve(2, {0, 0, 0, 0.5, 0.5, 0.75, 1, 1, 1});
    EXPECT_EQ(moved(mirrored, 5, 0.1, KnotMove::stop), (Knots{0, 0, 0, 0.5, 0.5, 0.505, 1, 1, 1}));
}

TEST(MoveKnot, joins_a_full_stack_where_tears_are_allowed) {
    const Curve curve = open_curve(2, {0, 0, 0, 1, 1, 2, 3, 3, 3});
    EXPECT_EQ(moved(curve, 5, 0.0, KnotMove::stop), (Knots{0, 0, 0, 1, 1, 1.015, 3, 3, 3}));
    const Curve torn = move_knot(curve, 5, 1.0, KnotMove::snap, 0.1, Tears::allow).value();
    EXPECT_EQ(stored(torn), (Knots{0, 0, 0, 1, 1, 1, 3, 3, 3}));
    // Two parabolas: one ends in P2, the other begins in P3.
    EXPECT_EQ(point_at(torn, 1.0, Side::left), Point(2, 0));
    EXPECT_EQ(point_at(torn, 1.0, Side::right), Point(3, 2));
    // No fourth knot joins.
    const Curve more = open_curve(2, {0, 0, 0, 1, 1, 2, 2.5, 3, 3, 3});
    const Curve once = move_knot(more, 5, 1.0, KnotMove::snap, 0.0, Tears::allow).value();
    EXPECT_EQ(stored(move_knot(once, 6, 0.5, KnotMove::snap, 0.0, Tears::allow).value()),
              (Knots{0, 0, 0, 1, 1, 1, 1.015, 3, 3, 3}));
    // From below and the same in the mirror.
    const Curve below = open_curve(2, {0, 0, 0, 1, 2, 2, 3, 3, 3});
    EXPECT_EQ(stored(move_knot(below, 3, 9.0, KnotMove::snap, 0.0, Tears::allow).value()),
              (Knots{0, 0, 0, 2, 2, 2, 3, 3, 3}));
    // The ends stay full at p + 1, and a period never tears.
    EXPECT_EQ(stored(move_knot(below, 5, 3.0, KnotMove::snap, 0.0, Tears::allow).value()),
              (Knots{0, 0, 0, 1, 2, 2.985, 3, 3, 3}));
    const Curve ring = periodic_curve(2, {0, 1, 1, 2, 3});
    EXPECT_EQ(stored(move_knot(ring, 3, 0.5, KnotMove::snap, 0.0, Tears::allow).value()), (Knots{0, 1, 1, 1.015, 3}));
}

TEST(MoveKnot, full_end_is_not_joined) {
    const Curve curve = open_curve(3, cubic);
    EXPECT_EQ(moved(curve, 6, 7.0, KnotMove::stop)[6], 0.995);
    EXPECT_EQ(moved(curve, 4, -7.0, KnotMove::stop)[4], 0.005);
}

TEST(MoveKnot, stack_is_pulled_apart_one_by_one) {
    const Curve curve = open_curve(3, {0, 0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1, 1});
    for (const std::size_t index : {4U, 5U, 6U}) {
        EXPECT_EQ(moved(curve, index, 0.7, KnotMove::stop), (Knots{0, 0, 0, 0, 0.5, 0.5, 0.7, 1, 1, 1, 1}));
        EXPECT_EQ(moved(curve, index, 0.3, KnotMove::push), (Knots{0, 0, 0, 0, 0.3, 0.5, 0.5, 1, 1, 1, 1}));
    }
}

TEST(MoveKnot, snap_jumps_onto_a_knot_within_its_distance) {
    const Curve curve = open_curve(3, cubic);
    EXPECT_EQ(moved(curve, 5, 0.73, KnotMove::snap, 0.03)[5], 0.75);
    EXPECT_EQ(moved(curve, 5, 0.71, KnotMove::snap, 0.03)[5], 0.71);
    EXPECT_EQ(moved(curve, 5, 0.27, KnotMove::snap, 0.03)[5], 0.25);
    EXPECT_EQ(moved(curve, 5, 2.0, KnotMove::snap, 0.03)[5], 0.75) << "and stops at neighbors";
}

TEST(MoveKnot, snap_leaves_a_stack_only_beyond_its_distance) {
    const Curve curve = open_curve(3, {0, 0, 0, 0, 0.5, 0.5, 0.75, 1, 1, 1, 1});
    EXPECT_EQ(move_knot(curve, 5, 0.52, KnotMove::snap, 0.03).value(), curve);
    EXPECT_EQ(moved(curve, 5, 0.54, KnotMove::snap, 0.03), (Knots{0, 0, 0, 0, 0.5, 0.54, 0.75, 1, 1, 1, 1}));
}

TEST(MoveKnot, push_takes_neighbors_along_without_joining_them) {
    const Curve curve = open_curve(3, cubic);
    expect_near(moved(curve, 4, 0.6, KnotMove::push), {0, 0, 0, 0, 0.6, 0.605, 0.75, 1, 1, 1, 1});
    expect_near(moved(curve, 4, 0.8, KnotMove::push), {0, 0, 0, 0, 0.8, 0.805, 0.81, 1, 1, 1, 1});
    expect_near(moved(curve, 6, 0.2, KnotMove::push), {0, 0, 0, 0, 0.19, 0.195, 0.2, 1, 1, 1, 1});
}

TEST(MoveKnot, push_stops_at_the_end_of_the_domain) {
    const Curve curve = open_curve(3, cubic);
    expect_near(moved(curve, 4, 3.0, KnotMove::push), {0, 0, 0, 0, 0.985, 0.99, 0.995, 1, 1, 1, 1});
    expect_near(moved(curve, 6, -3.0, KnotMove::push), {0, 0, 0, 0, 0.005, 0.01, 0.015, 1, 1, 1, 1});
    EXPECT_EQ(moved(curve, 4, 3.0, KnotMove::push)[7], 1.0);
}

TEST(MoveKnot, pushed_stacks_stay_stacks) {
    const Curve curve = open_curve(3, {0, 0, 0, 0, 0.2, 0.5, 0.5, 0.5, 1, 1, 1, 1});
    const Knots found = moved(curve, 4, 0.7, KnotMove::push);
    EXPECT_EQ(found[5], found[6]);
    EXPECT_EQ(found[6], found[7]);
    EXPECT_NEAR(found[5], 0.705, 1e-15);
}

TEST(MoveKnot, end_knots_move_the_domain) {
    const Curve curve = open_curve(3, cubic);
    const Curve later = move_knot(curve, 0, 0.1, KnotMove::stop).value();
    EXPECT_EQ(stored(later), (Knots{0, 0, 0, 0.1, 0.25, 0.5, 0.75, 1, 1, 1, 1}));
    EXPECT_EQ(later.domain(), (Interval{0.1, 1.0}));
    const Curve longer = move_knot(curve, 9, 4.0, KnotMove::stop).value();
    EXPECT_EQ(longer.knots()[10], 4.0);
    EXPECT_EQ(longer.domain(), (Interval{0.0, 1.0}));
}

TEST(MoveKnot, domain_never_becomes_empty) {
    const Curve curve = open_curve(1, {0, 0, 1, 1});
    EXPECT_EQ(moved(curve, 2, -3.0, KnotMove::stop), (Knots{0, 0, 0.005, 1}));
    EXPECT_EQ(moved(curve, 1, 3.0, KnotMove::stop), (Knots{0, 0.995, 1, 1}));
    const Curve uniform = open_curve(3, {-3, -2, -1, 0, 1, 2, 3, 4});
    EXPECT_EQ(moved(uniform, 3, 9.0, KnotMove::stop)[3], 0.995);
    expect_near(moved(uniform, 2, 9.0, KnotMove::push), {-3, -2, -0.005, 0, 1, 2, 3, 4});
}

TEST(MoveKnot, period_keeps_its_length_when_the_seam_moves) {
    const Curve curve = periodic_curve(3, {0, 1, 2, 3, 4});
    EXPECT_EQ(moved(curve, 0, 0.5, KnotMove::stop), (Knots{0.5, 1, 2, 3, 4.5}));
    EXPECT_EQ(moved(curve, 4, 4.5, KnotMove::stop), (Knots{0.5, 1, 2, 3, 4.5}));
    EXPECT_EQ(moved(curve, 0, -0.5, KnotMove::stop), (Knots{-0.5, 1, 2, 3, 3.5}));
    EXPECT_EQ(moved(curve, 0, 7.0, KnotMove::snap), (Knots{1, 1, 2, 3, 5}));
    EXPECT_EQ(moved(curve, 0, -7.0, KnotMove::snap), (Knots{-1, 1, 2, 3, 3}));
    expect_near(moved(curve, 0, 7.0, KnotMove::stop), {0.98, 1, 2, 3, 4.98});
    expect_near(moved(curve, 0, -7.0, KnotMove::stop), {-0.98, 1, 2, 3, 3.02});
}

TEST(MoveKnot, stack_across_the_seam_is_one_stack) {
    const Curve below = periodic_curve(3, {0, 0, 1, 2, 3});
    EXPECT_EQ(moved(below, 0, 0.5, KnotMove::stop), (Knots{0, 0.5, 1, 2, 3}));
    EXPECT_EQ(moved(below, 4, 3.5, KnotMove::stop), (Knots{0, 0.5, 1, 2, 3})) << "the same place one period on";
    EXPECT_EQ(moved(below, 1, -0.5, KnotMove::stop), (Knots{-0.5, 0, 1, 2, 2.5}));
    const Curve above = periodic_curve(3, {0, 1, 2, 3, 3});
    EXPECT_EQ(moved(above, 0, -0.5, KnotMove::stop), (Knots{0, 1, 2, 2.5, 3}));
    EXPECT_EQ(moved(above, 3, 3.5, KnotMove::stop), (Knots{0.5, 1, 2, 3, 3.5}));
}

TEST(MoveKnot, push_on_a_period_stops_at_the_seam_and_the_seam_pushes) {
    const Curve curve = periodic_curve(3, {0, 1, 2, 3, 4});
    expect_near(moved(curve, 1, 9.0, KnotMove::push), {0, 3.94, 3.96, 3.98, 4});
    expect_near(moved(curve, 0, 1.5, KnotMove::push), {1.5, 1.52, 2, 3, 5.5});
    expect_near(moved(curve, 0, -1.5, KnotMove::push), {-1.5, 1, 2, 2.48, 2.5});
    expect_near(moved(curve, 0, 1e300, KnotMove::push), {4, 4.02, 4.04, 4.06, 8});
}

TEST(MoveKnot, any_move_of_any_knot_gives_a_curve) {
    RandomCurves random(81);
    for (int i = 0; i < 3000; ++i) {
        const Curve curve = random.curve();
        const Knots before = stored(curve);
        const auto index = static_cast<std::size_t>(random.whole(0, static_cast<int>(before.size()) - 1));
        const double u = random.whole(0, 1) == 0 ? random.number(-15.0, 15.0) : random.parameter(curve);
        const auto mode = std::vector{KnotMove::stop, KnotMove::push, KnotMove::snap}[static_cast<std::size_t>(i % 3)];
        const auto result = move_knot(curve, index, u, mode, 0.2);
        ASSERT_TRUE(result.has_value()) << describe(result.error());
        EXPECT_TRUE(std::ranges::equal(result->control_points(), curve.control_points()));
        for (const DistinctKnot& knot : distinct_knots(result->knots()))
            EXPECT_LE(knot.multiplicity, curve.degree() + (knot.is_interior ? 0 : 1));
        if (mode == KnotMove::push || curve.is_periodic()) continue;
        std::size_t changed = 0;
        for (std::size_t k = 0; k < before.size(); ++k) changed += stored(*result)[k] != before[k] ? 1U : 0U;
        EXPECT_LE(changed, 1U);
    }
}

TEST(MoveKnot, is_the_same_in_the_mirror) {
    RandomCurves random(82);
    for (int i = 0; i < 500; ++i) {
        const Curve curve = random.open_curve();
        CurveDefinition mirror = curve.definition();
        std::reverse(mirror.knots.begin(), mirror.knots.end());
        for (double& knot : mirror.knots) knot = -knot;
        const std::size_t last = mirror.knots.size() - 1;
        const auto index = static_cast<std::size_t>(random.whole(0, static_cast<int>(last)));
        const double u = random.number(-12.0, 12.0);
        const auto mode = i % 2 == 0 ? KnotMove::stop : KnotMove::push;
        const Knots there = moved(Curve::make(mirror).value(), last - index, -u, mode);
        const Knots here = moved(curve, index, u, mode);
        for (std::size_t k = 0; k <= last; ++k) EXPECT_EQ(here[k], -there[last - k]);
    }
}

TEST(MoveKnot, refuses_what_is_not_there) {
    const Curve curve = open_curve(3, cubic);
    EXPECT_EQ(move_knot(curve, 11, 0.5, KnotMove::stop).error(),
              (CurveError{.code = CurveErrorCode::knot_index_out_of_range, .index = 11, .upper = 10}));
    EXPECT_EQ(move_knot(curve, 5, std::nan(""), KnotMove::snap).error().code, CurveErrorCode::parameter_not_finite);
    EXPECT_EQ(move_knot(curve, 5, std::numeric_limits<double>::infinity(), KnotMove::stop).error().code,
              CurveErrorCode::parameter_not_finite);
}

TEST(SetKnot, sets_exactly_what_was_typed) {
    const Curve curve = open_curve(3, cubic, KnotKind::clamped_uniform);
    EXPECT_EQ(stored(set_knot(curve, 5, 0.7499999999).value())[5], 0.7499999999);
    EXPECT_EQ(set_knot(curve, 5, 0.75)->knots().multiplicity(0.75), 2);
    EXPECT_EQ(set_knot(curve, 5, 0.75)->knots().kind(), KnotKind::custom);
    EXPECT_EQ(set_knot(curve, 5, 0.5).value(), curve);
}

TEST(SetKnot, takes_the_knot_of_a_stack_at_that_side) {
    const Curve curve = open_curve(3, {0, 0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1, 1});
    EXPECT_EQ(stored(set_knot(curve, 4, 0.7).value()), (Knots{0, 0, 0, 0, 0.5, 0.5, 0.7, 1, 1, 1, 1}));
    EXPECT_EQ(stored(set_knot(curve, 6, 0.3).value()), (Knots{0, 0, 0, 0, 0.3, 0.5, 0.5, 1, 1, 1, 1}));
}

TEST(SetKnot, refuses_disorder_and_too_many_equal_knots) {
    const Curve curve = open_curve(3, cubic);
    EXPECT_EQ(set_knot(curve, 5, 0.8).error(),
              (CurveError{.code = CurveErrorCode::knot_decreasing, .index = 6, .value = 0.75, .lower = 0.8}));
    EXPECT_EQ(set_knot(curve, 5, 0.2).error(),
              (CurveError{.code = CurveErrorCode::knot_decreasing, .index = 5, .value = 0.2, .lower = 0.25}));
    EXPECT_EQ(set_knot(curve, 6, 1.0).error().code, CurveErrorCode::multiplicity_too_high);
    EXPECT_EQ(set_knot(curve, 99, 1.0).error().code, CurveErrorCode::knot_index_out_of_range);
    EXPECT_EQ(set_knot(curve, 5, std::nan("")).error().code, CurveErrorCode::parameter_not_finite);
    EXPECT_EQ(set_knot(open_curve(1, {0, 0, 1, 1}), 2, 0.0).error().code, CurveErrorCode::domain_empty);
}

TEST(SetKnot, tears_where_it_is_allowed) {
    const Curve curve = open_curve(2, {0, 0, 0, 1, 1, 2, 3, 3, 3});
    EXPECT_EQ(set_knot(curve, 5, 1.0).error().code, CurveErrorCode::multiplicity_too_high);
    EXPECT_EQ(stored(set_knot(curve, 5, 1.0, Tears::allow).value()), (Knots{0, 0, 0, 1, 1, 1, 3, 3, 3}));
    EXPECT_FALSE(set_knots(curve, {0, 0, 0, 1, 1, 1, 2, 2, 2}).has_value());
    EXPECT_TRUE(set_knots(curve, {0, 0, 0, 1, 1, 1, 2, 2, 2}, Tears::allow)->is_torn());
}

TEST(SetKnot, end_of_a_period_changes_its_length) {
    const Curve curve = periodic_curve(3, {0, 1, 2, 3, 4});
    EXPECT_EQ(stored(set_knot(curve, 4, 6.0).value()), (Knots{0, 1, 2, 3, 6}));
    EXPECT_EQ(stored(set_knot(curve, 0, -1.0).value()), (Knots{-1, 1, 2, 3, 4}));
}

TEST(DeleteKnot, takes_the_point_that_it_carries_most) {
    const Curve curve = open_curve(3, cubic);
    // Greville abscissae 0, 1/12, 1/4, 1/2, 3/4, 11/12, 1.
    const Curve result = delete_knot(curve, 5).value();
    EXPECT_EQ(stored(result), (Knots{0, 0, 0, 0, 0.25, 0.75, 1, 1, 1, 1}));
    const std::vector<Point> expected{{0, 0}, {1, 2}, {2, 0}, {4, 0}, {5, 2}, {6, 0}};
    EXPECT_TRUE(std::ranges::equal(result.control_points(), expected));
}

TEST(DeleteKnot, keeps_the_end_points_of_a_clamped_curve) {
    const Curve curve = open_curve(3, cubic);
    const auto count = static_cast<std::size_t>(11);
    for (std::size_t index = 0; index < count; ++index) {
        const Curve result = delete_knot(curve, index).value();
        EXPECT_EQ(result.control_points().front(), curve.control_points().front());
        EXPECT_EQ(result.control_points().back(), curve.control_points().back());
    }
}

TEST(DeleteKnot, refuses_the_last_that_can_be_spared) {
    const Curve bezier = open_curve(3, {0, 0, 0, 0, 1, 1, 1, 1});
    EXPECT_EQ(delete_knot(bezier, 2).error(), (CurveError{.code = CurveErrorCode::knot_not_removable, .index = 2}));
    EXPECT_EQ(delete_knot(bezier, 8).error().code, CurveErrorCode::knot_index_out_of_range);
    EXPECT_EQ(delete_knot(periodic_curve(3, {0, 1, 2}), 1).error().code, CurveErrorCode::knot_not_removable);
    // Without the first 1 the domain of {0, 1, 2, 2, 3} would shrink from [1, 2] to [2, 2].
    const Curve short_domain = open_curve(1, {0, 1, 2, 2, 3});
    EXPECT_EQ(delete_knot(short_domain, 1).error(),
              (CurveError{.code = CurveErrorCode::knot_not_removable, .index = 1}));
}

TEST(DeleteKnot, next_knot_becomes_the_seam_and_the_period_stays) {
    const Curve curve = periodic_curve(3, {0, 1, 2, 3, 5});
    EXPECT_EQ(stored(delete_knot(curve, 0).value()), (Knots{1, 2, 3, 6}));
    EXPECT_EQ(stored(delete_knot(curve, 4).value()), (Knots{1, 2, 3, 6}));
    EXPECT_EQ(stored(delete_knot(curve, 2).value()), (Knots{0, 1, 3, 5}));
}

TEST(DeleteKnot, any_knot_can_go_while_there_are_enough) {
    RandomCurves random(83);
    for (int i = 0; i < 1000; ++i) {
        const Curve curve = random.curve();
        const std::size_t size = curve.knots().stored().size();
        const auto index = static_cast<std::size_t>(random.whole(0, static_cast<int>(size) - 1));
        const auto result = delete_knot(curve, index);
        if (!result) {
            EXPECT_EQ(result.error().code, CurveErrorCode::knot_not_removable);
            continue;
        }
        EXPECT_EQ(result->knots().stored().size(), size - 1);
        EXPECT_EQ(result->control_points().size(), curve.control_points().size() - 1);
    }
}

TEST(DeleteKnot, far_part_of_the_curve_stays) {
    // Deleting the knot 3 and its point leaves the curve beyond their support as it was.
    for (const bool periodic : {false, true}) {
        Knots knots;
        for (int i = 0; i <= (periodic ? 20 : 24); ++i) knots.push_back(i);
        const Curve curve = periodic ? periodic_curve(3, knots) : open_curve(3, knots);
        const std::size_t index = 10;
        const double u = curve.knots().stored()[index];
        const Curve result = delete_knot(curve, index).value();
        for (const double far : {u - 6.5, u - 5.0, u + 5.0, u + 6.5})
            EXPECT_NEAR(distance(point_at(curve, far), point_at(result, far)), 0.0, 1e-13) << periodic << far;
    }
}

TEST(SetKnotKind, regenerates_over_the_same_domain) {
    const Curve curve = open_curve(3, {2, 2, 2, 2, 3, 5, 9, 10, 10, 10, 10});
    const Curve uniform = set_knot_kind(curve, KnotKind::clamped_uniform).value();
    EXPECT_EQ(stored(uniform), (Knots{2, 2, 2, 2, 4, 6, 8, 10, 10, 10, 10}));
    EXPECT_EQ(uniform.knots().kind(), KnotKind::clamped_uniform);
    EXPECT_EQ(set_knot_kind(curve, KnotKind::periodic)->is_periodic(), true);
    EXPECT_EQ(set_knot_kind(curve, KnotKind::bezier).error().code, CurveErrorCode::kind_not_possible);
}

TEST(SetKnotKind, custom_keeps_the_values) {
    const Curve curve = open_curve(3, cubic, KnotKind::clamped_uniform);
    const Curve custom = set_knot_kind(curve, KnotKind::custom).value();
    EXPECT_EQ(stored(custom), cubic);
    EXPECT_EQ(custom.knots().kind(), KnotKind::custom);
}

TEST(SetKnots, takes_any_valid_vector_of_the_same_length) {
    const Curve curve = open_curve(3, cubic, KnotKind::clamped_uniform);
    const Knots typed{0, 0, 0, 0, 0.1, 0.1, 0.1, 5, 5, 5, 5};
    EXPECT_EQ(stored(set_knots(curve, typed).value()), typed);
    EXPECT_EQ(set_knots(curve, typed)->knots().kind(), KnotKind::custom);
    EXPECT_EQ(set_knots(curve, {0, 0, 0, 0, 1, 1, 1, 1}).error(),
              (CurveError{.code = CurveErrorCode::knot_count_mismatch, .value = 8, .lower = 11}));
    EXPECT_EQ(set_knots(curve, {0, 0, 0, 0, 0.5, 0.25, 0.75, 1, 1, 1, 1}).error().code,
              CurveErrorCode::knot_decreasing);
}

TEST(SetPeriodic, uses_the_same_points_over_the_same_domain) {
    const Curve curve = open_curve(3, cubic);
    const Curve closed = set_periodic(curve, true).value();
    EXPECT_TRUE(closed.is_periodic());
    EXPECT_EQ(closed.knots().kind(), KnotKind::periodic);
    EXPECT_EQ(closed.domain(), curve.domain());
    EXPECT_TRUE(std::ranges::equal(closed.control_points(), curve.control_points()));
    EXPECT_LT(distance(point_at(closed, 0.0), point_at(closed, 1.0)), 1e-15);
    const Curve open = set_periodic(closed, false).value();
    EXPECT_EQ(open.knots().kind(), KnotKind::clamped_uniform);
    EXPECT_EQ(open.domain(), curve.domain());
    EXPECT_EQ(set_periodic(curve, false).value(), curve);
    EXPECT_EQ(set_periodic(periodic_curve(3, {0, 1, 2, 3}), false).error().code, CurveErrorCode::too_few_points);
}

TEST(MakeUniform, keeps_the_sort_of_ends) {
    const std::vector<Point> points{{0, 0}, {1, 5}, {2, -3}, {3, 4}, {4, 4}};
    const auto made = [&](int degree, Knots knots, bool periodic) {
        return Curve::make({.degree = degree, .knots = std::move(knots), .points = points, .periodic = periodic})
            .value();
    };
    const Curve clamped = make_uniform(made(2, {0, 0, 0, 1, 5, 6, 6, 6}, false)).value();
    EXPECT_EQ(stored(clamped), (Knots{0, 0, 0, 2, 4, 6, 6, 6}));
    EXPECT_EQ(clamped.knots().kind(), KnotKind::clamped_uniform);
    EXPECT_EQ(stored(make_uniform(made(2, {-3, -1, 0, 1, 5, 6, 8, 9}, false)).value()),
              (Knots{-4, -2, 0, 2, 4, 6, 8, 10}));
    const Curve ring = make_uniform(made(2, {0, 1, 2, 3, 9, 10}, true)).value();
    EXPECT_EQ(stored(ring), (Knots{0, 2, 4, 6, 8, 10}));
    EXPECT_TRUE(std::ranges::equal(ring.control_points(), points));
}

}  // namespace
}  // namespace batten::core
