#include "core/measure/contacts_near.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/curve/knot_kinds.h"
#include "core/evaluate/evaluate.h"
#include "core/make/conics.h"
#include "core/make/shapes.h"

namespace batten::core {
namespace {

std::vector<NearContact> contacts(const std::vector<Curve>& curves, Point place, double reach) {
    std::vector<NearParts> parts;
    for (const Curve& curve : curves) parts.emplace_back(curve);
    std::vector<const NearParts*> pointers;
    for (const NearParts& part : parts) pointers.push_back(&part);
    return contacts_near(pointers, place, reach);
}

TEST(ContactsNear, of_circles_and_lines_are_exact) {
    const Curve left = circle({-1, 0}, std::sqrt(2.0)).value();
    const Curve right = circle({1, 0}, std::sqrt(2.0)).value();
    const auto above = contacts({left, right}, {0.1, 0.9}, 0.3);
    ASSERT_EQ(above.size(), 1U);
    EXPECT_LE(distance(above[0].point, {0, 1}), 1e-14);
    EXPECT_EQ(above[0].first, 0U);
    EXPECT_EQ(above[0].second, 1U);
    EXPECT_LE(distance(point_at(right, above[0].v), {0, 1}), 1e-14);
    EXPECT_EQ(contacts({left, right}, {0, 0}, 1.1).size(), 2U);
    EXPECT_TRUE(contacts({left, right}, {0.1, 0.6}, 0.3).empty());

    const auto lines = contacts({line({0, 0}, {3, 1}).value(), line({0, 1}, {3, 0}).value()}, {1.4, 0.6}, 0.2);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_LE(distance(lines[0].point, {1.5, 0.5}), 1e-15);
    EXPECT_TRUE(contacts({line({0, 0}, {3, 1}).value(), line({0, 0}, {3, 1}).value()}, {1.5, 0.5}, 0.2).empty());
}

TEST(ContactsNear, far_away_are_exact_within_the_size) {
    const auto found =
        contacts({circle({1e6 - 1, 1e6}, std::sqrt(2.0)).value(), circle({1e6 + 1, 1e6}, std::sqrt(2.0)).value()},
                 {1e6, 1e6 + 0.9}, 0.3);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_LE(distance(found[0].point, {1e6, 1e6 + 1}), 1e-12 * 1e6);
}

// With s = u - 1/2 this is x = 2s(1 - 7ab), y = 6ab, ab = 1/4 - s^2: the loop crosses where ab = 1/7.
TEST(ContactsNear, of_a_curve_with_itself) {
    const Curve loop =
        Curve::make({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .points = {{-1, 0}, {2, 2}, {-2, 2}, {1, 0}}})
            .value();
    const auto found = contacts({loop}, {0.05, 0.8}, 0.1);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_LE(distance(found[0].point, {0, 6.0 / 7.0}), 1e-14);
    EXPECT_NEAR(found[0].u, 0.5 - std::sqrt(3.0 / 28.0), 1e-14);
    EXPECT_NEAR(found[0].v, 0.5 + std::sqrt(3.0 / 28.0), 1e-14);
    EXPECT_TRUE(contacts({circle({0, 0}, 1.0).value()}, {1, 0}, 0.1).empty());  // where its ends meet
}

TEST(ContactsNear, of_a_polyline_that_crosses_itself_and_a_periodic_one) {
    const std::vector<Point> bow{{0, 0}, {2, 2}, {2, 0}, {0, 2}};
    for (const bool closed : {false, true}) {
        const auto found = contacts({polyline(bow, closed).value()}, {1.1, 1.0}, 0.2);
        ASSERT_EQ(found.size(), 1U);
        EXPECT_LE(distance(found[0].point, {1, 1}), 1e-15);
        EXPECT_NEAR(found[0].u, 0.5, 1e-14);
        EXPECT_NEAR(found[0].v, 2.5, 1e-14);
        for (const Point corner : bow) EXPECT_TRUE(contacts({polyline(bow, closed).value()}, corner, 0.2).empty());
    }
}

TEST(NearParts, are_told_only_where_they_are_few) {
    std::vector<Point> points;
    for (int i = 0; i < 100'000; ++i) points.emplace_back(1e-4 * i, std::sin(1e-3 * i));
    const NearParts parts(
        Curve::make(make_knots(KnotKind::clamped_uniform, 3, points.size()).value(), points, {}).value());
    EXPECT_TRUE(parts.is_crowded({5, 0}, 20.0, 1000));
    EXPECT_FALSE(parts.is_crowded({5, std::sin(50.0)}, 1e-3, 1000));
    EXPECT_FALSE(parts.is_crowded({5, 9}, 1e-3, 1));
    EXPECT_FALSE(parts.parts_near({5, 0}, 20.0, 100));
    const auto near = parts.parts_near({5, std::sin(50.0)}, 1e-4, 100);
    ASSERT_TRUE(near);
    ASSERT_EQ(near->size(), 1U);
    const Interval domain = near->front().domain();
    const double middle = 0.5 * (domain.lower + domain.upper);
    EXPECT_EQ(point_at(near->front(), middle), point_at(parts.curve(), middle));
    EXPECT_TRUE(parts.parts_near({5, 9}, 1e-3, 10)->empty());
}

}  // namespace
}  // namespace batten::core
