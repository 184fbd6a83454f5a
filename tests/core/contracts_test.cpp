// What functions ask of their arguments beyond their types, and do not answer with an error: it is asserted, so that a
// mistake in a program that uses them stops where it was made.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/curve_error.h"
#include "core/base/detail/banded_least_squares.h"
#include "core/base/detail/gauss_rule.h"
#include "core/base/detail/unit_interval.h"
#include "core/base/sentence.h"
#include "core/curve/curve_end.h"
#include "core/curve/detail/spline.h"
#include "core/document/native_file.h"
#include "core/edit/detail/offset_polygon.h"
#include "core/edit/knot_edit.h"
#include "core/edit/point_edit.h"
#include "core/evaluate/basis.h"
#include "core/evaluate/basis_pieces.h"
#include "core/evaluate/basis_triangle.h"
#include "core/evaluate/blossom.h"
#include "core/evaluate/blossom_labels.h"
#include "core/evaluate/detail/piece_motion.h"
#include "core/evaluate/detail/spline_system.h"
#include "core/evaluate/detail/subdivide.h"
#include "core/evaluate/evaluate.h"
#include "core/evaluate/rational_basis.h"
#include "core/evaluate/tessellate.h"
#include "core/evaluate/uniform_cubic.h"
#include "core/evaluate/uniform_cubic_conditions.h"
#include "core/make/fit.h"
#include "core/measure/arc_length.h"
#include "core/measure/bounds.h"
#include "core/measure/closing.h"
#include "core/measure/collinear.h"
#include "core/measure/continuity.h"
#include "core/measure/detail/contact_search.h"
#include "core/measure/detail/piece_forms.h"
#include "core/measure/nearest.h"
#include "core/refine/bezier_form.h"
#include "core/refine/detail/end_knots.h"
#include "core/refine/detail/removable_knot.h"
#include "core/refine/detail/spline_elevation.h"
#include "core/refine/detail/spline_removal.h"
#include "core/refine/knot_insertion.h"
#include "core/refine/knot_removal.h"

namespace batten::core {

#ifdef NDEBUG

TEST(ContractsDeathTest, needs_assertions) {
    GTEST_SKIP() << "assertions are compiled out";
}

#else

namespace {

const double not_a_number = std::nan("");

// A cubic of two pieces over [0, 2], clamped; its spans are 3 and 4.
Curve wave() {
    return Curve::make(
               {.degree = 3, .knots = {0, 0, 0, 0, 1, 2, 2, 2, 2}, .points = {{0, 0}, {1, 2}, {2, 0}, {3, 2}, {4, 0}}})
        .value();
}

Curve ring() {
    return Curve::make(
               {.degree = 2, .knots = {0, 1, 2, 3, 4}, .points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}}, .periodic = true})
        .value();
}

}  // namespace

TEST(ContractsDeathTest, geometry) {
    EXPECT_DEATH((void)lift({1, 2}, 0.0), "weight > 0.0");
    EXPECT_DEATH((void)project({1, 2, 0}), "point.z != 0.0");
    EXPECT_DEATH((void)Interval({2, 1}).clamp(1.5), "lower <= upper");
    EXPECT_DEATH((void)to_unit({1, 1}, 1.0), "interval.lower < interval.upper");
}

TEST(ContractsDeathTest, names_and_sentences) {
    EXPECT_DEATH((void)name_of(static_cast<CurveEnd>(2)), "index < table.size");
    EXPECT_DEATH((void)describe({.code = static_cast<CurveErrorCode>(1000)}), "templates.size");
    EXPECT_DEATH((void)sentence("knot {index}", {}), "was not given");
    EXPECT_DEATH((void)sentence("knot {index}", {{"index", 1}, {"value", 2}}), "has_place");
}

TEST(ContractsDeathTest, least_squares_and_quadrature) {
    EXPECT_DEATH((void)gauss_rule(0), "count >= 1");
    EXPECT_DEATH((void)BandedTriangle<double>(3, 0), "width >= 1");
    BandedTriangle<double> triangle(3, 2);
    EXPECT_DEATH(triangle.add({.first = 0, .coefficients = {1, 1, 1}}), "<= width_");
    EXPECT_DEATH(triangle.add({.first = 2, .coefficients = {1, 1}}), "<= right_.size");
}

TEST(ContractsDeathTest, knot_vector) {
    const Curve curve = wave();
    EXPECT_DEATH((void)curve.knots()[9], "i < values_.size");
    EXPECT_DEATH((void)curve.knots().multiplicity(not_a_number), "isnan");
    EXPECT_DEATH((void)unroll_period(std::vector{1.0}, 2, 2), "period.size\\(\\) >= 2");
}

TEST(ContractsDeathTest, triangle_of_one_span) {
    const Curve curve = wave();
    EXPECT_DEATH((void)ratio_between(1, 1, 1), "lower < upper");
    EXPECT_DEATH((void)SpanKnots(curve.knots(), 2), "p <= s");
    EXPECT_DEATH((void)SpanKnots(curve.knots(), 5), "p <= s");
    const SpanKnots at(curve.knots(), 3);
    auto points = local_points(curve, at);
    EXPECT_DEATH(blend_level(points, at, 4, 0.5), "r <= at.p");
    EXPECT_DEATH(differentiate_level(points, at, 0), "1 <= r");
    EXPECT_DEATH((void)de_boor(points, at, 0.5, 4), "levels_done <= at.p");
}

TEST(ContractsDeathTest, spline) {
    Spline<double> spline{.p = 1, .knots = {0, 0, 1, 2, 2}, .points = {1, 2, 3}};
    EXPECT_DEATH((void)spline.first_of_run(0.5), "multiplicity\\(u\\) > 0");
    EXPECT_DEATH((void)spline.last_of_run(0.5), "multiplicity\\(u\\) > 0");
    EXPECT_DEATH(insert_ascending<double>(spline, std::vector{0.7, 0.5}), "is_sorted");
    EXPECT_DEATH(insert_ascending<double>(spline, std::vector{1.5, 2.5}), "added.back");
    EXPECT_DEATH((void)missing_knots(std::vector{0.0, 2.0}, std::vector{1.0}), "includes");
    EXPECT_DEATH((void)part_between(spline, 3.0, std::nullopt), "contains\\(\\*a\\)");
    EXPECT_DEATH((void)part_between(spline, 1.5, 0.5), "\\*a < \\*b");
}

TEST(ContractsDeathTest, derivatives) {
    EXPECT_DEATH((void)derivatives_at(wave(), 0.5, -1), "order >= 0");
    EXPECT_DEATH((void)derivatives_at(wave(), 0.5, 1)[2], "k <= derivatives.size");
    EXPECT_DEATH((void)derivatives_at(wave(), 0.5, 1)[0], "1 <= k");
    EXPECT_DEATH((void)rational_basis(wave(), 0.5, -1), "order >= 0");
}

TEST(ContractsDeathTest, basis) {
    EXPECT_DEATH((void)basis_functions(wave().knots(), 0.5, -1), "derivative_count >= 0");
    EXPECT_DEATH((void)basis_function(wave().knots(), 5, 0.5), "i < knots.control_point_count");
    EXPECT_DEATH((void)basis_support(wave().knots(), 5), "i < knots.control_point_count");
    EXPECT_DEATH((void)basis_triangle(wave().knots(), 5, 0.5), "i \\+ p \\+ 1 < knots.size");
    EXPECT_DEATH((void)basis_triangle(wave().knots(), 0, not_a_number), "isfinite");
    EXPECT_DEATH((void)basis_pieces(wave().knots(), 0, wave().degree() + 1), "k <= knots.degree");
    EXPECT_EQ(basis_function(ring().knots(), 5, 0.5), basis_function(ring().knots(), 1, 0.5));
    EXPECT_EQ(basis_support(ring().knots(), 5), basis_support(ring().knots(), 1));
}

TEST(ContractsDeathTest, blossom) {
    EXPECT_DEATH((void)blossom(wave(), 3, std::vector{0.5, 0.5}), "arguments.size\\(\\) == at.p");
    EXPECT_DEATH((void)blossom(wave(), 5, std::vector{0.5, 0.5, 0.5}), "s \\+ p \\+ 1 < knots.size");
    EXPECT_DEATH((void)control_point_label(wave().knots(), 5), "< knots.size");
    EXPECT_DEATH((void)de_boor_label(wave().knots(), 3, 4), "r <= p");
}

TEST(ContractsDeathTest, pieces_of_curves) {
    EXPECT_DEATH((void)bezier_piece(wave(), 2), "p <= span");
    EXPECT_DEATH((void)PieceMotion(BezierPiece{.interval = {0, 1}, .points = {{0, 0, 1}}}), "2 <= piece_.points.size");
    EXPECT_DEATH((void)cut_piece(bezier_piece(wave(), 3), 1.0), "u < piece.interval.upper");
    EXPECT_DEATH((void)tessellate(wave(), {0.0, Box{}, {0, 2}}), "request.tolerance > 0.0");
    const FergusonSegment before{.interval = {0, 1}, .start = {0, 0}, .end = {1, 0}};
    const FergusonSegment after{.interval = {1, 2}, .start = {2, 0}, .end = {3, 0}};
    EXPECT_DEATH((void)curve_from_ferguson({before, after}), "before.end != after.start");
    const Curve coons =
        Curve::make({.degree = 3, .knots = {0, 1, 2, 3, 4, 5, 6, 7}, .points = {{0, 0}, {1, 2}, {3, 2}, {4, 0}}})
            .value();
    EXPECT_DEATH((void)cubic_segment(coons, 1), "cubic_segment_count");
    EXPECT_DEATH((void)ferguson_segment(coons, 1), "cubic_segment_count");
    EXPECT_DEATH((void)anticentroid(coons, 0), "0 < i");
    EXPECT_DEATH((void)anticentroid(coons, 3), "i \\+ 1 < n");
    EXPECT_DEATH((void)uniform_cubic_piece(4), "j < 4");
}

TEST(ContractsDeathTest, spline_system) {
    const EndPoints beyond{.known = {{.index = 5, .point = {0, 0}}}};
    EXPECT_DEATH((void)SplineSystem(wave().knots(), {0, 0}, beyond), "given.index < points_.size");
    EXPECT_DEATH((void)SplineSystem(ring().knots(), {0, 0}, EndPoints{.known = {KnownPoint{}}}), "known.empty");
    SplineSystem system(wave().knots(), {0, 0});
    EXPECT_DEATH(system.require_derivative(0.5, 0, {1, 0}), "order >= 1");
    EXPECT_DEATH(system.require_sum(4, std::vector{1.0, 1.0}, {1, 0}), "coefficients.size\\(\\) <= n");
}

TEST(ContractsDeathTest, measures) {
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_DEATH((void)arc_length(wave(), 0.0, not_a_number), "isnan\\(to\\)");
    EXPECT_DEATH((void)ArcLengthTable(wave()).parameter_at(not_a_number), "isnan\\(s\\)");
    EXPECT_DEATH((void)convex_hull(std::vector{Point(0, 0), Point(infinity, 0)}), "is_finite");
    EXPECT_DEATH((void)closing_of(wave(), 0.0), "tolerance > 0.0");
    EXPECT_DEATH((void)absolute_tolerance(wave(), -1.0), "relative >= 0.0");
    EXPECT_DEATH((void)collinear_runs(wave(), -1.0), "tolerance >= 0.0");
    EXPECT_DEATH((void)joint_continuity(wave(), {.derivative = -1.0}), "tolerances.derivative >= 0.0");
    EXPECT_DEATH((void)continuity_of_ends(wave(), {.curvature = not_a_number}), "tolerances.curvature >= 0.0");
    EXPECT_DEATH((void)nearest_point(wave(), {not_a_number, 0}), "is_finite\\(query\\)");
}

TEST(ContractsDeathTest, forms_of_pieces) {
    EXPECT_DEATH((void)Bernstein{}.degree(), "values.empty");
    EXPECT_DEATH((void)part(constant(1.0), {0.5, 0.5}), "interval.lower < interval.upper");
    EXPECT_DEATH((void)piece_forms(wave(), -1), "order >= 0");
    const auto forms = piece_forms(wave(), 0).front().forms;
    EXPECT_DEATH((void)hodograph_x(forms), "forms.size\\(\\) >= 6");
    EXPECT_DEATH((void)hodograph_y(forms), "forms.size\\(\\) >= 6");
}

TEST(ContractsDeathTest, contact_search) {
    EXPECT_DEATH((void)ContactPiece(0, {0, 1}, {}), "points.empty");
    const ContactPieces first = contact_pieces(wave(), {0, 0});
    const ContactPieces second = contact_pieces(ring(), {0, 0});
    ContactSearch search(first, second, 1.0, 1e-9);
    EXPECT_DEATH(search.add_neighbors(first.pieces[0], first.pieces[1]), "is_same_curve");
    EXPECT_DEATH(search.add_alone(first.pieces[0]), "is_same_curve");
}

TEST(ContractsDeathTest, knots_in_and_out) {
    EXPECT_DEATH((void)insert_knot(wave(), 0.5, 0), "times >= 1");
    EXPECT_DEATH((void)remove_knot(wave(), 1.0, 0, 1e-3), "times >= 1");
    EXPECT_DEATH((void)remove_knots_among(wave(), std::vector{1.0, 0.5}, 1e-3), "is_sorted");
    const CarriedSpline spline = unrolled_for_removal(wave());
    EXPECT_DEATH((void)removable_knot(spline, 3), "p < index");
    EXPECT_DEATH((void)without_knots(wave(), spline, {}), "removed.empty");
    EXPECT_DEATH((void)without_knots(wave(), spline, std::vector<RemovableKnot>(2)), "spline.p \\+ 2");
    EXPECT_DEATH((void)cramped_removal(wave(), 1.0), "curve.is_periodic");
    EXPECT_DEATH((void)cramped_removal(ring(), 0.5), "multiplicity\\(u\\) > 0");
    const std::vector<double> points(2, 0.0);
    EXPECT_DEATH((void)removal<double>(std::vector<Ratio>(1), std::vector(1, 1.0), points),
                 "points.size\\(\\) == count \\+ 2");
}

TEST(ContractsDeathTest, ends_and_degree) {
    EXPECT_DEATH((void)carried_precisely(ring()), "is_periodic");
    Spline<double> spline{.p = 1, .knots = {0, 0, 1, 2, 2}, .points = {1, 2, 3}};
    EXPECT_DEATH(exchange_start_knots(spline, std::vector{-1.0, -2.0}), "values.size\\(\\) <= p");
    EXPECT_DEATH((void)KnotComb({.step = 2, .phase = 0, .last = 4}).left_out_until(4), "i < last");
    spline.knots.front() = -1.0;
    EXPECT_DEATH((void)elevated_clamped(spline), "multiplicity\\(spline.knots.front\\(\\)\\) == spline.p \\+ 1");
}

TEST(ContractsDeathTest, joining_pieces) {
    EXPECT_DEATH((void)join_pieces({}, 1e-3), "pieces.empty");
    const CurveDefinition wave_definition = wave().definition();
    EXPECT_DEATH((void)concatenated(ring().definition(), wave_definition), "first.degree == second.degree");
    EXPECT_DEATH((void)concatenated(wave_definition, wave_definition), "second.knots.front");
}

TEST(ContractsDeathTest, edits) {
    EXPECT_DEATH((void)move_knot(wave(), 4, 1.5, KnotMove::snap, -1.0), "snap_distance >= 0.0");
    EXPECT_DEATH((void)delete_control_points(wave(), std::vector<std::size_t>{1, 1}), "adjacent_find");
    EXPECT_DEATH((void)offset_polygon(wave(), 1.0), "curve.degree\\(\\) == 1");
}

TEST(ContractsDeathTest, points_to_pass) {
    EXPECT_DEATH((void)averaged_knots(std::vector{0.0, 1.0}, 2), "sites.size\\(\\) >= p \\+ 1");
    EXPECT_DEATH((void)averaged_knots(std::vector{0.0, 2.0, 1.0}, 2), "is_sorted");
    const std::vector<Point> points{{0, 0}, {1, 1}, {2, 0}, {3, 1}};
    EXPECT_DEATH((void)fit(points, 4, {.penalized_derivative = 1}), "penalized_derivative == 2");
}

TEST(ContractsDeathTest, documents) {
    Document document;
    document.curves.emplace_back();
    EXPECT_DEATH((void)format_document(document), "entry.curve != nullptr");
}

#endif

}  // namespace batten::core
