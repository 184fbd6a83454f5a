#include "core/refine/corner_cutting.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/refine/knot_insertion.h"
#include "core/refine/knot_removal.h"
#include "tests/core/golden.h"
#include "tests/core/golden_cases.h"
#include "tests/core/lecture_cubic.h"
#include "tests/core/random_curves.h"
#include "tests/core/reference.h"

namespace batten::core {
namespace {

// Knot insertion as the lecture has it: u = 1/2 gives alpha = 5/6, 1/2, 1/6.
template <class T>
CurveErrorCode code_of(const Result<T>& cutting) {
    EXPECT_FALSE(cutting);
    return cutting ? CurveErrorCode::not_computable : cutting.error().code;
}

void expect_near(const Curve& measure, Point a, Point b, double tolerance = 4e-14) {
    EXPECT_LE(reference::relative_distance(measure, a, b), tolerance)
        << a.x << ", " << a.y << "; " << b.x << ", " << b.y;
}

// Every cut is on its leg at its share, and is the control point that the insertion gives.
void expect_cutting(const Curve& curve, const Curve& refined, const CornerCutting& cutting, double tolerance = 4e-14) {
    const auto cuts = static_cast<std::size_t>(curve.degree() - cutting.multiplicity);
    ASSERT_EQ(cutting.cuts.size(), cuts);
    ASSERT_EQ(cutting.corners.size(), cuts + 1);
    ASSERT_EQ(cutting.knots.size(), cuts + static_cast<std::size_t>(curve.degree()) + 2);
    for (std::size_t j = 0; j < cuts; ++j) {
        EXPECT_EQ(cutting.cuts[j].knots.lower, cutting.knots[j + 1]);
        EXPECT_EQ(cutting.cuts[j].knots.upper, cutting.knots[j + 1 + static_cast<std::size_t>(curve.degree())]);
        const LegCut& cut = cutting.cuts[j];
        const OldCorner& from = cutting.corners[j];
        const OldCorner& to = cutting.corners[j + 1];
        EXPECT_EQ(to.index, (from.index + 1) % curve.control_points().size());
        EXPECT_EQ(to.index, cut.i % curve.control_points().size());
        EXPECT_NEAR(cut.alpha, (cutting.u - cut.knots.lower) / (cut.knots.upper - cut.knots.lower), 1e-15);
        EXPECT_GT(cut.alpha, 0.0);
        EXPECT_LT(cut.alpha, 1.0);
        const double weight = (1.0 - cut.alpha) * from.weight + cut.alpha * to.weight;
        EXPECT_NEAR(cut.weight, weight, tolerance * weight);
        EXPECT_NEAR(cut.leg_share, cut.alpha * to.weight / weight, tolerance);
        expect_near(curve, cut.point, from.point + cut.leg_share * (to.point - from.point), tolerance);
        expect_near(curve, cut.point, refined.control_points()[cut.new_index], tolerance);
        EXPECT_NEAR(refined.weights()[cut.new_index], cut.weight, tolerance * cut.weight);
    }
}

TEST(CornerCutting, of_the_lecture) {
    const CornerCutting cutting = corner_cutting(lecture_cubic(), 0.5).value();
    EXPECT_EQ(cutting.multiplicity, 0);
    ASSERT_EQ(cutting.cuts.size(), 3u);
    const std::vector<double> alphas{5.0 / 6.0, 0.5, 1.0 / 6.0};
    const std::vector<Point> points{{6, 1}, {9, 0}, {12, 1}};
    const std::vector<Interval> knots{{0, 0.6}, {0.2, 0.8}, {0.4, 1}};
    for (std::size_t j = 0; j < 3; ++j) {
        EXPECT_EQ(cutting.cuts[j].i, j + 3);
        EXPECT_EQ(cutting.cuts[j].new_index, j + 3);
        EXPECT_NEAR(cutting.cuts[j].alpha, alphas[j], 1e-15);
        EXPECT_NEAR(cutting.cuts[j].leg_share, alphas[j], 1e-15);
        EXPECT_NEAR(cutting.cuts[j].point.x, points[j].x, 1e-14);
        EXPECT_NEAR(cutting.cuts[j].point.y, points[j].y, 1e-14);
        EXPECT_EQ(cutting.cuts[j].knots, knots[j]);
    }
    EXPECT_EQ(cutting.knots, (std::vector<double>{0, 0, 0.2, 0.4, 0.6, 0.8, 1, 1}));
    const std::vector<Point> corners{{6, 6}, {6, 0}, {12, 0}, {12, 6}};
    ASSERT_EQ(cutting.corners.size(), 4u);
    for (std::size_t j = 0; j < 4; ++j) {
        EXPECT_EQ(cutting.corners[j].index, j + 2);
        EXPECT_EQ(cutting.corners[j].point, corners[j]);
    }
}

TEST(CornerCutting, gives_the_points_of_the_reference_results) {
    for (const nlohmann::json& item : golden::cases("knot_insertion.json")) {
        const auto inserted = item.at("insert").get<std::vector<double>>();
        if (inserted.size() != 1) continue;
        const Curve curve = golden::curve_of(item);
        const Curve expected = golden::curve_of(item.at("result"));
        expect_cutting(curve, expected, corner_cutting(curve, inserted[0]).value(), 2e-13);
    }
}

TEST(CornerCutting, is_what_insertion_does_to_every_curve) {
    RandomCurves random(3);
    int wound = 0;
    int periodic = 0;
    for (int k = 0; k < 3000; ++k) {
        const Curve curve = random.curve();
        const double u = random.parameter(curve);
        const int m = curve.knots().multiplicity(u);
        if (m >= curve.degree()) {
            EXPECT_EQ(code_of(corner_cutting(curve, u)), CurveErrorCode::multiplicity_full);
            continue;
        }
        if (curve.is_periodic() && curve.degree() - m > static_cast<int>(curve.control_points().size())) {
            EXPECT_EQ(code_of(corner_cutting(curve, u)), CurveErrorCode::too_few_points);
            ++wound;
            continue;
        }
        periodic += curve.is_periodic() ? 1 : 0;
        // The upper end of a period is its seam, which is seen from the right.
        const bool is_seam = curve.is_periodic() && u == curve.domain().upper;
        const Curve refined = insert_knot(curve, is_seam ? curve.domain().lower : u).value();
        const CornerCutting cutting = corner_cutting(curve, u).value();
        EXPECT_EQ(cutting.multiplicity, m);
        expect_cutting(curve, refined, cutting);
        if (testing::Test::HasFailure()) FAIL() << k;
    }
    EXPECT_GT(wound, 10);
    EXPECT_GT(periodic, 300);
}

TEST(CornerCutting, is_found_again_after_the_insertion) {
    RandomCurves random(4);
    int found = 0;
    for (int k = 0; k < 3000; ++k) {
        const Curve curve = random.curve();
        const double u = random.parameter(curve);
        const auto forward = corner_cutting(curve, u);
        const Interval domain = curve.domain();
        if (!forward || (!curve.is_periodic() && (u == domain.lower || u == domain.upper))) continue;
        const Curve refined = insert_knot(curve, forward->u).value();
        const auto undone = corner_cutting_undone(refined, u);
        ASSERT_TRUE(undone) << k << ": " << describe(undone.error());
        expect_cutting(curve, refined, undone->cutting, 1e-10);
        for (std::size_t j = 0; j < forward->corners.size(); ++j) {
            EXPECT_EQ(undone->cutting.corners[j].index, forward->corners[j].index);
            expect_near(curve, undone->cutting.corners[j].point, forward->corners[j].point, 1e-10);
        }
        for (std::size_t j = 0; j < forward->cuts.size(); ++j) {
            EXPECT_EQ(undone->cutting.cuts[j].i, forward->cuts[j].i);
            EXPECT_EQ(undone->cutting.cuts[j].new_index, forward->cuts[j].new_index);
        }
        if (testing::Test::HasFailure()) FAIL() << k;
        ++found;
    }
    EXPECT_GT(found, 1000);
}

TEST(CornerCutting, undone_follows_a_dragged_corner) {
    // The last corner is an old point; with it the leg moves on which Q_5 lies.
    CurveDefinition refined = insert_knot(lecture_cubic(), 0.5).value().definition();
    const Vector moved{1.5, -0.5};
    refined.points[6] += moved;
    refined.points[5] += (1.0 / 6.0) * moved;
    const UndoneCutting undone = corner_cutting_undone(Curve::make(refined).value(), 0.5).value();
    EXPECT_LT(undone.deviation, 1e-13);
    EXPECT_NEAR(undone.cutting.corners[3].point.x, 13.5, 1e-13);
    EXPECT_NEAR(undone.cutting.corners[2].point.x, 12.0, 1e-13);
    EXPECT_NEAR(undone.cutting.corners[2].point.y, 0.0, 1e-13);
}

TEST(CornerCutting, undone_tells_how_far_a_new_point_was_moved) {
    CurveDefinition refined = insert_knot(lecture_cubic(), 0.5).value().definition();
    refined.points[4].y += 0.5;
    const Curve curve = Curve::make(refined).value();
    const UndoneCutting undone = corner_cutting_undone(curve, 0.5).value();
    EXPECT_GT(undone.deviation, 0.05);
    EXPECT_LT(undone.deviation, 0.5);
    // As remove_knot() has it: the older polygon is that of the curve without the knot.
    const Curve older = remove_knot(curve, 0.5, 1, 1.0).value().curve;
    for (const OldCorner& corner : undone.cutting.corners)
        expect_near(older, corner.point, older.control_points()[corner.index]);
}

TEST(CornerCutting, undone_refuses_what_is_no_knot_inside) {
    EXPECT_EQ(code_of(corner_cutting_undone(lecture_cubic(), 0.5)), CurveErrorCode::knot_not_found);
    EXPECT_EQ(code_of(corner_cutting_undone(lecture_cubic(), 0.0)), CurveErrorCode::knot_not_found);
    EXPECT_EQ(code_of(corner_cutting_undone(lecture_cubic(), 1.5)), CurveErrorCode::parameter_outside_domain);
    const Curve torn = insert_knot(lecture_cubic(), 0.4, 3, Tears::allow).value();
    EXPECT_EQ(code_of(corner_cutting_undone(torn, 0.4)), CurveErrorCode::multiplicity_full);
}

TEST(CornerCutting, refuses_bad_parameters) {
    EXPECT_EQ(code_of(corner_cutting(lecture_cubic(), std::nan(""))), CurveErrorCode::parameter_not_finite);
    EXPECT_EQ(code_of(corner_cutting(lecture_cubic(), -0.01)), CurveErrorCode::parameter_outside_domain);
    EXPECT_EQ(code_of(corner_cutting(lecture_cubic(), 1.0)), CurveErrorCode::multiplicity_full);
}

TEST(CornerCutting, of_weights_cuts_the_leg_elsewhere_than_alpha_says) {
    // A quarter of a circle: at 1/2 both alphas are 1/2; on the first leg lies (P_0 + sqrt(1/2) P_1) / (1 + sqrt(1/2)).
    const double w = std::sqrt(0.5);
    const Curve arc =
        Curve::make(
            {.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{1, 0}, {1, 1}, {0, 1}}, .weights = {1, w, 1}})
            .value();
    const CornerCutting cutting = corner_cutting(arc, 0.5).value();
    ASSERT_EQ(cutting.cuts.size(), 2u);
    EXPECT_EQ(cutting.cuts[0].alpha, 0.5);
    EXPECT_NEAR(cutting.cuts[0].leg_share, w / (1 + w), 1e-15);
    EXPECT_NEAR(cutting.cuts[0].point.y, w / (1 + w), 1e-15);
    EXPECT_NEAR(cutting.cuts[1].leg_share, 1 / (1 + w), 1e-15);
    EXPECT_NEAR(cutting.cuts[0].weight, 0.5 * (1 + w), 1e-15);
}

TEST(CornerCutting, of_degree_1_puts_a_point_on_the_leg) {
    const Curve line = Curve::make({.degree = 1, .knots = {0, 0, 1, 3, 3}, .points = {{0, 0}, {4, 0}, {4, 8}}}).value();
    const CornerCutting cutting = corner_cutting(line, 1.5).value();
    ASSERT_EQ(cutting.cuts.size(), 1u);
    EXPECT_EQ(cutting.cuts[0].i, 2u);
    EXPECT_EQ(cutting.cuts[0].alpha, 0.25);
    EXPECT_EQ(cutting.cuts[0].point, Point(4, 2));
}

TEST(CornerCutting, of_degree_25_and_far_away) {
    CurveDefinition definition{.degree = 25};
    for (int i = 0; i <= 25 + 30 + 1; ++i) definition.knots.push_back(i);
    for (int i = 0; i <= 30; ++i) definition.points.push_back({1e6 + i, 1e6 + (i % 3)});
    const Curve curve = Curve::make(definition).value();
    const CornerCutting cutting = corner_cutting(curve, 27.5).value();
    expect_cutting(curve, insert_knot(curve, 27.5).value(), cutting);
    // u_i = i: alpha_i = (27.5 - i) / 25.
    EXPECT_EQ(cutting.cuts.front().i, 3u);
    EXPECT_NEAR(cutting.cuts.front().alpha, 24.5 / 25, 1e-15);
    EXPECT_NEAR(cutting.cuts.back().alpha, 0.5 / 25, 1e-15);
}

TEST(CornerCutting, of_huge_numbers_is_refused_or_finite) {
    CurveDefinition definition = lecture_cubic().definition();
    for (Point& point : definition.points) point = {1.7e308 * (point.x > 6 ? 1 : -1), point.y};
    const auto cutting = corner_cutting(Curve::make(definition).value(), 0.5);
    if (!cutting) {
        EXPECT_EQ(cutting.error().code, CurveErrorCode::not_computable);
        return;
    }
    for (const LegCut& cut : cutting->cuts) EXPECT_TRUE(is_finite(cut.point));
}

}  // namespace
}  // namespace batten::core
