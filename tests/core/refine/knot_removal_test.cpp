#include "core/refine/knot_removal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/evaluate/evaluate.h"
#include "core/measure/deviation.h"
#include "core/refine/detail/removal_reach.h"
#include "core/refine/knot_insertion.h"
#include "core/refine/knot_refinement.h"
#include "tests/core/shape_check.h"

namespace batten::core {
namespace {

bool is_seam(const Curve& curve, double u) {
    return curve.is_periodic() && (u == curve.domain().lower || u == curve.domain().upper);
}

TEST(KnotRemoval, undoes_insertion) {
    RandomCurves random(311);
    int removed = 0;
    for (int k = 0; k < 600; ++k) {
        const Curve curve = random.curve();
        const double u = random.parameter(curve);
        const int free = curve.degree() - curve.knots().multiplicity(u);
        const bool is_end = u == curve.domain().lower || u == curve.domain().upper;
        if (free < 1 || (is_end && !curve.is_periodic())) continue;
        const int times = random.whole(1, free);
        const Curve inserted = insert_knot(curve, u, times).value();
        const auto result = remove_knot(inserted, u, times, 1e-9);
        ASSERT_TRUE(result) << describe(result.error());
        EXPECT_EQ(result->count, times);
        EXPECT_LE(result->error, 1e-12);
        EXPECT_FALSE(result->refused);
        EXPECT_EQ(stored(result->curve), stored(curve));
        EXPECT_LE(point_difference(curve, result->curve), 1e-12);
        ++removed;
    }
    EXPECT_GT(removed, 300);
}

TEST(KnotRemoval, undoes_insertion_to_the_last_digits) {
    RandomCurves random(312);
    double worst = 0.0;
    for (int k = 0; k < 300; ++k) {
        CurveDefinition definition = random.open_curve().definition();
        std::fill(definition.weights.begin(), definition.weights.end(), 1.0);
        const Curve curve = Curve::make(definition).value();
        const double u = random.number(curve.domain().lower, curve.domain().upper);
        const Curve inserted = insert_knot(curve, u).value();
        worst = std::max(worst, point_difference(curve, remove_knot(inserted, u, 1, 1e-9)->curve));
    }
    EXPECT_LE(worst, 4e-15);
}

TEST(KnotRemoval, spreads_the_error_of_a_polyline_by_hand) {
    // Without the corner at (1, 1) the line from (0, 0) to (2, 0) misses it by 1, and nothing better has these ends.
    const Curve line = Curve::make({.degree = 1, .knots = {0, 0, 1, 2, 2}, .points = {{0, 0}, {1, 1}, {2, 0}}}).value();
    const auto refused = remove_knot(line, 1.0, 1, 0.99).value();
    EXPECT_EQ(refused.count, 0);
    EXPECT_EQ(refused.refused, 1.0);
    EXPECT_EQ(refused.curve, line);
    const auto removed = remove_knot(line, 1.0, 1, 1.0).value();
    EXPECT_EQ(removed.count, 1);
    EXPECT_EQ(removed.error, 1.0);
    EXPECT_EQ(stored(removed.curve), (std::vector<double>{0, 0, 2, 2}));
}

TEST(KnotRemoval, spreads_the_error_of_a_parabola_by_hand) {
    // Knot 1 of 0,0,0,1,2,2,2 over (0,0) (1,0) (1,1) (0,1): alpha = 1/2, 1/2, so Q1 solves P1 = Q1/2 + (0,0)/2 and
    // P2 = Q1/2 + (0,1)/2, that is Q1 = (2, 0) and Q1 = (2, 1): the middle (2, 1/2) leaves errors -+(0, 1/4).
    const Curve curve =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 2, 2, 2}, .points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}}).value();
    const auto removed = remove_knot(curve, 1.0, 1, 0.25).value();
    ASSERT_EQ(removed.count, 1);
    EXPECT_EQ(removed.curve.control_points()[1], Point(2, 0.5));
    EXPECT_LT(removed.error, 0.25);
    EXPECT_GT(removed.error, 0.05);
    EXPECT_EQ(removed.error, largest_deviation(curve, removed.curve));
}

TEST(KnotRemoval, spreads_the_error_in_proportion_to_the_weights_by_hand) {
    // The same with a weight of 3 at (1, 1). From (1, 0, 1) - e = Q1/2 + (0, 0, 1)/2 and
    // (3, 3, 3) + 3 e = Q1/2 + (0, 1, 1)/2 follow e = -(0.5, 0.625, 0.5) and Q1 = (3, 1.25, 2).
    const Curve curve = Curve::make({.degree = 2,
                                     .knots = {0, 0, 0, 1, 2, 2, 2},
                                     .points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                                     .weights = {1, 1, 3, 1}})
                            .value();
    const auto removed = remove_knot(curve, 1.0, 1, 1.0).value();
    ASSERT_EQ(removed.count, 1);
    EXPECT_EQ(removed.curve.control_points()[1], Point(1.5, 0.625));
    EXPECT_EQ(removed.curve.weights()[1], 2.0);
    EXPECT_EQ(removed.error, largest_deviation(curve, removed.curve));
}

TEST(KnotRemoval, weighs_the_equations_of_a_short_period_by_hand) {
    // A0 = Q0 and A1, A2 = Q0/3 + 2 Q1/3, divided by 1, 2 and 4: Q1 is where 4 (Q0 + 2 Q1 - 3 A1) = -(Q0 + 2 Q1 - 3
    // A2), so Q0 = (0, 0, 1) and Q1 = (9.6, 4.8, 3.1).
    const Curve ring = Curve::make({.degree = 2,
                                    .knots = {0, 1, 2, 3},
                                    .points = {{0, 0}, {4, 0}, {0, 4}},
                                    .weights = {1, 2, 4},
                                    .periodic = true})
                           .value();
    const auto removed = remove_knot(ring, 1.0, 1, 10.0).value();
    ASSERT_EQ(removed.count, 1);
    const auto points = removed.curve.control_points();
    EXPECT_LE(distance(points[0], {0, 0}), 1e-14);
    EXPECT_LE(distance(points[1], {9.6 / 3.1, 4.8 / 3.1}), 1e-14);
    EXPECT_NEAR(removed.curve.weights()[0], 1.0, 1e-14);
    EXPECT_NEAR(removed.curve.weights()[1], 3.1, 1e-14);
}

TEST(KnotRemoval, of_a_corner_of_little_weight_tells_how_far_the_curve_moves) {
    // From (1, 1) to (1, 0) at u = 1, and nowhere farther.
    const Curve line =
        Curve::make(
            {.degree = 1, .knots = {0, 0, 1, 2, 2}, .points = {{0, 0}, {1, 1}, {2, 0}}, .weights = {1, 0.01, 1}})
            .value();
    EXPECT_NEAR(remove_knot(line, 1.0, 1, 0.99)->refused.value(), 1.0, 1e-12);
    EXPECT_EQ(remove_knot(line, 1.0, 1, 1.01)->count, 1);
    EXPECT_EQ(remove_knots(line, 1.01)->count, 1);
}

TEST(KnotRemoval, reports_the_error_it_makes_and_never_more_than_the_tolerance) {
    RandomCurves random(313);
    for (int k = 0; k < 400; ++k) {
        const Curve curve = random.curve();
        const auto knots = curve.knots().stored();
        const double u = knots[static_cast<std::size_t>(random.whole(0, static_cast<int>(knots.size()) - 1))];
        const double tolerance = random.number(0.01, 3.0);
        const auto result = remove_knot(curve, u, random.whole(1, 3), tolerance);
        if (!result) {
            const auto code = result.error().code;
            EXPECT_TRUE(code == CurveErrorCode::knot_not_found || code == CurveErrorCode::knot_not_removable);
            continue;
        }
        EXPECT_LE(result->error, tolerance);
        EXPECT_EQ(result->error, largest_deviation(curve, result->curve));
        EXPECT_EQ(result->curve.control_points().size() + static_cast<std::size_t>(result->count),
                  curve.control_points().size());
        if (result->count == 0) {
            EXPECT_EQ(result->curve, curve);
            EXPECT_GT(result->refused.value(), tolerance);
        }
        EXPECT_EQ(result->curve.domain(), curve.domain());
    }
}

TEST(KnotRemoval, leaves_points_out_of_reach_alone) {
    RandomCurves random(314);
    CurveDefinition definition = high_degree_curve(3, 30, random).definition();
    definition.weights.clear();
    const Curve curve = Curve::make(definition).value();
    const auto removed = remove_knot(curve, curve.knots()[15], 1, 100.0).value();
    ASSERT_EQ(removed.count, 1);
    // Points 12, 13, 14 become two.
    for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(removed.curve.control_points()[i], curve.control_points()[i]);
    for (std::size_t i = 15; i < 33; ++i) EXPECT_EQ(removed.curve.control_points()[i - 1], curve.control_points()[i]);
}

// Of the points that a long curve is made of, only those near the knot are carried and measured: what comes out is, bit
// by bit, what comes out of the part around it alone.
TEST(KnotRemoval, of_a_long_curve_is_that_of_the_part_around_the_knot) {
    RandomCurves random(67);
    int removed = 0;
    for (int k = 0; k < 300; ++k) {
        const Curve curve = insert_midpoint_knots(insert_midpoint_knots(random.curve()).value()).value();
        const auto stored = curve.knots().stored();
        const double u = stored[static_cast<std::size_t>(random.whole(0, static_cast<int>(stored.size()) - 1))];
        const auto reach = curve_in_reach(curve, u);
        if (!reach) continue;
        const auto whole = remove_knot(curve, u, 2, 4.0).value();
        const auto part = remove_knot(reach->curve, u, 2, 4.0).value();
        EXPECT_EQ(whole.count, part.count);
        EXPECT_EQ(whole.error, part.error);
        EXPECT_EQ(whole.error, largest_deviation(curve, whole.curve));
        const std::size_t n = whole.curve.control_points().size();
        const auto points = part.curve.control_points();
        for (std::size_t i = 0; i < points.size(); ++i)
            EXPECT_EQ(whole.curve.control_points()[(reach->first_point + i) % n], points[i]);
        removed += whole.count;
    }
    EXPECT_GE(removed, 100);
}

TEST(KnotRemoval, of_many_knots_finds_all_that_were_inserted) {
    RandomCurves random(315);
    int found = 0;
    for (int k = 0; k < 200; ++k) {
        const Curve curve = random.curve();
        std::vector<double> added;
        for (int i = 0; i < 5; ++i) added.push_back(random.number(curve.domain().lower, curve.domain().upper));
        const auto refined = refine_knots(curve, added);
        ASSERT_TRUE(refined);
        const auto result = remove_knots(*refined, 1e-9).value();
        EXPECT_GE(result.count, 5);
        EXPECT_LE(result.error, 1e-9);
        EXPECT_EQ(result.error, largest_deviation(*refined, result.curve));
        found += result.count;
    }
    EXPECT_LT(found, 200 * 8);
}

TEST(KnotRemoval, of_many_knots_stays_within_the_tolerance_in_total) {
    // A sampled wave: every single knot could go, but not all of them.
    const std::size_t n = 400;
    CurveDefinition definition{.degree = 3, .knots = std::vector(4, 0.0)};
    for (std::size_t i = 1; i < n - 3; ++i) definition.knots.push_back(static_cast<double>(i));
    definition.knots.insert(definition.knots.end(), 4, static_cast<double>(n - 3));
    for (std::size_t i = 0; i < n; ++i) {
        const double x = static_cast<double>(i) / 40.0;
        definition.points.emplace_back(x, std::sin(x));
    }
    const Curve wave = Curve::make(definition).value();
    std::size_t before = n;
    for (const double tolerance : {1e-9, 1e-6, 1e-4, 1e-2}) {
        const auto result = remove_knots(wave, tolerance).value();
        EXPECT_LE(result.error, tolerance);
        EXPECT_LT(result.curve.control_points().size(), before);
        before = result.curve.control_points().size();
    }
    EXPECT_LT(before, 20U);
}

TEST(KnotRemoval, of_many_knots_of_random_curves_stays_within_the_tolerance) {
    RandomCurves random(316);
    for (int k = 0; k < 300; ++k) {
        const Curve curve = random.curve();
        const double tolerance = std::pow(10.0, random.number(-3.0, 1.0));
        const auto result = remove_knots(curve, tolerance).value();
        EXPECT_LE(result.error, tolerance);
        EXPECT_LE(largest_deviation(curve, result.curve), tolerance);
        EXPECT_EQ(result.curve.domain(), curve.domain());
        EXPECT_EQ(result.curve.is_periodic(), curve.is_periodic());
    }
}

TEST(KnotRemoval, works_far_away_and_over_large_and_small_domains) {
    RandomCurves random(317);
    for (const double scale : {1e-9, 1.0, 1e9}) {
        const Curve plain = high_degree_curve(4, 8, random);
        CurveDefinition definition = plain.definition();
        for (double& knot : definition.knots) knot *= scale;
        for (Point& point : definition.points) point += Vector(1e6, -1e6);
        const Curve curve = Curve::make(definition).value();
        const double u = 0.5 * curve.domain().upper;
        const Curve back = remove_knot(insert_knot(curve, u, 2).value(), u, 2, 1e-6)->curve;
        EXPECT_EQ(stored(back), stored(curve));
        EXPECT_LE(point_difference(curve, back), 2e-15);
    }
}

// Beside weights of 500 one of 0.002 hardly counts, though what it is multiplied by may be large: the coordinates are
// known to 10^-10 here, and so well does the curve without the knots follow.
TEST(KnotRemoval, small_weights_among_large_ones_are_no_reason_to_keep_a_knot) {
    const Curve curve =
        Curve::make({.degree = 7,
                     .knots = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1.3333333333333333, 3, 3, 3, 3, 3, 3, 3, 3},
                     .points = {{1000001.4489264324, -999999.7738650728},
                                {1000002.0738663864, -999998.9937083352},
                                {1000001.6111416982, -999998.1580442335},
                                {1000000.7401160707, -999997.9154716757},
                                {1000000.3543966466, -999997.8677029845},
                                {999999.3893305954, -999997.8055238627},
                                {999999.1637442253, -999997.5668782466},
                                {999999.1511675315, -999997.0972043838},
                                {999999.4602591633, -999996.2752802414},
                                {999999.7541240414, -999995.0300780557}},
                     .weights = {5.4687224234248, 421.06999065290364, 563.2322144773456, 0.4130336653916019,
                                 2.7729261000766434, 1.5644371068657996, 2.743573453566403, 0.9749196742894978,
                                 6.3426939942456855, 0.0022816971355563696}})
            .value();
    const double tolerance = 6e-8;
    Curve finer = curve;
    for (const double u : {0.5, 1.0, 1.3333333333333333, 2.0, 2.5}) finer = insert_knot(finer, u).value();
    const auto found = remove_knots(finer, tolerance);
    ASSERT_TRUE(found.has_value()) << describe(found.error());
    EXPECT_LE(found->curve.control_points().size(), curve.control_points().size());
    for (int k = 0; k <= 300; ++k)
        EXPECT_LE(distance(point_at(found->curve, 0.01 * k), point_at(curve, 0.01 * k)), tolerance) << k;
}

// Coordinates of 10^6 are known to 1.2e-10, and so is the curve with the knots, however its weights differ. A step of
// two of these is as near as the curve without them can be told to be.
TEST(KnotRemoval, undoes_insertion_among_weights_that_differ_by_much) {
    const Curve curve =
        Curve::make({.degree = 10,
                     .knots = {1000, 1000, 1000, 1000, 1000, 1000, 1000, 1000, 1000, 1000, 1000,
                               1001, 1001, 1001, 1001, 1001, 1001, 1001, 1001, 1001, 1001, 1001},
                     .points = {{1000000.8678833832, -999999.7148452249},
                                {1000000.1055462803, -1000000.9256733361},
                                {999999.1927117375, -1000000.6162036683},
                                {999999.8048841273, -999999.7634403744},
                                {999999.217703875, -1000000.8387410605},
                                {1000000.0452604382, -999999.9555667712},
                                {999999.8647154525, -1000000.021312463},
                                {999999.9627369139, -999999.8460683338},
                                {1000000.0215148593, -1000000.6718499204},
                                {999999.6055963712, -1000000.650341892},
                                {999999.647282572, -999999.3462069948}},
                     .weights = {0.17674198861779605, 0.07281303573864521, 1.9663597133385942, 645.6330617213665,
                                 10.824853932647363, 0.32713818540307404, 0.03909476145567305, 857.6870731570143,
                                 2.7581723316548055, 144.3384547626475, 0.001220128141132485}})
            .value();
    const double u = 1000.7399274208573;
    const auto back = remove_knot(insert_knot(curve, u, 2).value(), u, 2, 1e-8);
    ASSERT_EQ(back->count, 2);
    for (int k = 0; k <= 400; ++k) {
        const double at = 1000.0 + k / 400.0;
        EXPECT_LE(distance(point_at(back->curve, at), point_at(curve, at)), 4.7e-10) << k;
    }
}

TEST(KnotRemoval, pulls_the_sides_of_a_tear_to_the_middle_whatever_they_weigh) {
    const Curve torn = Curve::make({.degree = 1,
                                    .knots = {0, 0, 1, 1, 2, 2},
                                    .points = {{0, 0}, {2, 0}, {2, 1}, {4, 1}},
                                    .weights = {1, 1, 3, 1},
                                    .tears = Tears::allow})
                           .value();
    const auto closed = remove_knot(torn, 1.0, 1, 10.0).value();
    ASSERT_EQ(closed.count, 1);
    EXPECT_EQ(closed.curve.control_points()[1], Point(2, 0.5));
    EXPECT_EQ(closed.curve.weights()[1], 1.5);
}

TEST(KnotRemoval, closes_a_tear_whose_sides_meet) {
    const Curve torn = Curve::make({.degree = 2,
                                    .knots = {0, 0, 0, 1, 1, 1, 2, 2, 2},
                                    .points = {{0, 0}, {1, 2}, {2, 0}, {2, 0}, {3, -2}, {4, 0}},
                                    .tears = Tears::allow})
                           .value();
    const auto result = remove_knot(torn, 1.0, 1, 1e-12).value();
    EXPECT_EQ(result.count, 1);
    EXPECT_EQ(result.error, 0.0);
    EXPECT_EQ(result.curve.control_points().size(), 5U);
    EXPECT_EQ(remove_knot(torn, 1.0, 2, 1e-12)->count, 2);
}

TEST(KnotRemoval, of_a_seam_leaves_one_knot) {
    RandomCurves random(318);
    int removed = 0;
    for (int k = 0; k < 300; ++k) {
        const Curve curve = random.periodic_curve();
        for (const double u : {curve.domain().lower, curve.domain().upper}) {
            ASSERT_TRUE(is_seam(curve, u));
            const int multiplicity = curve.knots().multiplicity(u);
            const auto result = remove_knot(curve, u, 9, 1e9);
            if (multiplicity == 1) {
                EXPECT_EQ(result.error().code, CurveErrorCode::knot_not_removable);
                continue;
            }
            if (!result || result->count == 0) continue;
            EXPECT_EQ(result->curve.knots().multiplicity(u), multiplicity - result->count);
            EXPECT_EQ(result->curve.domain(), curve.domain());
            ++removed;
        }
    }
    EXPECT_GT(removed, 50);
}

TEST(KnotRemoval, refuses_what_is_no_knot_and_no_tolerance) {
    using Code = CurveErrorCode;
    const Curve curve = Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 2, 2, 2}, .points = {4, Point(1, 2)}}).value();
    EXPECT_EQ(remove_knot(curve, 0.5, 1, 1e-3).error(), (CurveError{.code = Code::knot_not_found, .value = 0.5}));
    EXPECT_EQ(remove_knot(curve, 0.0, 1, 1e-3).error().code, Code::knot_not_found);
    EXPECT_EQ(remove_knot(curve, std::nan(""), 1, 1e-3).error().code, Code::parameter_not_finite);
    for (const double tolerance : {0.0, -1.0, std::nan("")}) {
        EXPECT_EQ(remove_knot(curve, 1.0, 1, tolerance).error().code, Code::tolerance_not_positive);
        EXPECT_EQ(remove_knots(curve, tolerance).error().code, Code::tolerance_not_positive);
    }
}

}  // namespace
}  // namespace batten::core
