#include "core/refine/knot_refinement.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/curve/detail/spline.h"
#include "core/refine/knot_insertion.h"
#include "tests/core/known_curves.h"
#include "tests/core/shape_check.h"

namespace batten::core {
namespace {

// As many knots as fit, at random places, some of them knots or ends.
std::vector<double> knots_to_add(const Curve& curve, RandomCurves& random) {
    std::vector<double> added;
    for (int k = random.whole(1, 6); k > 0; --k) {
        const double u = random.parameter(curve);
        auto trial = added;
        trial.push_back(u);
        if (refine_knots(curve, trial)) added = trial;
    }
    return added;
}

TEST(KnotRefinement, keeps_the_shape_and_does_what_single_insertions_do) {
    RandomCurves random(301);
    for (int k = 0; k < 500; ++k) {
        const Curve curve = random.curve();
        const auto added = knots_to_add(curve, random);
        const Curve refined = refine_knots(curve, added).value();
        EXPECT_LE(shape_change(curve, refined, random), 2e-14);
        Curve one_by_one = curve;
        for (const double u : added) one_by_one = insert_knot(one_by_one, u).value();
        ASSERT_EQ(stored(refined), stored(one_by_one));
        EXPECT_LE(point_difference(one_by_one, refined), 1e-14);
    }
}

TEST(KnotRefinement, keeps_the_shape_far_away_in_high_degrees_and_over_short_spans) {
    RandomCurves random(302);
    for (const int degree : {10, 18, 25}) {
        const Curve curve = high_degree_curve(degree, 6, random);
        std::vector<double> added;
        for (int i = 0; i < 60; ++i) added.push_back(random.number(0.0, curve.domain().upper));
        for (int i = 0; i < 4; ++i) added.push_back(added[0] + (i + 1) * 1e-9);
        std::erase_if(added, [&](double u) { return u > curve.domain().upper; });
        const Curve refined = refine_knots(curve, added).value();
        EXPECT_LE(shape_change(curve, refined, random), 1e-14);
        const Curve far = moved(curve, {1e6, -3e6});
        EXPECT_LE(shape_change(far, refine_knots(far, added).value(), random), 1e-15);
    }
}

TEST(KnotRefinement, copies_what_it_does_not_reach) {
    RandomCurves random(303);
    const Curve curve = high_degree_curve(3, 30, random);
    const double u = 0.5 * (curve.knots()[15] + curve.knots()[16]);
    const Curve refined = refine_knots(curve, {u, u}).value();
    // Points 12..15 act on the span; the ones that stay whole are those up to 12 and from 15 on.
    for (std::size_t i = 0; i <= 12; ++i) EXPECT_EQ(refined.control_points()[i], curve.control_points()[i]);
    for (std::size_t i = 15; i < 33; ++i) {
        EXPECT_EQ(refined.control_points()[i + 2], curve.control_points()[i]);
        EXPECT_EQ(refined.weights()[i + 2], curve.weights()[i]);
    }
}

// Counts the blends: each multiplies one point once.
struct Counted {
    double value = 0.0;
    static inline std::size_t products = 0;
    friend Counted operator+(Counted a, Counted b) { return {a.value + b.value}; }
    friend Counted operator-(Counted a, Counted b) { return {a.value - b.value}; }
    friend Counted operator*(double factor, Counted a) {
        ++products;
        return {factor * a.value};
    }
};

Spline<Counted> counted_spline(std::size_t p, std::size_t spans) {
    Spline<Counted> spline{.p = p, .knots = std::vector(p + 1, 0.0)};
    for (std::size_t i = 1; i < spans; ++i) spline.knots.push_back(static_cast<double>(i));
    spline.knots.insert(spline.knots.end(), p + 1, static_cast<double>(spans));
    spline.points.resize(p + spans);
    return spline;
}

TEST(KnotRefinement, costs_at_most_p_blends_for_each_knot) {
    for (const std::size_t p : {1U, 3U, 8U, 25U})
        for (const std::size_t spans : {10U, 100U, 1000U}) {
            Spline<Counted> spline = counted_spline(p, spans);
            std::vector<double> middles;
            for (std::size_t i = 0; i < spans; ++i) middles.push_back(static_cast<double>(i) + 0.5);
            Counted::products = 0;
            insert_ascending<Counted>(spline, middles);
            EXPECT_EQ(Counted::products, p * spans);

            // Each further knot of the same value blends one point fewer.
            Spline<Counted> whole = counted_spline(p, spans);
            Counted::products = 0;
            insert_ascending<Counted>(whole, knots_missing_for_pieces(whole));
            EXPECT_EQ(Counted::products, (spans - 1) * p * (p - 1) / 2);
        }
}

TEST(KnotRefinement, refuses_what_insertion_refuses) {
    using Code = CurveErrorCode;
    const Curve curve = Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 2, 2, 2}, .points = {4, Point(1, 2)}}).value();
    EXPECT_EQ(refine_knots(curve, {0.5, std::nan("")}).error().code, Code::parameter_not_finite);
    EXPECT_EQ(refine_knots(curve, {0.5, 3.0}).error(),
              (CurveError{.code = Code::parameter_outside_domain, .value = 3, .lower = 0, .upper = 2}));
    EXPECT_EQ(refine_knots(curve, {1.0, 0.5, 1.0}).error(),
              (CurveError{.code = Code::multiplicity_full, .value = 1, .upper = 2}));
    EXPECT_EQ(refine_knots(curve, {}).value(), curve);
    const Curve ring =
        Curve::make({.degree = 2, .knots = {0, 1, 2}, .points = {{0, 0}, {1, 2}}, .periodic = true}).value();
    EXPECT_EQ(refine_knots(ring, {0.0, 2.0}).error().code, Code::multiplicity_full);
    EXPECT_TRUE(refine_knots(ring, {0.0, 1.0, 0.5, 0.5}));
}

}  // namespace
}  // namespace batten::core
