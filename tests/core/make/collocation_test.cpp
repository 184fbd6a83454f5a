#include "core/make/detail/collocation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/make/detail/end_conditions.h"
#include "core/make/detail/site_means.h"
#include "core/make/parametrization.h"
#include "tests/core/random_curves.h"

namespace batten::core {

namespace {

// Sites, their points, and what holds at the ends of a spline through them.
struct Task {
    std::vector<double> sites;
    std::vector<Point> points;
    Ends ends;
};

// A walk with steps that are not very uneven.
Task random_task(RandomCurves& random, std::size_t count, const Ends& ends) {
    const EndNeeds needs = needs_of(ends);
    Task task{{}, {}, ends};
    double site = random.number(-2.0, 2.0);
    Point point(random.number(-2.0, 2.0), 1.0);
    for (std::size_t r = 0; r < count; ++r) {
        const bool is_repeated = (r == 1 && needs.at_start > 0) || (r + 1 == count && needs.at_end > 0);
        if (r > 0 && !is_repeated) {
            site += random.number(0.7, 1.3);
            point += Vector(random.number(0.5, 1.5), 0.0);
            point += Vector(0.0, random.number(-0.5, 1.0));
        }
        task.sites.push_back(site);
        task.points.push_back(point);
    }
    return task;
}

KnotVector knots_of(const Task& task) {
    return KnotVector::make(3, averaged_knots(task.sites, 3)).value();
}

EndPoints end_points_of(const Task& task, const KnotVector& knots) {
    return end_points(task.points.front(), task.points.back(), task.ends, knots);
}

std::optional<std::vector<Point>> by_collocation(const Task& task) {
    const KnotVector knots = knots_of(task);
    const EndPoints ends = end_points_of(task, knots);
    std::vector<Point> points = task.points;
    for (const KnownPoint& known : ends.known) points[known.index] = known.point;
    return collocated({knots.values(), task.sites, points, ends});
}

// The slow way, with Givens rotations and a second pass in twice the precision.
std::vector<Point> by_rotations(const Task& task) {
    const KnotVector knots = knots_of(task);
    SplineSystem system(knots, task.points.front(), end_points_of(task, knots));
    for (std::size_t r = 1; r + 1 < task.sites.size(); ++r)
        if (task.sites.front() < task.sites[r] && task.sites[r] < task.sites.back())
            system.require_point(task.sites[r], task.points[r]);
    return system.solve().value();
}

double largest_coordinate(std::span<const Point> points) {
    double largest = 0.0;
    for (const Point& point : points) largest = std::max({largest, std::abs(point.x), std::abs(point.y)});
    return largest;
}

}  // namespace

TEST(Collocation, agrees_with_rotations_for_all_ends_and_counts) {
    RandomCurves random(81);
    std::size_t solved = 0;
    for (std::size_t count = 6; count < 40; ++count)
        for (const Ends& ends : {Ends(FreeEnds{}), Ends(NaturalEnds{}), Ends(EndTangents{Vector(1, -2), Vector(3, 1)}),
                                 Ends(EndTangents{Vector(4, 4), {}}), Ends(EndTangents{{}, Vector(-4, 4)})}) {
            const Task task = random_task(random, count, ends);
            const auto found = by_collocation(task);
            if (!found) continue;
            ++solved;
            const auto expected = by_rotations(task);
            ASSERT_EQ(found->size(), expected.size());
            const double size = largest_coordinate(expected);
            for (std::size_t i = 0; i < expected.size(); ++i)
                EXPECT_LE(distance((*found)[i], expected[i]), 5e-16 * size) << count << ' ' << i;
        }
    EXPECT_GT(solved, 100U);
}

// Rows are filled in blocks of 128 from both ends.
TEST(Collocation, agrees_with_rotations_where_blocks_meet) {
    RandomCurves random(82);
    for (const std::size_t count : {254U, 255U, 256U, 257U, 258U, 512U, 513U}) {
        const Task task = random_task(random, count, FreeEnds{});
        const auto found = by_collocation(task);
        ASSERT_TRUE(found) << count;
        const auto expected = by_rotations(task);
        const double size = largest_coordinate(expected);
        for (std::size_t i = 0; i < count; ++i)
            EXPECT_LE(distance((*found)[i], expected[i]), 5e-16 * size) << count << ' ' << i;
    }
}

// Where errors would be seen there is no answer, and the slow way has to find one.
TEST(Collocation, does_not_answer_where_steps_are_too_uneven) {
    RandomCurves random(83);
    Task task = random_task(random, 20, FreeEnds{});
    EXPECT_TRUE(by_collocation(task));
    for (std::size_t r = 10; r < task.sites.size(); ++r) task.sites[r] -= task.sites[10] - task.sites[9] - 1e-9;
    EXPECT_FALSE(by_collocation(task));
}

TEST(SiteMeans, are_rounded_once_and_stay_among_their_sites) {
    const double sites[] = {0.1, 0.2, 0.4, 0.7, 1.1};
    double means[3];
    mean_of_sites(sites, 3, means);
    // (0.1 + 0.2 + 0.4) / 3, (0.2 + 0.4 + 0.7) / 3 and (0.4 + 0.7 + 1.1) / 3 of the doubles nearest to these numbers.
    EXPECT_EQ(means[0], 0.23333333333333334);
    EXPECT_EQ(means[1], 0.43333333333333335);
    EXPECT_EQ(means[2], 0.7333333333333334);
    const double next = std::nextafter(1.0, 2.0);
    const double close[] = {1.0, next, next, next};
    mean_of_sites(close, 4, std::span(means, 1));
    EXPECT_EQ(means[0], next);
}

}  // namespace batten::core
