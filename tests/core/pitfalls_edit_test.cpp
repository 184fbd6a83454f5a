// Bugs that spline programs keep having, where edits, files and tessellation can have them. The number of each class
// stands in the name of its test.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/curve/knot_analysis.h"
#include "core/document/native_file.h"
#include "core/edit/knot_edit.h"
#include "core/edit/point_edit.h"
#include "core/evaluate/evaluate.h"
#include "core/evaluate/tessellate.h"
#include "core/measure/deviation.h"
#include "core/measure/nearest.h"
#include "core/refine/degree.h"
#include "core/refine/knot_insertion.h"
#include "core/refine/knot_removal.h"
#include "tests/core/random_curves.h"
#include "tests/core/stored_knots.h"

namespace batten::core {
namespace {

using Knots = std::vector<double>;

const Box everything{{-1e12, -1e12}, {1e12, 1e12}};

Curve from_file(const std::string& curve_members) {
    const auto document = parse_document(R"({"format": "batten", "version": 1, "curves": [{)" + curve_members + "}]}");
    if (!document) throw std::runtime_error(document.error().sentence());
    return *document->curves.at(0).curve;
}

Curve through_file(const Curve& curve) {
    Document document;
    document.curves.push_back(
        {.name = "c", .curve = std::make_shared<const Curve>(curve), .color = {}, .unknown_members = {}});
    return *parse_document(format_document(document))->curves.at(0).curve;
}

TEST(PitfallsEdit, p1_last_point_neither_vanishes_nor_jumps) {
    RandomCurves random(121);
    for (int i = 0; i < 100; ++i) {
        const Curve curve = random.open_curve();
        const auto runs = tessellate(curve, {1e-2, everything, curve.domain()});
        EXPECT_EQ(runs.back().back().u, curve.domain().upper);
        if (!is_clamped(curve.knots())) continue;
        EXPECT_EQ(runs.front().front().point, curve.control_points().front());
        EXPECT_EQ(runs.back().back().point, curve.control_points().back());
    }
}

TEST(PitfallsEdit, p2_other_knot_counts_are_refused_and_the_degree_is_never_guessed) {
    // The count n + p - 1 of other programs, for the cubic with knots 0,0,0,0,1,1,1,1.
    const std::string points = R"("points": [[0,0],[1,2],[3,2],[4,0]])";
    EXPECT_THROW(from_file("\"degree\": 3, \"knots\": [0,0,0,1,1,1], " + points), std::runtime_error);
    EXPECT_THROW(from_file("\"knots\": [0,0,0,0,1,1,1,1], " + points), std::runtime_error);
    EXPECT_EQ(from_file("\"degree\": 1, \"knots\": [0,1,2,3,4,5], " + points).degree(), 1);
}

TEST(PitfallsEdit, p3_data_count_and_not_flags) {
    const std::string open = R"("degree": 2, "knots": [0,0,0,1,1,1], "points": [[0,0],[1,2],[2,0]])";
    const Curve flagged = from_file(open + R"(, "periodic": true, "kind": "periodic")");
    EXPECT_FALSE(flagged.is_periodic());
    EXPECT_EQ(flagged.knots().kind(), KnotKind::custom);
    EXPECT_EQ(largest_deviation(flagged, from_file(open)), 0.0);
    // Ends that meet do not make a curve periodic, and wrapped points do not either.
    const Curve meeting = from_file(R"("degree": 2, "knots": [0,0,0,1,2,2,2], "points": [[0,0],[1,2],[2,0],[0,0]])");
    EXPECT_FALSE(meeting.is_periodic());
    const Curve wrapped =
        from_file(R"("degree": 2, "knots": [0,1,2,3,4,5,6,7], "points": [[0,0],[1,2],[2,0],[0,0],[1,2]])");
    EXPECT_FALSE(wrapped.is_periodic());
    const Curve periodic =
        from_file(R"("degree": 2, "knots": [2,3,4,5], "points": [[0,0],[1,2],[2,0]], "periodic": true)");
    EXPECT_TRUE(periodic.is_periodic());
    EXPECT_LE(largest_deviation(periodic, wrapped), 1e-14);
}

TEST(PitfallsEdit, p4_seam_is_like_any_other_knot) {
    RandomCurves random(122);
    std::vector<Point> points;
    for (int i = 0; i < 6; ++i) {
        const double x = random.number(-8.0, 8.0);
        points.emplace_back(x, random.number(-8.0, 8.0));
    }
    const Curve curve =
        Curve::make({.degree = 3, .knots = {0, 1, 2, 3, 4, 5, 6}, .points = points, .periodic = true}).value();
    std::rotate(points.begin(), points.begin() + 1, points.end());
    const Curve rotated =
        Curve::make({.degree = 3, .knots = {0, 1, 2, 3, 4, 5, 6}, .points = points, .periodic = true}).value();
    const Curve pulled = move_knot(curve, 2, 2.4, KnotMove::stop).value();
    const Curve pulled_seam = move_knot(rotated, 1, 1.4, KnotMove::stop).value();
    const Curve raised = elevate_degree(pulled).value();
    const Curve raised_seam = elevate_degree(pulled_seam).value();
    for (double u = 0.0; u < 6.0; u += 0.05) {
        const double later = u < 1.0 ? u + 6.0 : u;
        EXPECT_LT(distance(point_at(pulled, later), point_at(pulled_seam, later - 1.0)), 1e-13);
        EXPECT_LT(distance(point_at(raised, later), point_at(raised_seam, later - 1.0)), 1e-12);
    }
}

TEST(PitfallsEdit, p5_unclamped_curves_are_tessellated_and_searched_over_their_domain) {
    const Curve curve =
        Curve::make({.degree = 3, .knots = {-3, -2, -1, 0, 1, 2, 3, 4}, .points = {{0, 0}, {1, 3}, {4, 3}, {5, -1}}})
            .value();
    const auto runs = tessellate(curve, {1e-3, everything, curve.domain()});
    EXPECT_EQ(runs.front().front().u, 0.0);
    EXPECT_EQ(runs.back().back().u, 1.0);
    EXPECT_EQ(nearest_point(curve, {-100, -100}).u, 0.0);
}

TEST(PitfallsEdit, p6_removal_gives_back_what_insertion_changed) {
    RandomCurves random(124);
    for (int p = 1; p <= 7; ++p)
        for (int times = 1; times <= p; ++times) {
            CurveDefinition definition{.degree = p, .knots = Knots(static_cast<std::size_t>(p) + 1, 0.0)};
            definition.knots.insert(definition.knots.end(), {0.25, 0.5, 0.75});
            definition.knots.insert(definition.knots.end(), static_cast<std::size_t>(p) + 1, 1.0);
            for (int i = 0; i < p + 4; ++i) {
                definition.points.emplace_back(i, random.number(-3.0, 3.0));
                definition.weights.push_back(random.number(0.5, 2.0));
            }
            const Curve curve = Curve::make(definition).value();
            const auto back = remove_knot(insert_knot(curve, 0.4, times).value(), 0.4, times, 1e-9).value();
            EXPECT_EQ(back.count, times);
            EXPECT_EQ(stored(back.curve), stored(curve));
            for (std::size_t i = 0; i < curve.control_points().size(); ++i) {
                EXPECT_LE(distance(back.curve.control_points()[i], curve.control_points()[i]), 1e-13);
                EXPECT_NEAR(back.curve.weights()[i], curve.weights()[i], 1e-13);
            }
        }
}

TEST(PitfallsEdit, p6_over_tolerance_nothing_is_removed_and_the_error_is_reported) {
    const Curve curve =
        Curve::make(
            {.degree = 3, .knots = {0, 0, 0, 0, 0.5, 1, 1, 1, 1}, .points = {{0, 0}, {1, 4}, {2, -4}, {3, 4}, {4, 0}}})
            .value();
    const auto result = remove_knot(curve, 0.5, 1, 1e-3).value();
    EXPECT_EQ(result.count, 0);
    EXPECT_EQ(result.curve, curve);
    ASSERT_TRUE(result.refused.has_value());
    EXPECT_GT(*result.refused, 1e-3);
    // It is the error that a larger tolerance lets it make.
    const auto allowed = remove_knot(curve, 0.5, 1, *result.refused).value();
    EXPECT_EQ(allowed.count, 1);
    EXPECT_EQ(allowed.error, *result.refused);
    EXPECT_EQ(allowed.error, largest_deviation(curve, allowed.curve));
}

TEST(PitfallsEdit, p7_elevation_keeps_the_shape_over_multiple_knots_unequal_weights_and_short_spans) {
    const Curve curve =
        Curve::make({.degree = 3,
                     .knots = {0, 0, 0, 0, 0.3, 0.3, 0.3, 0.3 + 1e-9, 0.8, 0.8, 1, 1, 1, 1},
                     .points = {{0, 0}, {1, 5}, {2, -3}, {3, 4}, {4, 4}, {5, -5}, {6, 2}, {7, 1}, {8, 0}, {9, 3}},
                     .weights = {1, 0.01, 100, 1, 7, 0.3, 2, 50, 1, 0.1}})
            .value();
    EXPECT_LE(largest_deviation(curve, elevate_degree(curve, 2).value()), 9.0 * 1e-12);
}

TEST(PitfallsEdit, p8_close_knots_and_large_domains_behave_like_any_others) {
    const std::vector<Point> points{{0, 0}, {1, 5}, {2, -3}, {3, 4}, {4, 4}, {5, -5}};
    const Knots unit{0, 0, 0, 0, 0.25, 0.75, 1, 1, 1, 1};
    for (const double scale : {1e-9, 1e9})
        for (const double offset : {0.0, 1.0}) {
            Knots knots = unit;
            for (double& knot : knots) knot = scale * (knot + offset);
            const Curve plain = Curve::make({.degree = 3, .knots = unit, .points = points}).value();
            const Curve curve = Curve::make({.degree = 3, .knots = knots, .points = points}).value();
            const auto u = [&](double of_unit) { return scale * (of_unit + offset); };
            EXPECT_NEAR(stored(move_knot(curve, 4, u(0.9), KnotMove::stop).value())[4], u(0.745), 1e-15 * scale);
            EXPECT_NEAR(stored(move_knot(curve, 4, u(0.9), KnotMove::push).value())[5], u(0.905), 1e-14 * scale);
            EXPECT_EQ(tessellate(curve, {1e-3, everything, curve.domain()})[0].size(),
                      tessellate(plain, {1e-3, everything, plain.domain()})[0].size());
            EXPECT_NEAR(nearest_point(curve, {2, 2}).u, u(nearest_point(plain, {2, 2}).u), 1e-12 * scale);
            EXPECT_LE(largest_deviation(elevate_degree(curve).value(), elevate_degree(plain).value()), 1e-13);
        }
}

TEST(PitfallsEdit, p9_full_multiplicity_is_never_exceeded_by_dragging_or_typing) {
    const Curve curve = Curve::make({.degree = 2,
                                     .knots = {0, 0, 0, 0.25, 0.5, 0.5, 1, 1, 1},
                                     .points = {{0, 0}, {1, 1}, {2, 0}, {3, 1}, {4, 0}, {5, 1}}})
                            .value();
    for (const KnotMove mode : {KnotMove::stop, KnotMove::push, KnotMove::snap})
        EXPECT_EQ(move_knot(curve, 3, 0.5, mode, 0.1)->knots().multiplicity(0.5), mode == KnotMove::push ? 1 : 2);
    const auto typed = set_knot(curve, 3, 0.5);
    ASSERT_FALSE(typed.has_value());
    EXPECT_EQ(describe(typed.error()), "knot 3 occurs 3 times; at most 2 equal knots are allowed there");
}

TEST(PitfallsEdit, p11_unequal_weights_come_back_unshifted_and_euclidean) {
    const Curve curve = Curve::make({.degree = 2,
                                     .knots = {0, 0, 0, 0.5, 1, 1, 1},
                                     .points = {{1, 2}, {3, 4}, {5, 6}, {7, 8}},
                                     .weights = {0.5, 2, 3, 1e-3}})
                            .value();
    const Curve back = through_file(curve);
    EXPECT_TRUE(std::ranges::equal(back.weights(), Knots{0.5, 2, 3, 1e-3}));
    EXPECT_EQ(back.control_points()[1], Point(3, 4));
    const std::string absent = R"("degree": 1, "knots": [0,0,1,1], "points": [[0,0],[1,1]], "weights": [1,-1])";
    EXPECT_THROW(from_file(absent), std::runtime_error);
}

TEST(PitfallsEdit, p13_every_multiplicity_comes_back) {
    for (int p = 1; p <= 7; ++p)
        for (int m = 1; m <= p; ++m)
            for (const bool periodic : {false, true}) {
                const auto ends = static_cast<std::size_t>(periodic ? 1 : p + 1);
                Knots knots(ends, 0.0);
                knots.insert(knots.end(), static_cast<std::size_t>(m), 0.3);
                knots.insert(knots.end(), 1, 0.7);
                knots.insert(knots.end(), ends, 1.0);
                const std::size_t count = knots.size() - ends;
                std::vector<Point> points;
                for (std::size_t i = 0; i < count; ++i) points.emplace_back(static_cast<double>(i), i % 3);
                const Curve curve =
                    Curve::make({.degree = p, .knots = knots, .points = points, .periodic = periodic}).value();
                const Curve back = through_file(curve);
                EXPECT_EQ(back, curve);
                EXPECT_EQ(back.knots().multiplicity(0.3), m);
            }
}

TEST(PitfallsEdit, p17_custom_knots_survive_every_edit_that_does_not_name_them) {
    const Knots typed{0, 0, 0, 0, 1, 3, 4, 7, 7, 7, 7};
    const Curve curve =
        Curve::make({.degree = 3, .knots = typed, .points = {{0, 0}, {1, 5}, {2, -3}, {3, 4}, {4, 4}, {5, -5}, {6, 2}}})
            .value();
    EXPECT_EQ(stored(set_control_point(curve, 2, {9, 9}).value()), typed);
    EXPECT_EQ(stored(move_control_points(curve, std::vector<std::size_t>{0, 3}, {1, 1}).value()), typed);
    EXPECT_EQ(stored(set_weight(curve, 2, 5.0).value()), typed);
    EXPECT_EQ(stored(set_knot_kind(curve, KnotKind::custom).value()), typed);
    EXPECT_EQ(stored(through_file(curve)), typed);
    for (std::size_t i = 0; i <= 7; ++i)
        EXPECT_TRUE(std::ranges::includes(stored(add_control_point(curve, i, {9, 9}).value()), typed));
    for (std::size_t i = 0; i < 7; ++i)
        EXPECT_TRUE(std::ranges::includes(typed, stored(delete_control_point(curve, i).value())));
    EXPECT_TRUE(std::ranges::includes(stored(set_degree(curve, 4).value()), typed));
    EXPECT_EQ(stored(set_degree(curve, 2).value()), (Knots{0, 0, 0, 1, 3, 4, 7, 7, 7}));
    EXPECT_EQ(stored(set_degree(set_degree(curve, 5).value(), 3).value()), typed);
    EXPECT_TRUE(std::ranges::includes(stored(insert_knot(curve, 2.0).value()), typed));
}

TEST(PitfallsEdit, p17_disorder_is_refused_and_never_sorted) {
    const Curve curve =
        Curve::make({.degree = 1, .knots = {0, 0, 1, 2, 2}, .points = {{0, 0}, {1, 1}, {2, 0}}}).value();
    EXPECT_EQ(set_knots(curve, {0, 0, 2, 1, 2}).error().code, CurveErrorCode::knot_decreasing);
    EXPECT_EQ(set_knot(curve, 2, 3.0).error().code, CurveErrorCode::knot_decreasing);
}

TEST(PitfallsEdit, p18_laws_hold_far_from_the_origin) {
    const Vector offset(3e8, -1e8);
    RandomCurves random(123);
    for (int i = 0; i < 50; ++i) {
        const Curve curve = random.curve();
        std::vector<std::size_t> all(curve.control_points().size());
        for (std::size_t k = 0; k < all.size(); ++k) all[k] = k;
        const Curve far = move_control_points(curve, all, offset).value();
        EXPECT_LE(largest_deviation(far, elevate_degree(far).value()), 3e8 * 1e-13);
        const auto runs = tessellate(far, {1e-3, {{-1e9, -1e9}, {1e9, 1e9}}, far.domain()});
        for (const auto& sample : runs[0])
            EXPECT_LT(distance(sample.point, point_at(curve, sample.u) + offset), 3e8 * 1e-14);
    }
}

}  // namespace
}  // namespace batten::core
