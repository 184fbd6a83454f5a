#include "core/edit/rebuild.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/evaluate/evaluate.h"
#include "core/make/conics.h"
#include "core/make/shapes.h"
#include "core/refine/periodic.h"

namespace batten::core {

TEST(Rebuild, a_line_gets_even_points_and_an_even_speed) {
    const Curve uneven =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {0.2, 0.1}, {4, 2}}}).value();
    const auto found = rebuild(uneven, 5, 1).value();
    ASSERT_EQ(found.curve.control_points().size(), 5u);
    EXPECT_EQ(found.curve.knots().kind(), KnotKind::clamped_uniform);
    for (int i = 0; i < 5; ++i)
        EXPECT_LT(distance(found.curve.control_points()[static_cast<std::size_t>(i)], Point(i, 0.5 * i)), 1e-12);
    EXPECT_LT(found.error, 1e-4);
}

TEST(Rebuild, an_arc_keeps_its_ends_to_the_last_bit_and_its_radius_the_better_the_more_points) {
    const Curve arc = circular_arc({1, 2}, 10.0, {20.0, 200.0}).value();
    double before = 1.0;
    for (const std::size_t count : {6u, 12u, 24u}) {
        const auto found = rebuild(arc, count, 3).value();
        const Interval domain = arc.domain();
        EXPECT_EQ(found.curve.domain(), domain);
        EXPECT_EQ(found.curve.control_points().front(), arc.control_points().front());
        EXPECT_EQ(found.curve.control_points().back(), arc.control_points().back());
        double worst = 0.0;
        for (int k = 0; k <= 1000; ++k)
            worst = std::max(worst, std::abs(distance(point_at(found.curve, domain.lower + domain.length() * k / 1000),
                                                      Point(1, 2)) -
                                             10.0));
        EXPECT_LE(worst, 1.01 * found.error);
        EXPECT_LT(worst, 0.2 * before);
        before = worst;
        for (const double share : {0.1, 0.5, 0.77})
            EXPECT_NEAR(distance(point_at(found.curve, domain.lower + share * domain.length()),
                                 Point(1 + 10 * std::cos((20 + 200 * share) * std::numbers::pi / 180),
                                       2 + 10 * std::sin((20 + 200 * share) * std::numbers::pi / 180))),
                        0.0, 1.01 * found.error)
                << share;
    }
    EXPECT_LT(before, 1e-4);
}

TEST(Rebuild, a_periodic_curve_stays_periodic_and_smooth) {
    const Curve round = to_periodic(circle({0, 0}, 3.0).value(), 1e-9).value().curve;
    const auto found = rebuild(round, 16, 3).value();
    EXPECT_TRUE(found.curve.is_periodic());
    EXPECT_EQ(found.curve.knots().kind(), KnotKind::periodic);
    for (const Point& point : found.curve.control_points()) EXPECT_NEAR(distance(point, {0, 0}), 3.0, 0.1);
    EXPECT_LT(found.error, 2e-3);
}

TEST(Rebuild, many_points_from_few_and_few_from_many) {
    std::vector<Point> points;
    for (int i = 0; i < 3000; ++i) points.emplace_back(i, 100.0 * std::sin(i * 0.01));
    const Curve wave = polyline(points).value();
    const auto few = rebuild(wave, 40, 5).value();
    EXPECT_LT(few.error, 2.0);
    const auto many = rebuild(few.curve, 3000, 3).value();
    EXPECT_LT(many.error, 1e-4);
}

TEST(Rebuild, what_cannot_be_is_refused) {
    const Curve line = core::line({0, 0}, {1, 0}).value();
    EXPECT_EQ(rebuild(line, 3, 3).error().code, CurveErrorCode::too_few_points);
    EXPECT_EQ(rebuild(line, 30, 26).error().code, CurveErrorCode::degree_out_of_range);
    const Curve dot = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{2, 2}, {2, 2}}}).value();
    EXPECT_EQ(rebuild(dot, 4, 3).error().code, CurveErrorCode::curve_stands_still);
}

}  // namespace batten::core
