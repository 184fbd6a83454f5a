#include "core/edit/simplify.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/evaluate/evaluate.h"
#include "core/make/shapes.h"
#include "core/measure/deviation.h"
#include "core/refine/knot_refinement.h"
#include "core/refine/knot_removal.h"
#include "tests/core/random_curves.h"

namespace batten::core {

namespace {

// A smooth wave whose control points shake by `noise`.
Curve shaky(std::size_t n, double noise) {
    CurveDefinition definition{.degree = 3, .knots = {}, .points = {}};
    for (std::size_t i = 0; i < n; ++i) {
        const double x = static_cast<double>(i);
        definition.points.emplace_back(x, 20.0 * std::sin(0.05 * x) + noise * std::sin(17.0 * x * x));
    }
    for (std::size_t i = 0; i < n + 4; ++i)
        definition.knots.push_back(static_cast<double>(std::min(std::max<std::size_t>(i, 3), n)));
    return Curve::make(std::move(definition)).value();
}

double worst_of_samples(const Curve& a, const Curve& b) {
    double worst = 0.0;
    const Interval domain = a.domain();
    for (int k = 0; k <= 5000; ++k) {
        const double u = domain.lower + domain.length() * k / 5000;
        worst = std::max(worst, distance(point_at(a, u), point_at(b, u)));
    }
    return worst;
}

}  // namespace

TEST(Simplify, leaves_far_fewer_points_than_removal_alone) {
    const Curve curve = shaky(300, 0.05);
    const double tolerance = 0.1;
    const auto simple = simplify(curve, tolerance).value();
    const auto removed = remove_knots(curve, tolerance).value();
    EXPECT_LE(simple.error, tolerance);
    EXPECT_LE(worst_of_samples(curve, simple.curve), simple.error + 1e-12);
    EXPECT_LT(2 * simple.curve.control_points().size(), removed.curve.control_points().size());
    EXPECT_EQ(simple.curve.domain(), curve.domain());
    EXPECT_EQ(simple.curve.control_points().front(), curve.control_points().front());
    EXPECT_EQ(simple.curve.control_points().back(), curve.control_points().back());
}

TEST(Simplify, keeps_a_corner_that_the_tolerance_does_not_hide) {
    // With the knot 18 three times the curve passes point 17.
    CurveDefinition definition = shaky(40, 0.02).definition();
    definition.points = {};
    definition.weights.clear();
    const Curve wave = shaky(42, 0.02);
    for (const Point& point : wave.control_points())
        definition.points.emplace_back(point.x, point.y + 5.0 * std::max(point.x - 17.0, 0.0));
    definition.knots.insert(std::ranges::lower_bound(definition.knots, 18.0), 2, 18.0);
    const auto made = Curve::make(std::move(definition));
    ASSERT_TRUE(made) << describe(made.error());
    const Curve& curve = *made;
    const auto simple = simplify(curve, 0.05).value();
    EXPECT_EQ(simple.curve.knots().multiplicity(18.0), 3);
    EXPECT_LE(worst_of_samples(curve, simple.curve), 0.05);
    EXPECT_LT(simple.curve.control_points().size(), 28u);
}

TEST(Simplify, the_bound_holds_on_random_curves) {
    RandomCurves random(23);
    for (int k = 0; k < 60; ++k) {
        const Curve curve = random.curve();
        for (const double tolerance : {1e-9, 0.01, 0.5}) {
            const auto simple = simplify(curve, tolerance).value();
            EXPECT_LE(simple.error, tolerance) << k;
            EXPECT_LE(worst_of_samples(curve, simple.curve), tolerance * (1.0 + 1e-9)) << k;
            EXPECT_LE(simple.curve.control_points().size(), curve.control_points().size());
            EXPECT_EQ(simple.curve.degree(), curve.degree());
        }
    }
}

TEST(Simplify, takes_out_again_what_was_inserted) {
    const Curve wave = shaky(12, 0.0);
    std::vector<double> more;
    for (int i = 0; i < 60; ++i) more.push_back(3.07 + 0.15 * i);
    const Curve fine = refine_knots(wave, more).value();
    const auto simple = simplify(fine, 1e-8).value();
    EXPECT_EQ(simple.curve.control_points().size(), 12u);
    EXPECT_LT(largest_deviation(wave, simple.curve), 1e-8);
}

TEST(Simplify, a_tolerance_that_is_none_is_refused) {
    for (const double tolerance : {0.0, -1.0, std::nan("")})
        EXPECT_EQ(simplify(shaky(8, 0.0), tolerance).error().code, CurveErrorCode::tolerance_not_positive);
}

}  // namespace batten::core
