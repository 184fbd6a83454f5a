#include "core/shape/combine.h"

#include <gtest/gtest.h>

#include "core/edit/transform.h"
#include "core/refine/reverse.h"
#include "tests/core/shape/shapes_to_combine.h"

namespace batten::core {
namespace {

using std::numbers::pi;

std::vector<Curve> combined(const Curve& a, const Curve& b, ShapeOperation operation) {
    return combine({{a}}, {{b}}, operation).value();
}

double combined_area(const Curve& a, const Curve& b, ShapeOperation operation) {
    return area_of(combined(a, b, operation));
}

struct Areas {
    double both, either, first_only, one;
};

Areas areas_of(const Shape& a, const Shape& b) {
    const auto area = [&](ShapeOperation operation) { return area_of(combine(a, b, operation).value()); };
    return {area(ShapeOperation::intersect), area(ShapeOperation::unite), area(ShapeOperation::subtract),
            area(ShapeOperation::exclude)};
}

void expect_identities(const Shape& a, const Shape& b) {
    const Areas areas = areas_of(a, b);
    const double of_a = area_inside(a);
    const double of_b = area_inside(b);
    const double near = 1e-9 * (of_a + of_b);
    EXPECT_NEAR(of_a + of_b, areas.either + areas.both, near);
    EXPECT_NEAR(areas.first_only, of_a - areas.both, near);
    EXPECT_NEAR(areas.one, areas.either - areas.both, near);
}

TEST(Combine, squares_that_cross) {
    const Curve a = rectangle({0, 0}, {2, 2});
    const Curve b = rectangle({1, 1}, {4, 3});
    const auto both = combined(a, b, ShapeOperation::intersect);
    ASSERT_EQ(both.size(), 1u);
    EXPECT_NEAR(area_of(both), 1.0, 1e-15);
    EXPECT_EQ(both[0].control_points().size(), 5u);
    EXPECT_NEAR(combined_area(a, b, ShapeOperation::unite), 9.0, 1e-14);
    EXPECT_NEAR(combined_area(a, b, ShapeOperation::subtract), 3.0, 1e-14);
    EXPECT_NEAR(combined_area(b, a, ShapeOperation::subtract), 5.0, 1e-14);
    EXPECT_NEAR(combined_area(a, b, ShapeOperation::exclude), 8.0, 1e-14);
    EXPECT_EQ(combined(a, b, ShapeOperation::exclude).size(), 2u);
}

// 2 r^2 acos(d / 2r) - d/2 sqrt(4 r^2 - d^2)
TEST(Combine, lens_of_two_circles) {
    for (const double d : {0.5, 1.0, 1.9, 1.9999}) {
        const Curve a = disc({-0.5 * d, 0}, 1);
        const Curve b = disc({0.5 * d, 0}, 1);
        const double lens = 2 * std::acos(d / 2) - d / 2 * std::sqrt(4 - d * d);
        EXPECT_NEAR(combined_area(a, b, ShapeOperation::intersect), lens, 1e-12) << d;
        EXPECT_NEAR(combined_area(a, b, ShapeOperation::unite), 2 * pi - lens, 1e-12) << d;
        EXPECT_NEAR(combined_area(a, b, ShapeOperation::subtract), pi - lens, 1e-12) << d;
        EXPECT_NEAR(combined_area(a, b, ShapeOperation::exclude), 2 * (pi - lens), 1e-12) << d;
    }
}

// Two circles in a lens have their own pieces: quarters of a circle in degree 2.
TEST(Combine, keeps_pieces_of_the_curves) {
    const auto lens = combined(disc({-0.5, 0}, 1), disc({0.5, 0}, 1), ShapeOperation::intersect);
    ASSERT_EQ(lens.size(), 1u);
    EXPECT_EQ(lens[0].degree(), 2);
    for (int k = 0; k <= 500; ++k) {
        const Point point = point_at(lens[0], lens[0].domain().lower + lens[0].domain().length() * k / 500);
        EXPECT_NEAR(std::min(distance(point, {-0.5, 0}), distance(point, {0.5, 0})) +
                        std::abs(std::max(distance(point, {-0.5, 0}), distance(point, {0.5, 0})) - 1.0),
                    std::min(distance(point, {-0.5, 0}), distance(point, {0.5, 0})), 1e-14);
    }
    const double area = enclosed_area(lens[0]).value().signed_area;
    EXPECT_GT(area, 0.0);
    EXPECT_EQ(point_at(lens[0], lens[0].domain().lower), point_at(lens[0], lens[0].domain().upper));
}

TEST(Combine, one_inside_the_other) {
    const Curve outer = rounded({0, 0}, std::vector<double>(8, 3.0));
    const Curve inner = disc({0.5, 0.25}, 1);
    const double area = enclosed_area(outer).value().signed_area;
    EXPECT_EQ(combined(outer, inner, ShapeOperation::unite), std::vector{outer});
    EXPECT_EQ(combined(outer, inner, ShapeOperation::intersect), std::vector{inner});
    EXPECT_TRUE(combined(inner, outer, ShapeOperation::subtract).empty());
    const auto ring = combined(outer, inner, ShapeOperation::subtract);
    EXPECT_EQ(ring, (std::vector{outer, reverse(inner).value()}));
    EXPECT_NEAR(area_of(ring), area - pi, 1e-12);
    // Run through clockwise, the curves enclose the same.
    const auto turned = combined(reverse(outer).value(), inner, ShapeOperation::subtract);
    EXPECT_NEAR(area_of(turned), area - pi, 1e-12);
}

TEST(Combine, disjoint) {
    const Curve a = disc({0, 0}, 1);
    const Curve b = disc({3, 0}, 1);
    EXPECT_EQ(combined(a, b, ShapeOperation::unite), (std::vector{a, b}));
    EXPECT_TRUE(combined(a, b, ShapeOperation::intersect).empty());
    EXPECT_EQ(combined(a, b, ShapeOperation::subtract), std::vector{a});
    EXPECT_EQ(combined(a, b, ShapeOperation::exclude), (std::vector{a, b}));
}

TEST(Combine, identical) {
    for (const Curve& a : {disc({0, 0}, 1), rectangle({0, 0}, {2, 1}), rounded({0, 0}, {1, 2, 1, 2, 1, 2})})
        for (const Curve& b : {a, reverse(a).value()}) {
            EXPECT_EQ(combined(a, b, ShapeOperation::unite), std::vector{a});
            EXPECT_EQ(combined(a, b, ShapeOperation::intersect), std::vector{a});
            EXPECT_TRUE(combined(a, b, ShapeOperation::subtract).empty());
            EXPECT_TRUE(combined(a, b, ShapeOperation::exclude).empty());
        }
}

TEST(Combine, a_curve_and_its_reverse_enclose_nothing_together) {
    for (const Curve& a : {disc({0, 0}, 1), rectangle({0, 0}, {2, 1})}) {
        EXPECT_TRUE(combine({{a, reverse(a).value()}}, {}, ShapeOperation::unite)->empty());
        EXPECT_EQ(combine({{a, reverse(a).value()}}, {{a}}, ShapeOperation::unite).value(), std::vector{a});
        EXPECT_TRUE(combine({{a, a}, InsideRule::even_odd}, {}, ShapeOperation::unite)->empty());
    }
}

TEST(Combine, rectangles_that_share_a_side) {
    const Curve a = rectangle({0, 0}, {2, 1});
    for (const auto& [lower, upper] :
         {std::pair(Point(2, 0), Point(3, 1)), std::pair(Point(2, 0.25), Point(3, 0.75)),
          std::pair(Point(2, 0.5), Point(3, 1.5)), std::pair(Point(0.5, 1), Point(1, 2))}) {
        const Curve b = rectangle(lower, upper);
        const double of_b = (upper.x - lower.x) * (upper.y - lower.y);
        const auto whole = combined(a, b, ShapeOperation::unite);
        EXPECT_EQ(whole.size(), 1u);
        EXPECT_NEAR(area_of(whole), 2 + of_b, 1e-14);
        EXPECT_TRUE(combined(a, b, ShapeOperation::intersect).empty());
        EXPECT_NEAR(combined_area(a, b, ShapeOperation::subtract), 2, 1e-14);
    }
    // Along an edge.
    const Curve c = rectangle({1, 0}, {3, 1});
    EXPECT_NEAR(combined_area(a, c, ShapeOperation::unite), 3, 1e-14);
    EXPECT_NEAR(combined_area(a, c, ShapeOperation::intersect), 1, 1e-14);
    EXPECT_NEAR(combined_area(a, c, ShapeOperation::subtract), 1, 1e-14);
}

TEST(Combine, circles_that_touch) {
    const Curve a = disc({0, 0}, 1);
    for (const double angle : {0.0, 0.3, 1.0, 2.5}) {
        const Vector to{std::cos(angle), std::sin(angle)};
        const Curve outside = disc(Point(0, 0) + 1.5 * to, 0.5);
        EXPECT_NEAR(combined_area(a, outside, ShapeOperation::unite), 1.25 * pi, 1e-9) << angle;
        EXPECT_NEAR(combined_area(a, outside, ShapeOperation::intersect), 0, 1e-9) << angle;
        const Curve inside = disc(Point(0, 0) + 0.5 * to, 0.5);
        EXPECT_NEAR(combined_area(a, inside, ShapeOperation::unite), pi, 1e-9) << angle;
        EXPECT_NEAR(combined_area(a, inside, ShapeOperation::subtract), 0.75 * pi, 1e-9) << angle;
    }
}

TEST(Combine, crossing_at_corners_and_ends) {
    const Curve a = rectangle({0, 0}, {2, 2});
    // The corner of one lies in the middle of the other, or on its corner.
    EXPECT_NEAR(combined_area(a, closed_polygon({{0, 0}, {2, 2}, {0, 3}}), ShapeOperation::intersect), 2, 1e-14);
    EXPECT_NEAR(combined_area(a, closed_polygon({{1, 1}, {3, 0}, {3, 2}}), ShapeOperation::unite), 5.5, 1e-14);
    const auto touching = combined(a, rectangle({2, 2}, {3, 3}), ShapeOperation::unite);
    EXPECT_EQ(touching.size(), 2u);
    EXPECT_NEAR(area_of(touching), 5, 1e-14);
    // The ends of the circle lie on a side.
    EXPECT_NEAR(combined_area(rectangle({1, -2}, {3, 2}), disc({0, 0}, 1), ShapeOperation::unite), 8 + pi, 1e-9);
    EXPECT_NEAR(combined_area(rectangle({0, 0}, {3, 2}), disc({0, 0}, 1), ShapeOperation::intersect), pi / 4, 1e-13);
}

TEST(Combine, rules_of_curves_that_cross_themselves) {
    // A pentagram of circumradius 1: the inner pentagon is run round twice.
    std::vector<Point> tips;
    for (int k = 0; k < 5; ++k) tips.push_back({std::cos(0.8 * pi * k), std::sin(0.8 * pi * k)});
    const Curve star = closed_polygon(tips);
    const double inner = std::cos(0.4 * pi) / std::cos(0.2 * pi);
    const double pentagon = 2.5 * inner * inner * std::sin(0.4 * pi);
    const double whole = 5 * inner * std::sin(0.2 * pi);
    EXPECT_NEAR(area_inside({{star}, InsideRule::non_zero}), whole, 1e-14);
    EXPECT_NEAR(area_inside({{star}, InsideRule::even_odd}), whole - pentagon, 1e-14);
    EXPECT_EQ(combine({{star}, InsideRule::even_odd}, {}, ShapeOperation::unite)->size(), 5u);
}

TEST(Combine, roses_with_many_crossings) {
    for (const int petals : {7, 100}) {
        std::vector<double> radii;
        for (int k = 0; k < 4 * petals; ++k) radii.push_back(k % 2 == 0 ? 1.0 + 0.01 * (k % 3) : 0.6);
        const Curve rose = rounded({0.1, 0.2}, radii, petals % 2 == 0 ? 3 : 2);
        expect_identities({{rose}, InsideRule::even_odd}, {{disc({0, 0}, 0.8)}});
        expect_identities({{rose}, InsideRule::non_zero}, {{disc({0.5, 0}, 0.8)}});
    }
}

TEST(Combine, outlines_of_a_thousand_points) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> radius(0.9, 1.1);
    std::vector<double> radii(1000);
    for (double& r : radii) r = radius(random);
    const Curve smooth = rounded({0, 0}, radii);
    for (double& r : radii) r = radius(random);
    const Curve other = rounded({0.01, 0.02}, radii);
    expect_identities({{smooth}}, {{other}});
    std::vector<Point> corners;
    for (std::size_t k = 0; k < radii.size(); ++k) {
        const double angle = 0.002 * pi * static_cast<double>(k);
        corners.push_back({radii[k] * std::cos(angle), radii[k] * std::sin(angle)});
    }
    const Curve polygon = closed_polygon(corners);
    EXPECT_NEAR(area_inside({{polygon}}) + area_inside({{smooth}}),
                combined_area(polygon, smooth, ShapeOperation::unite) +
                    combined_area(polygon, smooth, ShapeOperation::intersect),
                1e-8);
}

TEST(Combine, far_away_small_and_large) {
    for (const double size : {1e-6, 1.0, 1e6})
        for (const double away : {0.0, 1e6}) {
            const Curve a = disc({away, away}, size);
            const Curve b = disc({away + size, away}, size);
            const double lens = (2 * pi / 3 - std::sqrt(3.0) / 2) * size * size;
            const double near = (1e-9 + 1e-15 * away / size * 4) * size * size;
            EXPECT_NEAR(combined_area(a, b, ShapeOperation::intersect), lens, near) << size << ' ' << away;
            EXPECT_NEAR(combined_area(a, b, ShapeOperation::subtract), pi * size * size - lens, near);
        }
}

TEST(Combine, refuses_open_curves) {
    const Curve open = line({0, 0}, {1, 0}).value();
    const auto result = combine({{disc({0, 0}, 1)}}, {{open}}, ShapeOperation::unite);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, CurveErrorCode::curve_not_closed);
    EXPECT_EQ(result.error().index, 1u);
    EXPECT_TRUE(combine({}, {}, ShapeOperation::unite)->empty());
}

// Circles and squares on a lattice touch, coincide and share corners and stretches of sides.
TEST(Combine, agrees_with_winding_numbers_of_shapes_on_a_lattice) {
    std::mt19937 random(7);
    const auto whole = [&](int lower, int upper) { return std::uniform_int_distribution<int>(lower, upper)(random); };
    const auto some = [&] {
        Shape shape{{}, whole(0, 1) == 0 ? InsideRule::even_odd : InsideRule::non_zero};
        for (int k = whole(1, 3); k > 0; --k) {
            const Point center(whole(0, 3), whole(0, 3));
            const double reach = 0.5 * whole(1, 3);
            const Curve curve = whole(0, 1) == 0
                                    ? disc(center, reach)
                                    : rectangle(center - Vector(reach, reach), center + Vector(reach, reach));
            shape.curves.push_back(whole(0, 3) == 0 ? reverse(curve).value() : curve);
        }
        return shape;
    };
    for (int trial = 0; trial < 40; ++trial) {
        const Shape a = some();
        const Shape b = some();
        expect_identities(a, b);
        const auto found = combine(a, b, ShapeOperation::subtract).value();
        // Never on the lattice itself.
        for (double x = -1.37; x < 5.0; x += 0.713)
            for (double y = -1.41; y < 5.0; y += 0.737) {
                const bool in_a = is_inside(winding_number(a.curves, {x, y}).value(), a.rule);
                const bool in_b = is_inside(winding_number(b.curves, {x, y}).value(), b.rule);
                EXPECT_EQ(winding_number(found, {x, y}), in_a && !in_b ? 1 : 0) << trial;
            }
    }
}

// Against winding numbers of fine polygons at random places.
TEST(Combine, agrees_with_samples_of_random_shapes) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int trial = 0; trial < 20; ++trial) {
        const auto some = [&] {
            Shape shape{{}, unit(random) < 0.5 ? InsideRule::even_odd : InsideRule::non_zero};
            for (int k = unit(random) < 0.5 ? 1 : 2; k > 0; --k) {
                std::vector<double> radii(5 + static_cast<std::size_t>(6 * unit(random)));
                for (double& r : radii) r = 0.2 + unit(random);
                shape.curves.push_back(rounded({unit(random), unit(random)}, radii, unit(random) < 0.6 ? 1 : 2));
            }
            return shape;
        };
        const Shape a = some();
        const Shape b = some();
        expect_identities(a, b);
        const auto operation = static_cast<ShapeOperation>(trial % 4);
        const auto result = combine(a, b, operation).value();
        int wrong = 0;
        for (int k = 0; k < 40; ++k) {
            const Point place{-1 + 3 * unit(random), -1 + 3 * unit(random)};
            const bool in_a = is_inside(winding_of_samples(a.curves, place), a.rule);
            const bool in_b = is_inside(winding_of_samples(b.curves, place), b.rule);
            const bool expected = operation == ShapeOperation::unite       ? in_a || in_b
                                  : operation == ShapeOperation::intersect ? in_a && in_b
                                  : operation == ShapeOperation::subtract  ? in_a && !in_b
                                                                           : in_a != in_b;
            const auto found = winding_number(result, place);
            ASSERT_TRUE(found);
            EXPECT_TRUE(*found == 0 || *found == 1);
            wrong += (*found == 1) != expected ? 1 : 0;
        }
        // The polygons differ from the curves by 1e-5 of their size.
        EXPECT_EQ(wrong, 0) << trial;
    }
}

}  // namespace
}  // namespace batten::core
