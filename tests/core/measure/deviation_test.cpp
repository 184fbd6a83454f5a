#include "core/measure/deviation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/evaluate/evaluate.h"
#include "core/make/shapes.h"
#include "core/refine/knot_insertion.h"
#include "tests/core/bezier_curve.h"
#include "tests/core/random_curves.h"

namespace batten::core {
namespace {

Curve line_over(Point a, Point b, Interval domain = {0.0, 1.0}) {
    return Curve::make(
               {.degree = 1, .knots = {domain.lower, domain.lower, domain.upper, domain.upper}, .points = {a, b}})
        .value();
}

TEST(Deviation, curve_does_not_deviate_from_itself) {
    RandomCurves random(51);
    for (int i = 0; i < 30; ++i) {
        const Curve curve = random.curve();
        EXPECT_EQ(largest_deviation(curve, curve), 0.0);
    }
}

// How much more than the true deviation its bound may be.
constexpr double looseness = 1e-4;

void expect_bound(double found, double exact) {
    EXPECT_GE(found, exact);
    EXPECT_LE(found, exact * (1.0 + looseness));
}

TEST(Deviation, moved_curve_deviates_by_the_offset) {
    expect_bound(largest_deviation(line_over({0, 0}, {4, 0}), line_over({3, 4}, {7, 4})), 5.0);
}

TEST(Deviation, is_found_quickly_where_few_spans_differ) {
    std::vector<Point> places;
    for (int i = 0; i <= 1000; ++i) places.emplace_back(i, i % 2);
    const Curve zigzag = polyline(places).value();
    places[500].y += 3.0;
    const Curve pulled = polyline(places).value();
    EXPECT_NEAR(quick_deviation(zigzag, pulled, 2).value(), 3.0, 1e-12);
    EXPECT_FALSE(quick_deviation(zigzag, pulled, 1));
    EXPECT_EQ(quick_deviation(zigzag, zigzag, 0), 0.0);
}

TEST(Deviation, moved_end_is_seen) {
    expect_bound(largest_deviation(line_over({0, 0}, {1, 0}), line_over({0, 0}, {1, 2})), 2.0);
    expect_bound(largest_deviation(line_over({0, 0}, {1, 0}), line_over({0, -3}, {1, 0})), 3.0);
}

// The move v of P_1 moves C(t) by 3 t (1-t)^2 v, which is largest at 1/3: 4/9 v.
TEST(Deviation, is_no_less_than_the_peak_between_any_samples) {
    expect_bound(largest_deviation(bezier({{0, 0}, {1, 2}, {3, 2}, {4, 0}}), bezier({{0, 0}, {4, 6}, {3, 2}, {4, 0}})),
                 5.0 * 4.0 / 9.0);
}

// b_k(t) of degree n has its peak at k/n.
TEST(Deviation, of_any_degree_is_a_bound) {
    for (int n = 2; n <= 25; ++n)
        for (int k = 1; k < n; ++k) {
            std::vector<Point> points;
            for (int i = 0; i <= n; ++i) points.emplace_back(i, 0.5 * i * i);
            const Curve curve = bezier(points);
            points[static_cast<std::size_t>(k)] += Vector{0.0, 1.0};
            const double t = static_cast<double>(k) / n;
            const double peak = std::exp(std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0) +
                                         k * std::log(t) + (n - k) * std::log(1.0 - t));
            const double found = largest_deviation(curve, bezier(points));
            EXPECT_GE(found, peak * (1.0 - 1e-13)) << n << ", " << k;
            EXPECT_LE(found, peak * (1.0 + looseness)) << n << ", " << k;
        }
}

// On the line from 0 to 1 with weights 1 and w, C(t) - t is largest where t = 1 / (1 + sqrt(w)): (sqrt(w) - 1) /
// (sqrt(w) + 1).
TEST(Deviation, of_extreme_weights_is_a_bound) {
    for (const double w : {1e-300, 1e-12, 1e-6, 1e-3, 0.25, 4.0, 1e3, 1e6, 1e12, 1e100, 1e280, 1e300}) {
        const double root = std::sqrt(w);
        const double found = largest_deviation(bezier({{0, 0}, {1, 0}}), bezier({{0, 0}, {1, 0}}, {1.0, w}));
        EXPECT_GE(found, std::abs(root - 1.0) / (root + 1.0) * (1.0 - 1e-15)) << w;
        EXPECT_LE(found, std::abs(root - 1.0) / (root + 1.0) * (1.0 + looseness)) << w;
    }
}

// A point at h with the weight 1 / h is a direction: 2 u (1 - u) / ((1 - u)^2 + u^2) of it is added, 1 in the middle.
TEST(Deviation, of_points_as_far_as_their_weights_are_small_is_a_bound) {
    for (const double h : {1e3, 1e30, 1e150, 1e170, 1e200, 1e270}) {
        const std::vector<double> weights{1.0, 1.0 / h, 1.0};
        const double found =
            largest_deviation(bezier({{-1, 0}, {0, h}, {1, 0}}, weights), bezier({{-1, 0}, {0, -h}, {1, 0}}, weights));
        EXPECT_NEAR(found, 2.0 / (1.0 + 1.0 / h), 2.0 * looseness) << h;
    }
}

// The middle point of a parabola counts half in its middle.
TEST(Deviation, of_curves_that_differ_in_the_last_bit_is_a_bound) {
    const double ulp = std::numeric_limits<double>::epsilon();
    expect_bound(largest_deviation(line_over({0, 1}, {2, 1}), bezier({{0, 1}, {1, 1.0 + ulp}, {2, 1}})), 0.5 * ulp);
    const double far = 1e9;
    const double step = std::nextafter(far, 2e9) - far;
    expect_bound(largest_deviation(line_over({far, far}, {far + 2, far}),
                                   bezier({{far, far}, {far + 1, far + step}, {far + 2, far}}, {5.0, 5.0, 5.0})),
                 0.5 * step);
}

TEST(Deviation, of_extreme_sizes_is_a_bound) {
    for (const double size : {1e-300, 1e-160, 1e160, 1e300})
        expect_bound(largest_deviation(line_over({0, 0}, {size, 0}), line_over({0, 0}, {size, 0.5 * size})),
                     0.5 * size);
    EXPECT_TRUE(std::isinf(largest_deviation(line_over({0, 0}, {1.7e308, 0}), line_over({0, 0}, {-1.7e308, 0}))));
}

// So many pieces of which each could be the largest.
TEST(Deviation, many_equal_peaks_are_one_bound) {
    std::vector<double> knots{0, 0, 0};
    std::vector<Point> before;
    std::vector<Point> after;
    for (int i = 0; i < 2001; ++i) {
        before.emplace_back(i, 0.0);
        after.emplace_back(i, i % 2 == 0 ? 0.0 : 1.0);
    }
    for (int k = 1; k < 1000; ++k) knots.insert(knots.end(), 2, k);
    knots.insert(knots.end(), 3, 1000.0);
    const auto curve = [&](const std::vector<Point>& points) {
        return Curve::make({.degree = 2, .knots = knots, .points = points}).value();
    };
    expect_bound(largest_deviation(curve(before), curve(after)), 0.5);
}

// The law that no sample may break: against 4000 samples.
TEST(Deviation, is_above_every_sample_and_near_the_largest) {
    RandomCurves random(54);
    for (int i = 0; i < 16; ++i) {
        const Curve a = random.curve();
        const Curve b = random.curve();
        const double bound = largest_deviation(a, b);
        double largest = 0.0;
        for (int k = 0; k <= 4000; ++k) {
            const double t = k / 4000.0;
            const auto at = [t](const Curve& c) {
                return point_at(c, c.domain().lower + t * c.domain().length(), t < 1.0 ? Side::right : Side::left);
            };
            largest = std::max(largest, distance(at(a), at(b)));
        }
        EXPECT_GE(bound, largest * (1.0 - 1e-14)) << i;
        EXPECT_LE(bound, largest * (1.0 + 1e-3)) << i;
    }
}

TEST(Deviation, domains_are_matched_affinely) {
    EXPECT_NEAR(largest_deviation(line_over({0, 0}, {1, 0}), line_over({0, 0}, {1, 0}, {-7.0, 19.0})), 0.0, 1e-15);
}

TEST(Deviation, tears_of_both_curves_are_matched_in_other_domains) {
    const auto torn = [](double begin, double length) {
        std::vector<double> knots{begin, begin};
        for (const double share : {0.1, 0.3, 0.7}) knots.insert(knots.end(), 2, begin + share * length);
        knots.insert(knots.end(), 2, begin + length);
        return Curve::make({.degree = 1,
                            .knots = knots,
                            .points = {{0, 0}, {1, 0}, {1, 9}, {2, 9}, {2, 0}, {3, 0}, {3, 9}, {4, 9}},
                            .tears = Tears::allow})
            .value();
    };
    for (const double begin : {-3.0, 0.1, 1e3})
        EXPECT_LE(largest_deviation(torn(0.0, 1.0), torn(begin, 0.7)), 1e-12 * (1.0 + std::abs(begin)));
}

TEST(Deviation, knots_that_are_nearer_than_the_noise_of_the_domain_stay_apart) {
    const Curve steep =
        Curve::make({.degree = 1, .knots = {0, 0, 1e-9, 1e8, 1e8}, .points = {{0, 0}, {0, 1}, {0, 0}}}).value();
    EXPECT_LE(largest_deviation(steep, insert_knot(steep, 1e-11).value()), 1e-16);
}

TEST(Deviation, parabola_is_a_quarter_of_its_middle_point_away_from_the_chord) {
    const Curve chord =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {1, 0}, {2, 0}}}).value();
    const Curve parabola =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {1, 3}, {2, 0}}}).value();
    expect_bound(largest_deviation(chord, parabola), 1.5);
}

TEST(Deviation, is_the_same_from_both_sides) {
    RandomCurves random(52);
    for (int i = 0; i < 30; ++i) {
        const Curve a = random.curve();
        const Curve b = random.curve();
        const double bound = largest_deviation(a, b);
        EXPECT_NEAR(bound, largest_deviation(b, a), looseness * bound);
    }
}

TEST(Deviation, narrow_bump_of_either_curve_is_seen) {
    const Curve flat = line_over({0, 0}, {1, 0});
    const Curve bump = Curve::make({.degree = 1,
                                    .knots = {0, 0, 0.5, 0.5001, 0.5002, 1, 1},
                                    .points = {{0, 0}, {0.5, 0}, {0.5001, 9}, {0.5002, 0}, {1, 0}}})
                           .value();
    expect_bound(largest_deviation(flat, bump), 9.0);
    expect_bound(largest_deviation(bump, flat), 9.0);
}

TEST(Deviation, inserted_knot_shows_rounding_only) {
    RandomCurves random(53);
    for (int i = 0; i < 30; ++i) {
        const Curve curve = random.curve();
        const auto refined = insert_midpoint_knots(curve);
        ASSERT_TRUE(refined.has_value());
        EXPECT_LT(largest_deviation(curve, *refined), 8.0 * 1e-13);
    }
}

}  // namespace
}  // namespace batten::core
