#include "core/measure/near_parts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "core/curve/knot_kinds.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/nearest.h"
#include "tests/core/golden.h"
#include "tests/core/random_curves.h"

namespace batten::core {
namespace {

/// From radius 1 to 2.
Curve spiral(std::size_t count, double turns = 10.0) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(count - 1);
        const double angle = 6.28 * turns * share;
        points.emplace_back((1.0 + share) * std::cos(angle), (1.0 + share) * std::sin(angle));
    }
    return Curve::make(make_knots(KnotKind::clamped_uniform, 3, count).value(), std::move(points), {}).value();
}

std::size_t looks_at(const Curve& curve, Point query, double reach) {
    std::size_t looks = 0;
    static_cast<void>(NearParts(curve).nearest(query, reach, &looks));
    return looks;
}

TEST(Golden, closest_point_by_near_parts) {
    golden::Tally tally("closest_point.json by near parts");
    for (const auto& members : golden::cases("closest_point.json")) {
        tally.count_case();
        const auto name = members.at("name").get<std::string>();
        const Curve curve = golden::curve_of(members);
        const Point query(members.at("query").at(0).get<double>(), members.at("query").at(1).get<double>());
        const auto found = NearParts(curve).nearest(query);
        ASSERT_TRUE(found) << name;
        const double size = golden::largest_coordinate(curve.control_points());
        const double distance = members.at("distance").get<double>();
        tally.add("distance", std::abs(core::distance(found->point, query) - distance) / size, 1e-14, name);
    }
}

TEST(NearParts, find_the_nearest_point_of_the_whole_curve) {
    RandomCurves random(75);
    for (int i = 0; i < 500; ++i) {
        const Curve curve = random.curve();
        const double size = 1e-3 + golden::largest_coordinate(curve.control_points());
        const double scale = i % 3 == 0 ? 10.0 : 1.0;
        const double x = random.number(-size, size);
        const Point query(scale * x, scale * random.number(-size, size));
        const auto found = NearParts(curve).nearest(query);
        ASSERT_TRUE(found);
        EXPECT_NEAR(distance(found->point, query), distance(nearest_point(curve, query).point, query),
                    1e-13 * scale * size);
    }
}

TEST(NearParts, find_nothing_beyond_reach) {
    const NearParts parts(spiral(1000));
    const CurveSample nearest = nearest_point(parts.curve(), {0.0, 0.3});
    const double away = distance(nearest.point, {0.0, 0.3});
    EXPECT_FALSE(parts.nearest({0.0, 0.3}, 0.999 * away));
    const auto found = parts.nearest({0.0, 0.3}, 1.001 * away);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->u, nearest.u, 1e-12);
    EXPECT_FALSE(parts.nearest({100.0, 0.0}, 90.0));
    EXPECT_TRUE(parts.nearest({100.0, 0.0}, 99.0));
}

TEST(NearParts, of_a_point_that_never_moves) {
    const Curve curve =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{3, 4}, {3, 4}, {3, 4}}}).value();
    const auto found = NearParts(curve).nearest({0.0, 0.0});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->point, Point(3, 4));
    EXPECT_TRUE(NearParts(curve).nearest({3.0, 4.0}, 0.0));
}

TEST(NearParts, answer_also_where_numbers_overflow) {
    const double huge = 0.5 * std::numeric_limits<double>::max();
    const Curve curve = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{-huge, 0}, {huge, 0}}}).value();
    EXPECT_TRUE(NearParts(curve).nearest({huge, huge}));
}

TEST(NearParts, visit_every_point_that_is_near) {
    RandomCurves random(76);
    for (int i = 0; i < 200; ++i) {
        const Curve curve = random.curve();
        const double x = random.number(-10.0, 10.0);
        const Point place(x, random.number(-10.0, 10.0));
        std::set<std::size_t> visited;
        NearParts(curve).visit_near(place, 2.0, [&](std::size_t k) {
            EXPECT_TRUE(visited.empty() || *visited.rbegin() < k);
            visited.insert(k);
        });
        for (std::size_t k = 0; k < curve.control_points().size(); ++k) {
            if (distance(curve.control_points()[k], place) > 2.0) continue;
            EXPECT_TRUE(visited.contains(k));
        }
    }
}

// Of 6,250 boxes at n = 100,000. The turns of the spiral are 0.1 apart, then 0.01.
TEST(NearParts, look_at_few_boxes_however_many_points_and_turns_there_are) {
    for (const Point query : {Point(1.42, 0.01), Point(0.0, 0.2), Point(-1.2, 1.1), Point(3.0, 3.0)}) {
        EXPECT_LE(looks_at(spiral(1000, 10), query, Box::infinity), 150U);
        EXPECT_LE(looks_at(spiral(100'000, 10), query, Box::infinity), 400U);
        EXPECT_LE(looks_at(spiral(100'000, 100), query, Box::infinity), 400U);
        EXPECT_LE(looks_at(spiral(100'000, 100), query, 0.01), 400U);
    }
}

}  // namespace
}  // namespace batten::core
