#include "core/measure/meeting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/make/conics.h"
#include "core/make/shapes.h"
#include "core/refine/reverse.h"
#include "tests/core/joint_jumps.h"
#include "tests/core/shape_check.h"

namespace batten::core {
namespace {

// (t, a t^3 / 6): at the start curvature 0 and its change a.
Curve cubic(double a) {
    return Curve::make({.degree = 3,
                        .knots = {0, 0, 0, 0, 1, 1, 1, 1},
                        .points = {{0, 0}, {1.0 / 3, 0}, {2.0 / 3, 0}, {1, a / 6}}})
        .value();
}

TEST(Meeting, of_an_arc_is_that_of_a_circle) {
    for (const double radius : {1e-6, 1.0, 2.5, 1e6}) {
        const Curve arc = circular_arc({3 * radius, radius}, radius, {30, 80}).value();
        for (const double u : {0.0, 0.3, 0.5, 1.0}) {
            const Passing passing = passing_at(arc, u, u == 1.0 ? Side::left : Side::right);
            EXPECT_NEAR(*passing.curvature * radius, 1.0, 1e-13);
            EXPECT_NEAR(*passing.change * radius * radius, 0.0, 1e-11);
        }
        const Passing start = passing_at(arc, CurveEnd::start);
        EXPECT_NEAR(start.direction->x, -0.5, 1e-14);
        EXPECT_NEAR(start.direction->y, std::sqrt(0.75), 1e-14);
        // Beyond the start it runs clockwise.
        EXPECT_NEAR(*passing_beyond(arc, CurveEnd::start).curvature * radius, -1.0, 1e-13);
        EXPECT_NEAR(passing_beyond(arc, CurveEnd::start).direction->x, 0.5, 1e-14);
    }
}

TEST(Meeting, knows_the_change_of_curvature) {
    const Passing passing = passing_at(cubic(5.0), CurveEnd::start);
    EXPECT_EQ(*passing.curvature, 0.0);
    EXPECT_NEAR(*passing.change, 5.0, 1e-14);
    // Run through the other way the curvature still grows to the same side: (-k)' by -s.
    const Passing back = passing_at(reverse(cubic(5.0)).value(), CurveEnd::end);
    EXPECT_NEAR(*back.change, 5.0, 1e-13);
    EXPECT_NEAR(*run_back(passing).change, 5.0, 1e-14);
    RandomCurves random(81);
    for (int k = 0; k < 50; ++k) {
        const Curve curve = high_degree_curve(3 + k % 3, 3, random);
        const double u = random.number(0.01, 0.99) * curve.domain().upper;
        const Passing found = passing_at(curve, u, Side::right);
        const double change = change_by_differences(curve, u, Side::right);
        EXPECT_NEAR(*found.change, change, 1e-4 * (std::abs(change) + *found.curvature * *found.curvature)) << k;
    }
}

TEST(Meeting, tells_how_smooth_it_is) {
    const Curve line = core::line({-1, 0}, {0, 0}).value();
    const auto level = [&](const Curve& second) {
        return smoothness_of(meeting_of(passing_at(line, CurveEnd::end), passing_at(second, CurveEnd::start)), 2.0);
    };
    EXPECT_EQ(level(core::line({0, 1e-3}, {1, 0}).value()), -1);
    EXPECT_EQ(level(core::line({0, 0}, {1, 1e-3}).value()), 0);
    EXPECT_EQ(level(circular_arc({0, 2}, 2, {270, 30}).value()), 1);
    EXPECT_EQ(level(cubic(5.0)), 2);
    EXPECT_EQ(level(core::line({0, 0}, {1, 0}).value()), 3);
    EXPECT_EQ(level(cubic(1e-9)), 3);
    const Meeting quarter =
        meeting_of(passing_at(line, CurveEnd::end), passing_at(core::line({0, 0}, {0, -3}).value(), CurveEnd::start));
    EXPECT_NEAR(*quarter.angle, -0.5 * std::numbers::pi, 1e-15);
    EXPECT_NEAR(*run_back(quarter).angle, 0.5 * std::numbers::pi, 1e-15);
    const Meeting bent = meeting_of(passing_at(line, CurveEnd::end),
                                    passing_at(circular_arc({0, 2}, 2, {270, 30}).value(), CurveEnd::start));
    EXPECT_NEAR(*bent.after, 0.5, 1e-14);
    EXPECT_NEAR(*run_back(bent).before, -0.5, 1e-14);
}

TEST(Meeting, is_as_smooth_as_the_curve_that_was_cut_also_when_it_is_far_away_or_long) {
    RandomCurves random(82);
    for (const double far : {0.0, 1e6}) {
        std::vector<Point> points;
        CurveDefinition definition{.degree = 5};
        for (std::size_t i = 0; i < 2000; ++i) {
            const double x = 0.01 * static_cast<double>(i);
            points.emplace_back(far + x, far + std::sin(x) + random.number(-1e-3, 1e-3));
        }
        definition.points = points;
        for (std::size_t i = 0; i < points.size() + 6; ++i) definition.knots.push_back(static_cast<double>(i));
        const Curve curve = Curve::make(definition).value();
        // A knot at which four derivatives agree.
        for (const double u : {6.0, 100.0, 1990.0})
            EXPECT_EQ(
                smoothness_of(meeting_of(passing_at(curve, u, Side::left), passing_at(curve, u, Side::right)), 20), 3)
                << far << ' ' << u;
    }
}

TEST(Meeting, has_no_numbers_where_a_curve_stands_still) {
    const Curve still =
        Curve::make({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{0, 0}, {0, 0}, {1, 0}, {1, 1}}})
            .value();
    const Passing passing = passing_at(still, CurveEnd::start);
    EXPECT_TRUE(passing.direction);
    EXPECT_FALSE(passing.curvature);
    EXPECT_FALSE(passing.change);
    const Curve point = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{1, 1}, {1, 1}}}).value();
    EXPECT_FALSE(passing_at(point, CurveEnd::end).direction);
    EXPECT_EQ(smoothness_of(meeting_of(passing, passing), 1.0), 1);
    EXPECT_EQ(smoothness_of(meeting_of(passing_at(point, CurveEnd::end), passing_at(point, CurveEnd::end)), 1.0), 0);
}

}  // namespace
}  // namespace batten::core
