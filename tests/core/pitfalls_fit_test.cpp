// Bugs that other programs have when they fit curves to points.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/make/fit.h"
#include "core/make/interpolate.h"
#include "tests/core/random_curves.h"

namespace batten::core {

namespace {

// A walk with clusters and long steps.
std::vector<Point> walk(RandomCurves& random, std::size_t count) {
    std::vector<Point> points{{0, 0}};
    while (points.size() < count) {
        const double step = random.whole(0, 4) == 0 ? 5.0 : 0.05;
        const double x = points.back().x + random.number(0.1, 1.0) * step;
        points.emplace_back(x, points.back().y + random.number(-1.0, 1.0) * step);
    }
    return points;
}

// Whether every span of the domain has a point between its knots, ends of the domain included.
bool has_points_in_every_span(const Curve& curve, std::span<const double> parameters) {
    const auto knots = curve.knots().values();
    const Interval domain = curve.domain();
    constexpr double rounding = 1e-15;  // of knots and parameters from 0 to 1
    for (std::size_t s = 0; s + 1 < knots.size(); ++s) {
        if (knots[s] == knots[s + 1] || !domain.contains(knots[s]) || !domain.contains(knots[s + 1])) continue;
        const bool is_met = std::any_of(parameters.begin(), parameters.end(), [&](double u) {
            return knots[s] - rounding <= u && u < knots[s + 1] + (knots[s + 1] == domain.upper ? 1.0 : rounding);
        });
        if (!is_met) return false;
    }
    return true;
}

}  // namespace

TEST(PitfallsFit, p12_fitting_leaves_points_in_every_span) {
    RandomCurves random(91);
    for (int trial = 0; trial < 60; ++trial) {
        const auto points = walk(random, static_cast<std::size_t>(random.whole(12, 80)));
        const int degree = random.whole(1, 6);
        const auto parameters = parametrize(points, Parametrization::chordal).value();
        for (std::size_t count = static_cast<std::size_t>(degree) + 1; count <= points.size(); count += 3)
            EXPECT_TRUE(has_points_in_every_span(fit(points, count, {.degree = degree}).value().curve, parameters))
                << points.size() << ' ' << count;
        const auto found = fit_within(points, 0.05, {.degree = degree}).value();
        EXPECT_TRUE(has_points_in_every_span(found.curve, parameters));
        EXPECT_LE(found.error, 0.05);
    }
}

TEST(PitfallsFit, p12_fitting_the_reversed_points_gives_the_reversed_curve_bit_for_bit) {
    RandomCurves random(92);
    for (int trial = 0; trial < 60; ++trial) {
        const auto points = walk(random, static_cast<std::size_t>(random.whole(12, 60)));
        const std::vector<Point> backwards(points.rbegin(), points.rend());
        FitRequest request{.degree = random.whole(2, 6)};
        FitRequest back = request;
        const int ends = random.whole(0, 2);
        if (ends == 0) {
            request.ends = EndTangents{.start = Vector(30, 10)};
            back.ends = EndTangents{.end = Vector(-30, -10)};
        } else if (ends == 1 && request.degree >= 3) {
            request.ends = back.ends = NaturalEnds{};
        }
        const bool is_counted = random.whole(0, 1) == 0;
        const auto a = is_counted ? fit(points, 9, request).value() : fit_within(points, 0.1, request).value();
        const auto b = is_counted ? fit(backwards, 9, back).value() : fit_within(backwards, 0.1, back).value();
        EXPECT_EQ(a.error, b.error);
        const auto there = a.curve.definition();
        const auto again = b.curve.definition();
        ASSERT_EQ(there.points.size(), again.points.size());
        EXPECT_TRUE(std::equal(there.points.begin(), there.points.end(), again.points.rbegin()));
        for (std::size_t i = 0; i < there.knots.size(); ++i)
            EXPECT_EQ(there.knots[i], 1.0 - again.knots[there.knots.size() - 1 - i]);
    }
}

TEST(PitfallsFit, p12_fitting_a_closed_curve_backwards_gives_the_reversed_curve_bit_for_bit) {
    RandomCurves random(93);
    for (const int degree : {2, 3, 4, 5}) {
        std::vector<Point> points;
        for (int k = 0; k < 30; ++k) {
            const double x = random.number(-1.0, 1.0);
            points.emplace_back(x, random.number(-1.0, 1.0));
        }
        auto backwards = points;
        std::reverse(backwards.begin() + 1, backwards.end());
        const auto a = fit(points, 10, {.degree = degree, .ends = ClosedEnds{}}).value().curve;
        const auto b = fit(backwards, 10, {.degree = degree, .ends = ClosedEnds{}}).value().curve;
        const auto p = static_cast<std::size_t>(degree);
        for (std::size_t i = 0; i < 10; ++i) {
            EXPECT_EQ(a.control_points()[i], b.control_points()[(p + 19 - i) % 10]);
            EXPECT_EQ(a.knots().stored()[i], 1.0 - b.knots().stored()[10 - i]);
        }
    }
}

}  // namespace batten::core
