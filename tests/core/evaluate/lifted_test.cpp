#include "core/evaluate/lifted.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/evaluate/evaluate.h"
#include "core/make/conics.h"
#include "tests/core/bezier_curve.h"
#include "tests/core/uniform_curves.h"

namespace batten::core {
namespace {

void expect_place(glm::dvec3 found, glm::dvec3 expected, double tolerance = 1e-15) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], tolerance * (1 + std::abs(expected[k]))) << k;
}

TEST(LiftView, shows_homogeneous_points_where_they_are) {
    expect_place(LiftView{}.place({3, -2}, 4), {12, -8, 4});
    expect_place(LiftView{}.place({3, -2}), {3, -2, 1});
}

TEST(LiftView, of_a_box_looks_from_below_its_middle) {
    const LiftView view = lift_view({{1e6 - 2, 10}, {1e6 + 2, 18}}, {0.5, 3});
    EXPECT_EQ(view.apex, Point(1e6, 14));
    EXPECT_EQ(view.unit, 8);
    EXPECT_EQ(view.exponent, 1);
    expect_place(view.place({1e6 + 2, 12}, 3), {0.75, -0.75, 3});
}

TEST(LiftView, brings_extreme_weights_within_reach) {
    const Box box{{-1, -1}, {1, 1}};
    for (const Interval weights : {Interval{1e-3, 1e3}, Interval{1e-6, 2}, Interval{1, 1e300}}) {
        const LiftView view = lift_view(box, weights);
        const double low = view.place({0, 0}, weights.lower).z;
        const double high = view.place({0, 0}, weights.upper).z;
        EXPECT_NEAR(std::max(1 / low, high), greatest_lift, 1e-12);
        EXPECT_LT(low, high);
    }
    EXPECT_EQ(lift_view(box, {1 / greatest_lift, greatest_lift}).exponent, 1);
    EXPECT_NEAR(lift_view(box, {1e-3, 1e3}).exponent, std::log(3.0) / std::log(1000.0), 1e-15);
}

TEST(LiftView, keeps_every_point_on_the_ray_through_its_shadow) {
    const LiftView view = lift_view({{0, 0}, {10, 6}}, {1e-3, 1e3});
    const glm::dvec3 shadow = view.place({7, 1});
    EXPECT_EQ(shadow.z, 1);
    for (const double weight : {1e-3, 0.2, 40.0, 1e3}) {
        const glm::dvec3 place = view.place({7, 1}, weight);
        expect_place(place / place.z, shadow);
    }
}

TEST(LiftView, knows_the_weight_of_a_height) {
    for (const double exponent : {1.0, 0.25})
        for (const double weight : {1e-6, 0.3, 1.0, 1e6}) {
            const LiftView view{{2, 3}, 0.5, exponent};
            EXPECT_NEAR(view.weight_at(view.place({5, 5}, weight).z) / weight, 1, 1e-13);
        }
}

TEST(LiftView, of_one_place_or_a_huge_box_has_a_length) {
    EXPECT_EQ(lift_view({{3, 3}, {3, 3}}, {1, 1}).unit, 1);
    EXPECT_EQ(lift_view({{-1.5e308, 0}, {1.5e308, 1}}, {1, 1}).unit, std::numeric_limits<double>::max());
}

// The quarter from (1, 0) to (0, 1) has w(u) = 1 - (2 - root of 2) u (1 -
// u).
TEST(LiftedAt, has_the_weight_of_a_quarter_circle) {
    const Curve curve = bezier({{1, 0}, {1, 1}, {0, 1}}, {1, std::sqrt(0.5), 1});
    for (const double u : {0.0, 0.2, 0.5, 0.7, 1.0}) {
        const LiftedSample sample = lifted_at(curve, u);
        EXPECT_EQ(sample.u, u);
        EXPECT_NEAR(sample.weight, 1 - (2 - std::numbers::sqrt2) * u * (1 - u), 1e-15);
        EXPECT_EQ(sample.point, point_at(curve, u));
    }
}

TEST(LiftedAt, wraps_periodic_weights) {
    CurveDefinition definition = closed_curve(1, {{0, 0}, {1, 0}, {0, 1}}).definition();
    definition.weights = {1, 2, 4};
    const Curve curve = Curve::make(definition).value();
    const double start = curve.domain().lower;
    // Over the legs from P1 to P2 to P0: degree 1 has its points at the knots.
    std::vector<double> seen;
    for (int k = 0; k < 3; ++k) seen.push_back(lifted_at(curve, start + k).weight);
    std::sort(seen.begin(), seen.end());
    EXPECT_EQ(seen, (std::vector<double>{1, 2, 4}));
    EXPECT_EQ(lifted_at(curve, start + 3, Side::left).weight, lifted_at(curve, start).weight);
}

// The curve above a circle lies on the cone x^2 + y^2 = w^2.
TEST(LiftedSamples, of_a_circle_lie_on_a_cone) {
    const Curve curve = circle({0, 0}, 1.0).value();
    const LiftView view;
    const auto runs = lifted_samples(curve, view, {});
    ASSERT_EQ(runs.size(), 1U);
    EXPECT_EQ(runs[0].front().u, 0);
    EXPECT_EQ(runs[0].back().u, 1);
    for (const LiftedSample& sample : runs[0]) {
        const glm::dvec3 place = view.place(sample.point, sample.weight);
        EXPECT_NEAR(std::hypot(place.x, place.y), place.z, 1e-15);
    }
}

TEST(LiftedSamples, are_as_fine_as_asked_for) {
    const Curve curve = bezier({{0, 0}, {1, 2}, {3, 2}, {4, 0}}, {1, 5, 0.2, 1});
    const LiftView view = lift_view({{0, 0}, {4, 2}}, {0.2, 5});
    const auto runs = lifted_samples(curve, view, {.tolerance = 1e-3});
    for (std::size_t i = 0; i + 1 < runs[0].size(); ++i) {
        const LiftedSample& a = runs[0][i];
        const LiftedSample& b = runs[0][i + 1];
        EXPECT_LT(a.u, b.u);
        const LiftedSample half = lifted_at(curve, 0.5 * (a.u + b.u));
        const glm::dvec3 chord = 0.5 * (view.place(a.point, a.weight) + view.place(b.point, b.weight));
        const glm::dvec3 gap = view.place(half.point, half.weight) - chord;
        EXPECT_LE(std::hypot(gap.x, gap.y, gap.z), 1e-3);
    }
    EXPECT_LT(runs[0].size(), 200U);
}

TEST(LiftedSamples, begin_anew_after_a_tear) {
    const Curve curve = Curve::make({.degree = 1,
                                     .knots = {0, 0, 1, 1, 2, 2},
                                     .points = {{0, 0}, {1, 0}, {5, 5}, {6, 5}},
                                     .weights = {1, 2, 3, 4},
                                     .tears = Tears::allow})
                            .value();
    const auto runs = lifted_samples(curve, {}, {});
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_EQ(runs[0].back().point, Point(1, 0));
    EXPECT_EQ(runs[0].back().weight, 2);
    EXPECT_EQ(runs[1].front().point, Point(5, 5));
    EXPECT_EQ(runs[1].front().weight, 3);
}

TEST(LiftedSamples, of_many_spans_are_few) {
    std::vector<Point> points;
    for (int i = 0; i < 10000; ++i) points.emplace_back(i, i % 2);
    const auto runs = lifted_samples(open_curve(3, points), {}, {.tolerance = 1e-3, .most_spans = 64});
    ASSERT_EQ(runs.size(), 1U);
    ASSERT_EQ(runs[0].size(), 65U);
    EXPECT_EQ(runs[0].front().u, 0);
    EXPECT_EQ(runs[0].back().u, 9997);
}

}  // namespace
}  // namespace batten::core
