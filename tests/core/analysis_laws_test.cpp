#include <gtest/gtest.h>

#include <cmath>

#include "core/measure/arc_length.h"
#include "core/measure/area.h"
#include "core/measure/bounds.h"
#include "core/measure/curvature.h"
#include "core/measure/cusps.h"
#include "core/measure/intersect_curves.h"
#include "core/measure/intersect_line.h"
#include "core/refine/degree.h"
#include "core/refine/knot_insertion.h"
#include "tests/core/random_curves.h"

namespace batten::core {
namespace {

Curve changed(const Curve& curve, double factor, Vector offset) {
    CurveDefinition definition = curve.definition();
    for (double& knot : definition.knots) knot *= factor;
    for (Point& point : definition.points) point += offset;
    return Curve::make(std::move(definition)).value();
}

// Two knots more, a billionth of the domain apart.
Curve with_near_knots(const Curve& curve, double share) {
    const Interval domain = curve.domain();
    const double u = domain.lower + share * domain.length();
    return insert_knot(curve, u)
        .and_then([&](const Curve& c) { return insert_knot(c, u + 1e-9 * domain.length()); })
        .value();
}

struct Measures {
    std::size_t inflections = 0;
    std::size_t extrema = 0;
    std::size_t cusps = 0;
    std::size_t double_points = 0;
    std::size_t crossings = 0;
    double length = 0.0;
    Box box;
};

// `offset` is where the curve was moved, and the line with it.
Measures measures_of(const Curve& curve, Vector offset = Vector{}) {
    return {.inflections = inflections(curve).size(),
            .extrema = curvature_extrema(curve).size(),
            .cusps = cusps(curve).size(),
            .double_points = self_intersections(curve).contacts.size(),
            .crossings = intersect_line(curve, Point(-7, -1.3) + offset, Point(5, 2.1) + offset)->crossings,
            .length = arc_length(curve).value,
            .box = tight_box(curve)};
}

void expect_same(const Measures& found, const Measures& expected, double rounding, const std::string& name) {
    EXPECT_EQ(found.inflections, expected.inflections) << name;
    EXPECT_EQ(found.extrema, expected.extrema) << name;
    EXPECT_EQ(found.cusps, expected.cusps) << name;
    EXPECT_EQ(found.double_points, expected.double_points) << name;
    EXPECT_EQ(found.crossings, expected.crossings) << name;
    EXPECT_NEAR(found.length, expected.length, 100 * rounding) << name;
    EXPECT_NEAR(found.box.size().x, expected.box.size().x, 10 * rounding) << name;
    EXPECT_NEAR(found.box.size().y, expected.box.size().y, 10 * rounding) << name;
}

TEST(AnalysisLaws, what_keeps_the_shape_keeps_all_measures) {
    RandomCurves random(361);
    for (int i = 0; i < 25; ++i) {
        const Curve curve = random.curve();
        // Polygons bend nowhere; two points in a circle are a straight way there and back.
        if (curve.degree() == 1 || curve.control_points().size() < 3) continue;
        const Measures expected = measures_of(curve);
        const std::string name = std::to_string(i) + ", degree " + std::to_string(curve.degree());
        expect_same(measures_of(with_near_knots(curve, random.number(0.1, 0.9))), expected, 1e-13,
                    name + ", near knots");
        expect_same(measures_of(elevate_degree(curve, 1).value()), expected, 1e-13, name + ", elevated");
        expect_same(measures_of(changed(curve, 1e9, Vector{})), expected, 1e-13, name + ", long domain");
        expect_same(measures_of(changed(curve, 1e-9, Vector{})), expected, 1e-13, name + ", short domain");
        const Vector offset(1e6, -3e6);
        expect_same(measures_of(changed(curve, 1.0, offset), offset), expected, 1e-8, name + ", far away");
    }
}

TEST(AnalysisLaws, area_stays_as_well) {
    RandomCurves random(362);
    for (int i = 0; i < 40; ++i) {
        const Curve curve = random.periodic_curve();
        const double expected = enclosed_area(curve)->signed_area;
        EXPECT_NEAR(enclosed_area(with_near_knots(curve, 0.37))->signed_area, expected, 1e-11) << i;
        EXPECT_NEAR(enclosed_area(elevate_degree(curve, 2).value())->signed_area, expected, 1e-11) << i;
        EXPECT_NEAR(enclosed_area(changed(curve, 1e9, {1e6, 1e6}))->signed_area, expected, 1e-7) << i;
    }
}

TEST(AnalysisLaws, every_degree_and_extreme_weights_and_places_end) {
    for (const int degree : {1, 2, 3, 8, 15, 25})
        for (const double ratio : {1.0, 1e6, 1e-6}) {
            const auto count = static_cast<std::size_t>(degree) + 4;
            CurveDefinition definition{.degree = degree};
            for (std::size_t i = 0; i < count; ++i) {
                const auto t = static_cast<double>(i);
                definition.points.emplace_back(3 * std::cos(2 * t) + t, 3 * std::sin(2.3 * t));
                definition.weights.push_back(i % 2 == 0 ? 1.0 : ratio);
            }
            definition.knots.assign(static_cast<std::size_t>(degree) + 1, 0.0);
            for (const double knot : {0.25, 0.25 + 1e-9, 0.75}) definition.knots.push_back(knot);
            definition.knots.insert(definition.knots.end(), static_cast<std::size_t>(degree) + 1, 1.0);
            const Curve curve = Curve::make(definition).value();
            const Measures measures = measures_of(curve);
            EXPECT_TRUE(std::isfinite(measures.length));
            EXPECT_GT(measures.length, 1.0);
            EXPECT_LE(arc_length(curve).error, 1e-10 * measures.length) << degree << " " << ratio;
        }
}

TEST(AnalysisLaws, coordinates_beyond_all_measure_end) {
    for (const double size : {1e-300, 1e-160, 1e150, 1e300}) {
        const Curve curve = Curve::make({.degree = 3,
                                         .knots = {0, 0, 0, 0, 1, 1, 1, 1},
                                         .points = {{0, 0}, {size, 3 * size}, {2 * size, -3 * size}, {3 * size, 0}}})
                                .value();
        EXPECT_EQ(inflections(curve).size(), 1U) << size;
        EXPECT_TRUE(cusps(curve).empty()) << size;
        EXPECT_NEAR(tight_box(curve).upper.x / size, 3.0, 1e-12);
        EXPECT_LE(curvature_extrema(curve).size(), 2U);
        EXPECT_LE(self_intersections(curve).contacts.size(), 1U);
        EXPECT_GE(arc_length(curve).value, 0.0);
    }
}

}  // namespace
}  // namespace batten::core
