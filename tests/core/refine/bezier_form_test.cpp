#include "core/refine/bezier_form.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/curve/knot_analysis.h"
#include "core/evaluate/bezier_pieces.h"
#include "core/measure/deviation.h"
#include "core/refine/join.h"
#include "core/refine/split.h"
#include "tests/core/shape_check.h"

namespace batten::core {
namespace {

TEST(BezierForm, has_the_points_of_the_pieces) {
    RandomCurves random(351);
    for (int k = 0; k < 400; ++k) {
        const Curve curve = random.curve();
        const Curve bezier = to_bezier(curve).value();
        EXPECT_EQ(bezier.domain(), curve.domain());
        EXPECT_EQ(bezier.is_periodic(), curve.is_periodic());
        EXPECT_LE(shape_change(curve, bezier, random), 1e-14);
        const auto p = static_cast<std::size_t>(curve.degree());
        const std::size_t pieces = segment_count(curve.knots());
        EXPECT_EQ(bezier.control_points().size(), pieces * p + (curve.is_periodic() ? 0 : 1));
        EXPECT_EQ(is_clamped(bezier.knots()), !curve.is_periodic());
        const auto curves = bezier_curves(curve).value();
        const auto found = bezier_pieces(curve);
        ASSERT_EQ(curves.size(), pieces);
        ASSERT_EQ(found.size(), pieces);
        for (std::size_t i = 0; i < pieces; ++i) {
            EXPECT_EQ(curves[i].domain(), found[i].interval);
            EXPECT_EQ(curves[i].knots().kind(), KnotKind::bezier);
            const BezierPiece by_blossoms = bezier_piece(curve, found[i].span);
            for (std::size_t j = 0; j <= p; ++j) {
                const Point expected = project(by_blossoms.points[j]);
                EXPECT_LE(distance(curves[i].control_points()[j], expected), 1e-12);
                EXPECT_LE(distance(project(found[i].points[j]), expected), 1e-12);
            }
        }
    }
}

TEST(BezierForm, takes_its_kind) {
    const Curve curve =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 2, 2, 2}, .points = {{0, 0}, {1, 1}, {2, 0}, {3, 1}}}).value();
    EXPECT_EQ(to_bezier(curve)->knots().kind(), KnotKind::piecewise_bezier);
    EXPECT_EQ(to_bezier(split(curve, 1.0)->front())->knots().kind(), KnotKind::bezier);
}

TEST(JoinPieces, undoes_bezier_curves) {
    RandomCurves random(352);
    for (int k = 0; k < 200; ++k) {
        const Curve curve = random.open_curve();
        const auto joined = join_pieces(bezier_curves(curve).value(), 1e-8);
        ASSERT_TRUE(joined) << describe(joined.error());
        EXPECT_EQ(joined->curve.domain(), curve.domain());
        EXPECT_LE(joined->error, 1e-8);
        EXPECT_LE(largest_deviation(curve, joined->curve), 2e-8);
        EXPECT_TRUE(!is_clamped(curve.knots()) ||
                    joined->curve.control_points().size() <= curve.control_points().size());
    }
}

TEST(JoinPieces, undoes_a_split_with_other_weights_and_domains) {
    RandomCurves random(353);
    const Curve curve = high_degree_curve(3, 6, random);
    const auto parts = split(curve, 0.4 * curve.domain().upper).value();
    CurveDefinition moved = parts[1].definition();
    for (double& knot : moved.knots) knot += 16.0;
    for (double& weight : moved.weights) weight *= 8.0;
    const std::vector<Curve> pieces{parts[0], Curve::make(moved).value()};
    const auto joined = join_pieces(pieces, 1e-10).value();
    EXPECT_EQ(joined.curve.control_points().size(), curve.control_points().size());
    EXPECT_LE(point_difference(curve, joined.curve), 1e-13);
}

TEST(JoinPieces, raises_degrees_and_keeps_corners) {
    const Curve line = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {3, 0}}}).value();
    const Curve arc =
        Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{3, 0}, {4, 4}, {6, 0}}}).value();
    const auto joined = join_pieces(std::vector{line, arc}, 1e-6).value();
    EXPECT_EQ(joined.curve.degree(), 2);
    EXPECT_EQ(stored(joined.curve), (std::vector<double>{0, 0, 0, 1, 1, 2, 2, 2}));
    EXPECT_EQ(joined.error, 0.0);
    EXPECT_EQ(joined.curve.control_points()[1], Point(1.5, 0));
}

TEST(JoinPieces, tells_one_piece_from_several) {
    using enum KnotKind;
    const auto piece = [](std::vector<Point> points, KnotKind kind) {
        return Curve::make({.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = std::move(points), .kind = kind})
            .value();
    };
    const auto kind_of = [](const std::vector<Curve>& pieces) {
        return join_pieces(pieces, 1e-9).value().curve.knots().kind();
    };
    const Curve arc = piece({{0, 0}, {1, 2}, {2, 0}}, bezier);
    const Curve next = piece({{2, 0}, {3, 2}, {4, 0}}, bezier);
    const Curve last = piece({{4, 0}, {5, 2}, {6, 0}}, clamped_uniform);
    const Curve again = join_pieces(split(arc, 0.25).value(), 1e-9).value().curve;
    EXPECT_EQ(kind_by_values(again.knots()), bezier) << "one piece, as it was";
    EXPECT_EQ(kind_of({arc, next}), piecewise_bezier);
    EXPECT_EQ(kind_of({*join_pieces(std::vector{arc, next}, 1e-9).map(&Approximation::curve),
                       piece({{4, 0}, {5, 2}, {6, 0}}, bezier)}),
              piecewise_bezier);
    EXPECT_EQ(kind_of({arc, next, last}), custom) << "which the last one is not";
    EXPECT_EQ(join(arc, next, JoinContinuity::c0)->curve.knots().kind(), piecewise_bezier);
    EXPECT_EQ(join(arc, next, JoinContinuity::c1)->curve.knots().kind(), custom);
}

TEST(JoinPieces, refuses_gaps_and_rings) {
    const Curve line = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {3, 0}}}).value();
    EXPECT_EQ(join_pieces(std::vector{line, line}, 1.0).error(),
              (CurveError{.code = CurveErrorCode::ends_apart, .value = 3.0, .upper = 1.0}));
    const Curve ring =
        Curve::make({.degree = 2, .knots = {0, 1, 2}, .points = {{0, 0}, {1, 2}}, .periodic = true}).value();
    const Curve far = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{-1e300, 0}, {-1.5e308, 0}}}).value();
    EXPECT_EQ(join_pieces(std::vector{line, far}, 1.0).error(),
              (CurveError{.code = CurveErrorCode::ends_apart, .value = 1e300, .upper = 1.0}));
    const Curve opposite = Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {{1.5e308, 0}, {0, 0}}}).value();
    EXPECT_EQ(join_pieces(std::vector{far, opposite}, 1.0).error().code, CurveErrorCode::not_computable);
    EXPECT_EQ(join_pieces(std::vector{line, ring}, 1.0).error().code, CurveErrorCode::curve_periodic);
    EXPECT_EQ(join_pieces(std::vector{line}, 0.0).error().code, CurveErrorCode::tolerance_not_positive);
    EXPECT_EQ(join_pieces(std::vector{line}, 1.0)->curve, line);
}

}  // namespace
}  // namespace batten::core
