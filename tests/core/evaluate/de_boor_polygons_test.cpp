#include "core/evaluate/de_boor_polygons.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/evaluate/blossom.h"
#include "tests/core/golden_cases.h"
#include "tests/core/random_curves.h"
#include "tests/core/reference.h"

namespace batten::core {

namespace {

const DeBoorCell& cell_at(const DeBoorTriangle& triangle, CellPlace place) {
    return triangle.levels[place.level][place.index];
}

std::vector<Point> points_at(const DeBoorTriangle& triangle, const std::vector<CellPlace>& places) {
    std::vector<Point> points;
    for (const CellPlace place : places) points.push_back(cell_at(triangle, place).point);
    return points;
}

/// Each cell against the blossom at the knots of its place among `knots`, which begin with that of index span - p.
void expect_blossoms(const Curve& curve, const DeBoorTriangle& triangle, const std::vector<CellPlace>& places,
                     const std::vector<double>& knots) {
    const auto p = static_cast<std::size_t>(curve.degree());
    for (std::size_t k = 0; k < places.size(); ++k) {
        const std::vector<double> arguments(knots.begin() + static_cast<std::ptrdiff_t>(k + 1),
                                            knots.begin() + static_cast<std::ptrdiff_t>(k + 1 + p));
        const HomogeneousPoint expected = blossom(curve, triangle.span, arguments);
        const DeBoorCell& cell = cell_at(triangle, places[k]);
        EXPECT_NEAR(cell.weight, expected.z, 1e-10 * expected.z);
        EXPECT_LE(reference::relative_distance(curve, cell.point, project(expected)), 1e-10);
    }
}

/// The knots from index span - p to span + p + 1 with u so many times more.
std::vector<double> refined_knots(const Curve& curve, const DeBoorTriangle& triangle, std::size_t times) {
    const auto p = static_cast<std::size_t>(curve.degree());
    std::vector<double> knots;
    for (std::size_t i = triangle.span - p; i <= triangle.span + p + 1; ++i) knots.push_back(curve.knots()[i]);
    knots.insert(std::upper_bound(knots.begin(), knots.end(), triangle.u), times, triangle.u);
    return knots;
}

std::size_t multiplicity_in(const std::vector<double>& knots, double u) {
    return static_cast<std::size_t>(std::count(knots.begin(), knots.end(), u));
}

Curve uniform_cubic() {
    return Curve::make(
               {.degree = 3, .knots = {0, 1, 2, 3, 4, 5, 6, 7, 8}, .points = {{0, 0}, {0, 6}, {6, 6}, {6, 0}, {3, 9}}})
        .value();
}

}  // namespace

TEST(DeBoorPolygons, of_insertion_are_those_of_the_golden_data) {
    std::size_t count = 0;
    for (const auto& item : golden::cases("knot_insertion.json")) {
        if (item["insert"].size() != 1) continue;
        const Curve curve = golden::curve_of(item);
        const DeBoorTriangle triangle = de_boor_triangle(curve, item["insert"][0]);
        if (insertion_count(triangle) == 0) continue;
        const auto p = static_cast<std::size_t>(curve.degree());
        const std::vector<Point> all = golden::points_of(item["result"]["points"]);
        const auto first = all.begin() + static_cast<std::ptrdiff_t>(triangle.span - p);
        const std::vector<Point> local(first, first + static_cast<std::ptrdiff_t>(p + 2));
        const std::vector<Point> found = points_at(triangle, inserted_polygon(triangle, 1));
        ASSERT_EQ(found.size(), local.size()) << item["name"];
        EXPECT_LE(golden::largest_difference(found, local), 1e-13 * golden::largest_coordinate(all)) << item["name"];
        ++count;
    }
    EXPECT_GE(count, 5U);
}

TEST(DeBoorPolygons, of_splitting_are_those_of_the_golden_data) {
    std::size_t count = 0;
    for (const auto& item : golden::cases("split.json")) {
        const Curve curve = golden::curve_of(item);
        const DeBoorTriangle triangle = de_boor_triangle(curve, item["u"]);
        const SplitPolygons polygons = split_polygons(curve, triangle);
        const std::vector<Point> left = golden::points_of(item["left"]["points"]);
        const std::vector<Point> right = golden::points_of(item["right"]["points"]);
        const std::vector<Point> before = points_at(triangle, polygons.before);
        const std::vector<Point> after = points_at(triangle, polygons.after);
        const double scale = golden::largest_coordinate(curve.control_points());
        const std::vector<Point> left_end(left.end() - static_cast<std::ptrdiff_t>(before.size()), left.end());
        const std::vector<Point> right_start(right.begin(), right.begin() + static_cast<std::ptrdiff_t>(after.size()));
        EXPECT_LE(golden::largest_difference(before, left_end), 1e-12 * scale) << item["name"];
        EXPECT_LE(golden::largest_difference(after, right_start), 1e-12 * scale) << item["name"];
        ++count;
    }
    EXPECT_GE(count, 5U);
}

TEST(DeBoorPolygons, are_the_control_points_over_the_refined_knots) {
    RandomCurves random(23);
    for (int k = 0; k < 300; ++k) {
        const Curve curve = random.curve();
        const auto p = static_cast<std::size_t>(curve.degree());
        // Every third time a knot.
        const std::size_t some = static_cast<std::size_t>(random.whole(static_cast<int>(p), static_cast<int>(p + 4)));
        const double u = k % 3 == 0 ? curve.knots().into_domain(curve.knots()[std::min(some, curve.knots().size() - 1)])
                                    : random.parameter(curve);
        const DeBoorTriangle triangle = de_boor_triangle(curve, u);
        const std::size_t times = insertion_count(triangle);
        const std::size_t multiplicity = multiplicity_in(refined_knots(curve, triangle, 0), triangle.u);
        EXPECT_EQ(times, p - std::min(p, multiplicity));
        for (std::size_t r = 0; r <= times; ++r) {
            const std::vector<CellPlace> polygon = inserted_polygon(triangle, r);
            ASSERT_EQ(polygon.size(), p + 1 + r);
            expect_blossoms(curve, triangle, polygon, refined_knots(curve, triangle, r));
        }
        const SplitPolygons parts = split_polygons(curve, triangle);
        EXPECT_EQ(parts.before.back(), parts.after.front());
        EXPECT_EQ(cell_at(triangle, parts.before.back()).point, triangle.point());
        std::vector<CellPlace> joined = parts.before;
        joined.insert(joined.end(), parts.after.begin() + 1, parts.after.end());
        EXPECT_EQ(joined, inserted_polygon(triangle, times));
    }
}

TEST(DeBoorPolygons, of_insertion_differ_by_the_points_of_a_level) {
    using Places = std::vector<CellPlace>;
    const DeBoorTriangle triangle = de_boor_triangle(uniform_cubic(), 3.5);
    EXPECT_EQ(insertion_step(triangle, 1).added, (Places{{1, 0}, {1, 1}, {1, 2}}));
    EXPECT_EQ(insertion_step(triangle, 1).removed, (Places{{0, 1}, {0, 2}}));
    EXPECT_EQ(insertion_step(triangle, 2).added, (Places{{2, 0}, {2, 1}}));
    EXPECT_EQ(insertion_step(triangle, 2).removed, (Places{{1, 1}}));
    EXPECT_EQ(insertion_step(triangle, 3).added, (Places{{3, 0}}));
    EXPECT_EQ(insertion_step(triangle, 3).removed, Places{});
    const DeBoorTriangle at_knot = de_boor_triangle(uniform_cubic(), 4.0);
    EXPECT_EQ(insertion_step(at_knot, 1).added, (Places{{1, 0}, {1, 1}}));
    EXPECT_EQ(insertion_step(at_knot, 1).removed, (Places{{0, 1}}));
    EXPECT_EQ(insertion_step(at_knot, 2).added, (Places{{2, 0}}));
}

TEST(DeBoorPolygons, at_a_knot_leave_out_what_is_there_already) {
    // u = 4 is simple, so that it can be inserted twice; the rows to its right are those above them.
    const DeBoorTriangle triangle = de_boor_triangle(uniform_cubic(), 4.0);
    EXPECT_EQ(insertion_count(triangle), 2U);
    EXPECT_EQ(origin_of(triangle, {3, 0}), (CellPlace{2, 0}));
    EXPECT_EQ(origin_of(triangle, {1, 2}), (CellPlace{0, 2}));
    EXPECT_EQ(inserted_polygon(triangle, 1), (std::vector<CellPlace>{{0, 0}, {1, 0}, {1, 1}, {0, 2}, {0, 3}}));
    EXPECT_EQ(split_polygons(uniform_cubic(), triangle).before, (std::vector<CellPlace>{{0, 0}, {1, 0}, {2, 0}}));
    EXPECT_EQ(split_polygons(uniform_cubic(), triangle).after,
              (std::vector<CellPlace>{{2, 0}, {1, 1}, {0, 2}, {0, 3}}));
}

TEST(DeBoorPolygons, at_the_end_of_an_unclamped_domain_begin_with_what_is_there) {
    const DeBoorTriangle triangle = de_boor_triangle(uniform_cubic(), 5.0);
    EXPECT_EQ(triangle.span, 4U);
    EXPECT_EQ(insertion_count(triangle), 2U);
    EXPECT_EQ(origin_of(triangle, {1, 0}), (CellPlace{0, 1}));
    EXPECT_EQ(inserted_polygon(triangle, 1), (std::vector<CellPlace>{{0, 0}, {0, 1}, {1, 1}, {1, 2}, {0, 3}}));
}

TEST(DeBoorPolygons, at_a_clamped_end_are_the_polygon_and_its_end_point) {
    const Curve curve =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {1, 2}, {3, 0}}}).value();
    const DeBoorTriangle at_start = de_boor_triangle(curve, 0.0);
    EXPECT_EQ(insertion_count(at_start), 0U);
    EXPECT_EQ(split_polygons(curve, at_start).before, (std::vector<CellPlace>{{0, 0}}));
    EXPECT_EQ(split_polygons(curve, at_start).after, (std::vector<CellPlace>{{0, 0}, {0, 1}, {0, 2}}));
    const DeBoorTriangle at_end = de_boor_triangle(curve, 1.0);
    EXPECT_EQ(split_polygons(curve, at_end).before, (std::vector<CellPlace>{{0, 0}, {0, 1}, {0, 2}}));
    EXPECT_EQ(split_polygons(curve, at_end).after, (std::vector<CellPlace>{{0, 2}}));
}

TEST(DeBoorPolygons, at_a_tear_have_nothing_before_it) {
    const Curve curve = Curve::make({.degree = 2,
                                     .knots = {0, 0, 0, 1, 1, 1, 2, 2, 2},
                                     .points = {{0, 0}, {1, 2}, {2, 0}, {3, 0}, {4, 2}, {5, 0}},
                                     .tears = Tears::allow})
                            .value();
    const DeBoorTriangle at_tear = de_boor_triangle(curve, 1.0);
    EXPECT_TRUE(is_at_tear(curve, at_tear));
    EXPECT_TRUE(split_polygons(curve, at_tear).before.empty());
    EXPECT_EQ(split_polygons(curve, at_tear).after, (std::vector<CellPlace>{{0, 0}, {0, 1}, {0, 2}}));
    for (const double u : {0.0, 0.5, 1.5, 2.0}) EXPECT_FALSE(is_at_tear(curve, de_boor_triangle(curve, u))) << u;
}

}  // namespace batten::core
