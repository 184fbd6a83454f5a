#include "core/measure/geometric_distance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/evaluate/evaluate.h"
#include "core/measure/deviation.h"
#include "core/measure/nearest.h"
#include "tests/core/bezier_curve.h"
#include "tests/core/random_curves.h"

namespace batten::core {
namespace {

constexpr double percent = 0.011;

void expect_distance(double found, double exact) {
    EXPECT_GE(found, exact * (1.0 - 1e-12));
    EXPECT_LE(found, exact * (1.0 + percent));
}

// The largest distance from samples of one curve to the nearest point of the other, both ways: what the bound may not
// fall short of.
double sampled_distance(const Curve& a, const Curve& b) {
    double largest = 0.0;
    for (int k = 0; k <= 200; ++k) {
        const auto at = [k](const Curve& c) {
            return point_at(c, c.domain().clamp(c.domain().lower + k / 200.0 * c.domain().length()));
        };
        largest = std::max(largest, distance(nearest_point(b, at(a)).point, at(a)));
        largest = std::max(largest, distance(nearest_point(a, at(b)).point, at(b)));
    }
    return largest;
}

// Other weights of the ends of a line move its points along it: by 9/11 at equal parameters, in shape not at all.
TEST(GeometricDistance, of_a_line_with_another_speed_is_nothing) {
    const Curve even = bezier({{0, 0}, {1, 0}});
    const Curve uneven = bezier({{0, 0}, {1, 0}}, {1.0, 100.0});
    EXPECT_NEAR(largest_deviation(even, uneven), 9.0 / 11.0, 1e-4);
    EXPECT_LE(geometric_distance(even, uneven), 0.02);
}

TEST(GeometricDistance, of_parallel_lines_is_that_of_the_lines) {
    const Curve even = bezier({{0, 0}, {10, 0}});
    expect_distance(geometric_distance(even, bezier({{0, 1}, {10, 1}}, {1.0, 50.0})), 1.0);
    expect_distance(geometric_distance(bezier({{0, -2}, {10, -2}}, {9.0, 1.0}), even), 2.0);
}

// Two quarters about one center: the radii differ by 0.5 everywhere, whatever the parameters.
TEST(GeometricDistance, of_concentric_arcs_is_the_difference_of_radii) {
    const double w = std::sqrt(0.5);
    const Curve inner = bezier({{1, 0}, {1, 1}, {0, 1}}, {1.0, w, 1.0});
    const Curve outer = bezier({{1.5, 0}, {1.5, 1.5}, {0, 1.5}}, {1.0, 4.0 * w, 16.0});
    EXPECT_GT(largest_deviation(inner, outer), 0.8);
    expect_distance(geometric_distance(inner, outer), 0.5);
    expect_distance(geometric_distance(outer, inner), 0.5);
}

// A spike of either curve, which no point of the other is nearest to.
TEST(GeometricDistance, sees_what_only_one_of_both_has) {
    const Curve flat = bezier({{0, 0}, {4, 0}});
    const Curve spike = Curve::make({.degree = 1,
                                     .knots = {0, 0, 0.5, 0.5001, 0.5002, 1, 1},
                                     .points = {{0, 0}, {2, 0}, {2, 3}, {2, 0}, {4, 0}}})
                            .value();
    expect_distance(geometric_distance(flat, spike), 3.0);
    expect_distance(geometric_distance(spike, flat), 3.0);
}

TEST(GeometricDistance, of_random_edits_is_between_the_distance_of_shapes_and_the_deviation) {
    RandomCurves random(55);
    for (int i = 0; i < 12; ++i) {
        const Curve a = random.curve();
        CurveDefinition definition = a.definition();
        definition.points[definition.points.size() / 2] += Vector{1.0, 0.5};
        const Curve b = Curve::make(definition).value();
        const double found = geometric_distance(a, b);
        EXPECT_LE(found, largest_deviation(a, b)) << i;
        EXPECT_GE(found, sampled_distance(a, b) * (1.0 - 1e-12)) << i;
    }
}

TEST(GeometricDistance, of_a_curve_from_itself_is_nothing) {
    RandomCurves random(56);
    for (int i = 0; i < 10; ++i) {
        const Curve curve = random.curve();
        EXPECT_EQ(geometric_distance(curve, curve), 0.0);
    }
}

}  // namespace
}  // namespace batten::core
