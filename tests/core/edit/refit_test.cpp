#include "core/edit/refit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/edit/point_edit.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/deviation.h"
#include "core/measure/smoothness.h"
#include "tests/core/random_curves.h"

namespace batten::core {

namespace {

Curve cubic_run(std::size_t n, bool periodic = false) {
    CurveDefinition definition{.degree = 3, .knots = {}, .points = {}, .periodic = periodic};
    for (std::size_t i = 0; i < n; ++i) {
        const double a = periodic ? 6.283185307179586 * static_cast<double>(i) / static_cast<double>(n)
                                  : 0.37 * static_cast<double>(i);
        definition.points.emplace_back(periodic ? 5.0 * std::cos(a) : static_cast<double>(i), 3.0 * std::sin(2.0 * a));
    }
    for (std::size_t i = 0; i < (periodic ? n + 1 : n + 4); ++i)
        definition.knots.push_back(static_cast<double>(periodic ? i : std::min(std::max<std::size_t>(i, 3), n)));
    return Curve::make(std::move(definition)).value();
}

double squared_error(const Curve& a, const Curve& b) {
    const Interval domain = a.domain();
    double sum = 0.0;
    const int steps = 4000;
    for (int k = 0; k < steps; ++k) {
        const double u = domain.lower + domain.length() * (k + 0.5) / steps;
        const Vector d = point_at(a, u) - point_at(b, u);
        sum += dot(d, d) * domain.length() / steps;
    }
    return sum;
}

}  // namespace

// The residual in Bernstein form is e1 B1 + e2 B2; its norm is least where e1 + e2 = 0.
TEST(Refit, the_parabola_nearest_to_a_cubic_is_the_one_by_hand) {
    const std::vector<Point> P{{0, 0}, {1, 4}, {3, -1}, {5, 2}};
    const Curve cubic = Curve::make({.degree = 3, .knots = {0, 0, 0, 0, 2, 2, 2, 2}, .points = P}).value();
    const Curve pattern =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 2, 2, 2}, .points = {P[0], {9, 9}, P[3]}}).value();
    const auto found = refit(pattern, cubic).value();
    EXPECT_NEAR(found.curve.control_points()[1].x, (3.0 * 1 + 3.0 * 3 - 0 - 5) / 4.0, 1e-13);
    EXPECT_NEAR(found.curve.control_points()[1].y, (3.0 * 4 - 3.0 * 1 - 0 - 2) / 4.0, 1e-13);
    EXPECT_EQ(found.curve.control_points()[0], P[0]);
    EXPECT_EQ(found.curve.control_points()[2], P[3]);
    EXPECT_EQ(found.error, largest_deviation(cubic, found.curve));
}

TEST(Refit, finds_a_curve_that_is_over_the_same_knots_again) {
    RandomCurves random(11);
    for (int k = 0; k < 200; ++k) {
        const Curve curve = random.curve();
        std::vector<std::size_t> inner;
        CurveDefinition definition = curve.definition();
        const std::size_t n = definition.points.size();
        for (std::size_t i = curve.is_periodic() ? 0 : 1; i + (curve.is_periodic() ? 0 : 1) < n; ++i)
            inner.push_back(i);
        if (curve.degree() > 3 || curve.knots()[1] != curve.domain().lower) continue;
        const Curve moved = move_control_points(curve, inner, {0.3, -0.2}).value();
        const auto outcome = refit(moved, curve);
        ASSERT_TRUE(outcome) << k << describe(outcome.error()) << curve.degree() << curve.is_periodic() << n;
        const Approximation& found = *outcome;
        EXPECT_LE(found.error, largest_deviation(curve, moved) * (1.0 + 1e-9) + 1e-12) << k;
        if (smoothness_losses(curve, moved).empty()) continue;
        EXPECT_LT(found.error, 1e-6) << k;
    }
}

// Of a closed curve also where the point is beside the seam, where the last ones are near it.
TEST(Refit, what_is_far_from_a_point_that_goes_keeps_every_bit) {
    for (const bool periodic : {false, true})
        for (const std::size_t gone : {std::size_t{1}, std::size_t{30}, std::size_t{58}}) {
            const Curve curve = cubic_run(60, periodic);
            const std::vector<std::size_t> indices{gone};
            const auto pattern = delete_control_points(curve, indices).value();
            const auto found = delete_points_and_refit(curve, indices).value();
            EXPECT_LE(found.error, largest_deviation(curve, pattern));
            std::size_t kept = 0;
            for (std::size_t i = 0; i < 59; ++i) {
                const std::size_t old = i < gone ? i : i + 1;
                const std::size_t along = old < gone ? gone - old : old - gone;
                const std::size_t away = periodic ? std::min(along, 60 - along) : along;
                const bool is_kept = found.curve.control_points()[i] == curve.control_points()[old];
                kept += is_kept ? 1 : 0;
                EXPECT_TRUE(is_kept || away <= 12) << periodic << gone << ' ' << i;
            }
            EXPECT_LT(kept, 58U);
        }
}

TEST(Refit, no_move_of_a_point_brings_a_curve_nearer) {
    for (const bool periodic : {false, true}) {
        const Curve curve = cubic_run(24, periodic);
        const std::vector<std::size_t> gone{9, 10, 15};
        const Curve found = delete_points_and_refit(curve, gone).value().curve;
        const double least = squared_error(curve, found);
        EXPECT_LT(least, 0.9 * squared_error(curve, delete_control_points(curve, gone).value()));
        for (const std::size_t i : {8u, 9u, 11u, 13u})
            for (const Vector move : {Vector{0.01, 0.0}, {-0.01, 0.0}, {0.0, 0.01}, {0.0, -0.01}})
                EXPECT_GT(squared_error(curve, set_control_point(found, i, found.control_points()[i] + move).value()),
                          least);
    }
}

TEST(DeletePointsAndRefit, leaves_what_is_far_away_to_the_last_bit) {
    CurveDefinition definition = cubic_run(10'000).definition();
    definition.kind = KnotKind::custom;
    const Curve curve = Curve::make(std::move(definition)).value();
    const std::vector<std::size_t> gone{5000};
    const auto found = delete_points_and_refit(curve, gone).value();
    const Curve pattern = delete_control_points(curve, gone).value();
    ASSERT_EQ(found.curve.control_points().size(), 9999u);
    EXPECT_EQ(found.curve.knots(), pattern.knots());
    for (std::size_t i = 0; i < 9999; ++i) {
        const bool is_far = i + 12 < 5000 || i > 5012;
        if (!is_far) continue;
        ASSERT_EQ(found.curve.control_points()[i], curve.control_points()[i < 5000 ? i : i + 1]) << i;
    }
    EXPECT_LT(found.error, 0.5 * largest_deviation(curve, pattern));
}

TEST(DeletePointsAndRefit, a_point_too_many_is_refused_and_no_point_is_none) {
    const Curve curve = cubic_run(5);
    const std::vector<std::size_t> gone{1, 2};
    EXPECT_EQ(delete_points_and_refit(curve, gone).error().code, CurveErrorCode::too_few_points);
    const std::vector<std::size_t> outside{7};
    EXPECT_EQ(delete_points_and_refit(curve, outside).error().code, CurveErrorCode::point_index_out_of_range);
    const auto same = delete_points_and_refit(curve, {}).value();
    EXPECT_EQ(same.curve, curve);
    EXPECT_EQ(same.error, 0.0);
}

TEST(DeletePointsAndRefit, is_sound_on_random_curves) {
    RandomCurves random(5);
    for (int k = 0; k < 400; ++k) {
        const Curve curve = random.curve();
        const std::vector<std::size_t> gone{static_cast<std::size_t>(random.whole(0, 3)) %
                                            curve.control_points().size()};
        const auto found = delete_points_and_refit(curve, gone);
        if (!found) {
            EXPECT_TRUE(found.error().code == CurveErrorCode::too_few_points ||
                        found.error().code == CurveErrorCode::equations_singular)
                << k << describe(found.error());
            continue;
        }
        EXPECT_EQ(found->curve.control_points().size() + 1, curve.control_points().size());
        EXPECT_TRUE(std::isfinite(found->error)) << k;
        const Interval domain = curve.domain();
        for (int j = 0; j <= 100; ++j) {
            const double u = domain.lower + domain.length() * j / 100;
            if (!found->curve.domain().contains(u)) continue;
            EXPECT_LE(distance(point_at(curve, u), point_at(found->curve, u)), found->error + 1e-9) << k;
        }
    }
}

}  // namespace batten::core
