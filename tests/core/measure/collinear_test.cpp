#include "core/measure/collinear.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/evaluate/evaluate.h"
#include "tests/core/uniform_curves.h"

namespace batten::core {

namespace {

// The largest distance of the curve over the run's interval from the chord of that interval.
double bend(const Curve& curve, Interval straight) {
    const Point from = point_at(curve, straight.lower);
    Vector chord = point_at(curve, straight.upper) - from;
    chord /= length(chord);
    double worst = 0.0;
    for (int k = 0; k <= 50; ++k) {
        const Vector to = point_at(curve, straight.lower + straight.length() * k / 50) - from;
        worst = std::max(worst, std::abs(cross(chord, to)));
    }
    return worst;
}

}  // namespace

TEST(CollinearRuns, finds_two_runs_that_share_their_corner) {
    const Curve curve = open_curve(2, {{0, 0}, {1, 0}, {3, 0}, {4, 0}, {4, 1}, {4, 5}, {5, 7}});
    const auto runs = collinear_runs(curve);
    ASSERT_EQ(runs.size(), 2u);
    EXPECT_EQ(runs[0].first, 0u);
    EXPECT_EQ(runs[0].count, 4u);
    EXPECT_EQ(runs[0].straight, (Interval{0, 2}));
    EXPECT_EQ(runs[1].first, 3u);
    EXPECT_EQ(runs[1].count, 3u);
    EXPECT_EQ(runs[1].straight, (Interval{3, 4}));
    for (const CollinearRun& run : runs) EXPECT_LE(bend(curve, run.straight), 1e-15);
    EXPECT_GT(bend(curve, {2, 3}), 0.1);
}

TEST(CollinearRuns, are_maximal_and_long_enough) {
    EXPECT_TRUE(collinear_runs(open_curve(3, {{0, 0}, {1, 0}, {2, 0}, {3, 1}, {4, 3}})).empty());
    const auto runs = collinear_runs(open_curve(3, {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 3}}));
    ASSERT_EQ(runs.size(), 1u);
    EXPECT_EQ(runs[0].straight, (Interval{0, 1}));
    // Points going back and forth, and equal points, are on the line as well.
    EXPECT_EQ(collinear_runs(open_curve(2, {{0, 0}, {0, 0}, {3, 3}, {1, 1}, {2, 2}})).front().count, 5u);
    EXPECT_EQ(collinear_runs(open_curve(2, {{0, 0}, {1, 1e-9}, {2, 0}})).size(), 0u);
    EXPECT_EQ(collinear_runs(open_curve(2, {{0, 0}, {1, 1e-9}, {2, 0}}), 1e-8).size(), 1u);
}

TEST(CollinearRuns, tolerance_is_relative_to_size_and_place) {
    for (const double scale : {1e-9, 1.0, 1e9})
        for (const double offset : {0.0, 1e6}) {
            const auto place = [&](double x, double y) { return Point(scale * (x + offset), scale * (y + offset)); };
            const Curve bent = open_curve(2, {place(0, 0), place(1, 0.001), place(2, 0), place(3, 5)});
            EXPECT_TRUE(collinear_runs(bent).empty()) << scale << ' ' << offset;
            const Curve straight = open_curve(2, {place(0, 0), place(0.1, 0.3), place(0.2, 0.6), place(3, 5)});
            EXPECT_EQ(collinear_runs(straight).size(), 1u) << scale << ' ' << offset;
        }
}

TEST(CollinearRuns, does_not_follow_a_slow_bend) {
    std::vector<Point> circle;
    for (int k = 0; k < 2000; ++k) circle.emplace_back(std::cos(k * 1e-3), std::sin(k * 1e-3));
    EXPECT_TRUE(collinear_runs(open_curve(3, circle), 1e-8).empty());
}

TEST(CollinearRuns, passes_the_seam) {
    // A square with three points on each side, the seam in the middle of a side.
    const Curve curve = closed_curve(2, {{1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}, {0, 0}});
    const auto runs = collinear_runs(curve);
    ASSERT_EQ(runs.size(), 4u);
    EXPECT_EQ(runs[3].first, 7u);
    EXPECT_EQ(runs[3].count, 3u);
    EXPECT_EQ(runs[3].straight, (Interval{7, 8}));
    for (const CollinearRun& run : runs) EXPECT_LE(bend(curve, run.straight), 1e-15) << run.first;
    const auto whole = collinear_runs(closed_curve(2, {{0, 0}, {1, 1}, {2, 2}}));
    ASSERT_EQ(whole.size(), 1u);
    EXPECT_EQ(whole[0].count, 5u);
    EXPECT_EQ(whole[0].straight, (Interval{0, 3}));
}

}  // namespace batten::core
