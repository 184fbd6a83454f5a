#include "core/evaluate/blossom_labels.h"

#include <gtest/gtest.h>

#include "core/evaluate/blossom.h"
#include "core/evaluate/de_boor.h"
#include "core/evaluate/evaluate.h"
#include "tests/core/random_curves.h"

namespace batten::core {

TEST(BlossomLabels, name_the_control_points_of_a_cubic) {
    const auto knots = KnotVector::make(3, {0, 0, 0, 0, 0.25, 0.5, 1, 1, 1, 1}).value();
    EXPECT_EQ(symbolic_text(control_point_label(knots, 2)), "u3 u4 u5");
    EXPECT_EQ(value_text(control_point_label(knots, 2)), "0 0.25 0.5");
    EXPECT_EQ(value_text(control_point_label(knots, 0)), "0 0 0");
    EXPECT_EQ(value_text(control_point_label(knots, 5)), "1 1 1");
    EXPECT_EQ(symbolic_text(de_boor_label(knots, 4, 1)), "u5 u6 t");
    EXPECT_EQ(value_text(de_boor_label(knots, 5, 3)), "t t t");
    EXPECT_EQ(arguments_of(de_boor_label(knots, 4, 2), 0.4), (std::vector<double>{0.5, 0.4, 0.4}));
}

TEST(BlossomLabels, evaluate_to_the_points_that_they_name) {
    RandomCurves random(311);
    for (int k = 0; k < 200; ++k) {
        const Curve curve = random.curve();
        const DeBoorTriangle triangle = de_boor_triangle(curve, random.parameter(curve));
        double scale = 0.0;
        for (const Point& point : curve.control_points()) scale = std::max(scale, distance(point, {}));
        for (std::size_t r = 0; r < triangle.levels.size(); ++r)
            for (const DeBoorCell& cell : triangle.levels[r]) {
                const BlossomLabel label = de_boor_label(curve.knots(), cell.index, r);
                const auto arguments = arguments_of(label, triangle.u);
                ASSERT_EQ(arguments.size(), static_cast<std::size_t>(curve.degree()));
                const Point point = project(blossom(curve, triangle.span, arguments));
                EXPECT_LE(distance(point, cell.point), 1e-12 * scale) << r << ' ' << cell.index;
            }
    }
}

TEST(GrevillePoints, of_a_line_in_disguise_are_on_the_curve) {
    // x(u) = u exactly when the control points have the Greville abscissae as x.
    const auto curve =
        Curve::make({.degree = 3,
                     .knots = {0, 0, 0, 0, 1, 3, 4, 4, 4, 4},
                     .points = {{0, 5}, {1.0 / 3, 1}, {4.0 / 3, 0}, {8.0 / 3, 7}, {11.0 / 3, 2}, {4, 3}}})
            .value();
    const auto points = greville_points(curve);
    ASSERT_EQ(points.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(points[i].control_point, curve.control_points()[i]);
        EXPECT_NEAR(points[i].abscissa, curve.control_points()[i].x, 1e-15);
        EXPECT_NEAR(points[i].curve_point.x, points[i].abscissa, 1e-15);
        EXPECT_EQ(points[i].curve_point, point_at(curve, points[i].abscissa));
    }
}

}  // namespace batten::core
