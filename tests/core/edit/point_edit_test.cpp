#include "core/edit/point_edit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/curve/knot_analysis.h"
#include "core/curve/knot_kinds.h"
#include "core/evaluate/evaluate.h"
#include "core/refine/knot_insertion.h"
#include "tests/core/random_curves.h"
#include "tests/core/stored_knots.h"

namespace batten::core {
namespace {

using Knots = std::vector<double>;

std::vector<Point> wave(std::size_t count) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < count; ++i) points.emplace_back(static_cast<double>(i), i % 2 == 0 ? 0.0 : 2.0);
    return points;
}

Curve of_kind(KnotKind kind, int degree, std::size_t count) {
    return Curve::make(make_knots(kind, degree, count).value(), wave(count), {}).value();
}

Curve custom(int degree, Knots knots, std::vector<double> weights = {}) {
    const std::size_t count = knots.size() - static_cast<std::size_t>(degree) - 1;
    return Curve::make({.degree = degree, .knots = knots, .points = wave(count), .weights = weights}).value();
}

std::vector<Point> points(const Curve& curve) {
    return {curve.control_points().begin(), curve.control_points().end()};
}

TEST(SetControlPoint, moves_one_point_exactly) {
    const Curve curve = of_kind(KnotKind::clamped_uniform, 3, 6);
    const Curve result = set_control_point(curve, 2, {7.1, -3.3}).value();
    auto expected = wave(6);
    expected[2] = {7.1, -3.3};
    EXPECT_EQ(points(result), expected);
    EXPECT_EQ(result.knots(), curve.knots());
}

TEST(SetControlPoint, refuses_what_is_not_there_or_not_finite) {
    const Curve curve = of_kind(KnotKind::clamped_uniform, 3, 6);
    EXPECT_EQ(set_control_point(curve, 6, {0, 0}).error(),
              (CurveError{.code = CurveErrorCode::point_index_out_of_range, .index = 6, .upper = 5}));
    EXPECT_EQ(set_control_point(curve, 4, {0, std::nan("")}).error(),
              (CurveError{.code = CurveErrorCode::point_not_finite, .index = 4}));
}

TEST(MoveControlPoints, moves_each_once) {
    const Curve curve = of_kind(KnotKind::clamped_uniform, 3, 6);
    const std::vector<std::size_t> indices{4, 0, 4};
    const Curve result = move_control_points(curve, indices, {0.5, -1.0}).value();
    auto expected = wave(6);
    expected[0] += Vector(0.5, -1.0);
    expected[4] += Vector(0.5, -1.0);
    EXPECT_EQ(points(result), expected);
}

TEST(MoveControlPoints, leaves_knots_and_weights_shared) {
    const Curve curve = of_kind(KnotKind::clamped_uniform, 3, 8);
    const Curve moved = move_control_points(curve, std::vector<std::size_t>{4}, {1, 2}).value();
    EXPECT_EQ(moved.knots().values().data(), curve.knots().values().data());
    EXPECT_EQ(moved.weights().data(), curve.weights().data());
    EXPECT_EQ(curve.control_points()[4] + Vector(1, 2), moved.control_points()[4]);
}

TEST(MoveControlPoints, refuses_without_moving_any) {
    const Curve curve = of_kind(KnotKind::clamped_uniform, 3, 6);
    EXPECT_EQ(move_control_points(curve, std::vector<std::size_t>{0, 6}, {1, 1}).error().code,
              CurveErrorCode::point_index_out_of_range);
    const double huge = std::numeric_limits<double>::max();
    const Curve far = set_control_point(curve, 1, {huge, 0}).value();
    EXPECT_EQ(move_control_points(far, std::vector<std::size_t>{1}, {huge, 0}).error(),
              (CurveError{.code = CurveErrorCode::point_not_finite, .index = 1}));
}

TEST(SetWeight, changes_one_weight_and_no_point) {
    const Curve curve = of_kind(KnotKind::clamped_uniform, 3, 6);
    const Curve result = set_weight(curve, 3, 2.5).value();
    EXPECT_TRUE(std::ranges::equal(result.weights(), Knots{1, 1, 1, 2.5, 1, 1}));
    EXPECT_EQ(points(result), points(curve));
    EXPECT_TRUE(result.is_rational());
}

TEST(SetWeight, refuses_what_is_not_positive) {
    const Curve curve = of_kind(KnotKind::clamped_uniform, 3, 6);
    EXPECT_EQ(set_weight(curve, 3, 0.0).error().code, CurveErrorCode::weight_not_positive);
    EXPECT_EQ(set_weight(curve, 3, -2.0).error(),
              (CurveError{.code = CurveErrorCode::weight_not_positive, .index = 3, .value = -2.0}));
    EXPECT_EQ(set_weight(curve, 3, std::nan("")).error().code, CurveErrorCode::weight_not_finite);
    EXPECT_EQ(set_weight(curve, 6, 1.0).error().code, CurveErrorCode::point_index_out_of_range);
}

TEST(AddControlPoint, special_kinds_stay_special) {
    for (const KnotKind kind : {KnotKind::uniform, KnotKind::clamped_uniform, KnotKind::periodic}) {
        const Curve curve = of_kind(kind, 3, 6);
        const Curve result = add_control_point(curve, 2, {1.5, 9}).value();
        EXPECT_EQ(result.knots().kind(), kind);
        EXPECT_EQ(result.domain(), curve.domain());
        auto expected = wave(6);
        expected.insert(expected.begin() + 2, Point(1.5, 9));
        EXPECT_EQ(points(result), expected);
    }
    const Curve polyline = of_kind(KnotKind::piecewise_bezier, 1, 4);
    EXPECT_EQ(add_control_point(polyline, 2, {1.5, 9})->knots().kind(), KnotKind::piecewise_bezier);
}

TEST(AddControlPoint, bezier_grows_in_degree) {
    const Curve result = add_control_point(of_kind(KnotKind::bezier, 3, 4), 1, {0.5, 3}).value();
    EXPECT_EQ(result.degree(), 4);
    EXPECT_EQ(result.knots().kind(), KnotKind::bezier);
    const Curve full = of_kind(KnotKind::bezier, max_degree, 26);
    EXPECT_EQ(add_control_point(full, 1, {0, 0}).error().code, CurveErrorCode::degree_out_of_range);
}

TEST(AddControlPoint, custom_gains_the_knot_under_the_leg) {
    const Curve curve = custom(3, {0, 0, 0, 0, 1, 3, 4, 7, 7, 7, 7});
    // Greville abscissae 0, 1/3, 4/3, 8/3, 14/3, 6, 7.
    EXPECT_EQ(stored(add_control_point(curve, 3, {2.5, 5}).value()), (Knots{0, 0, 0, 0, 1, 2, 3, 4, 7, 7, 7, 7}));
    EXPECT_EQ(stored(add_control_point(curve, 5, {4.5, 5}).value()), (Knots{0, 0, 0, 0, 1, 3, 4, 5.5, 7, 7, 7, 7}));
    EXPECT_EQ(stored(add_control_point(curve, 0, {-1, 0}).value()), (Knots{0, 0, 0, 0, 0.5, 1, 3, 4, 7, 7, 7, 7}));
    EXPECT_EQ(stored(add_control_point(curve, 7, {9, 0}).value()), (Knots{0, 0, 0, 0, 1, 3, 4, 5.5, 7, 7, 7, 7}));
}

TEST(AddControlPoint, ends_are_new_ends) {
    const Curve curve = custom(3, {0, 0, 0, 0, 1, 3, 4, 7, 7, 7, 7}, {2, 1, 1, 1, 1, 1, 5});
    const Curve before = add_control_point(curve, 0, {-1, 4}).value();
    EXPECT_EQ(point_at(before, 0.0), Point(-1, 4));
    EXPECT_EQ(before.weights().front(), 2.0);
    const Curve after = add_control_point(curve, 7, {8, -4}).value();
    EXPECT_EQ(point_at(after, 7.0), Point(8, -4));
    EXPECT_EQ(after.weights().back(), 5.0);
}

TEST(AddControlPoint, weight_is_interpolated_along_the_leg) {
    const Curve curve = custom(2, {0, 0, 0, 1, 3, 3, 3}, {1, 3, 1, 1});
    // The leg goes from (0, 0) to (1, 2).
    EXPECT_DOUBLE_EQ(add_control_point(curve, 1, {0.25, 0.5})->weights()[1], 1.5);
    EXPECT_DOUBLE_EQ(add_control_point(curve, 1, {0.75, 1.5})->weights()[1], 2.5);
    EXPECT_DOUBLE_EQ(add_control_point(curve, 1, {7, 9})->weights()[1], 3.0);
    EXPECT_DOUBLE_EQ(add_control_point(curve, 3, {3, 2})->weights()[3], 1.0);
}

TEST(AddControlPoint, piecewise_bezier_without_a_fitting_vector_becomes_custom) {
    const Curve curve = of_kind(KnotKind::piecewise_bezier, 2, 5);
    const Curve result = add_control_point(curve, 1, {0.5, 1}).value();
    EXPECT_EQ(result.knots().kind(), KnotKind::custom);
    EXPECT_EQ(stored(result), (Knots{0, 0, 0, 0.25, 0.5, 0.5, 1, 1, 1}));
}

TEST(AddControlPoint, periodic_custom_keeps_its_domain) {
    const Curve curve =
        Curve::make({.degree = 3, .knots = {0, 1, 2, 4, 7}, .points = wave(4), .periodic = true}).value();
    for (std::size_t index = 0; index <= 4; ++index) {
        const Curve result = add_control_point(curve, index, {9, 9}).value();
        EXPECT_EQ(result.domain(), curve.domain());
        auto expected = wave(4);
        expected.insert(expected.begin() + static_cast<std::ptrdiff_t>(index == 0 ? 4 : index), Point(9, 9));
        EXPECT_EQ(points(result), expected);
        EXPECT_TRUE(std::ranges::includes(stored(result), stored(curve)));
    }
}

TEST(AddControlPoint, far_part_of_a_custom_curve_stays) {
    RandomCurves random(91);
    for (const bool periodic : {false, true}) {
        Knots knots{0.0};
        for (int i = 0; i < (periodic ? 20 : 24); ++i) knots.push_back(knots.back() + random.number(0.5, 1.5));
        const auto count = periodic ? knots.size() - 1 : knots.size() - 4;
        const Curve curve =
            Curve::make({.degree = 3, .knots = knots, .points = wave(count), .periodic = periodic}).value();
        const Curve result = add_control_point(curve, 10, {9.5, 1}).value();
        const double u = greville_abscissae(curve.knots())[10];
        for (const double far : {-6.5, -5.0, 5.0, 6.5})
            EXPECT_NEAR(distance(point_at(curve, u + far * 1.5), point_at(result, u + far * 1.5)), 0.0, 1e-12);
    }
}

TEST(AddControlPoint, works_on_any_curve_and_leg) {
    RandomCurves random(92);
    for (int i = 0; i < 1000; ++i) {
        const Curve curve = random.curve();
        const auto count = static_cast<int>(curve.control_points().size());
        const auto index = static_cast<std::size_t>(random.whole(0, count));
        const auto result = add_control_point(curve, index, {1, 1});
        ASSERT_TRUE(result.has_value()) << describe(result.error());
        EXPECT_EQ(result->control_points().size(), curve.control_points().size() + 1);
        EXPECT_EQ(result->domain(), curve.domain());
        EXPECT_TRUE(std::ranges::includes(stored(*result), stored(curve)));
    }
}

TEST(AddControlPoint, refuses_what_is_not_there_or_not_finite) {
    const Curve curve = of_kind(KnotKind::clamped_uniform, 3, 6);
    EXPECT_EQ(add_control_point(curve, 7, {0, 0}).error(),
              (CurveError{.code = CurveErrorCode::point_index_out_of_range, .index = 7, .upper = 6}));
    EXPECT_EQ(add_control_point(curve, 6, {std::numeric_limits<double>::infinity(), 0}).error(),
              (CurveError{.code = CurveErrorCode::point_not_finite, .index = 6}));
}

TEST(DeleteControlPoint, special_kinds_stay_special) {
    for (const KnotKind kind : {KnotKind::uniform, KnotKind::clamped_uniform, KnotKind::periodic}) {
        const Curve curve = of_kind(kind, 3, 6);
        const Curve result = delete_control_point(curve, 2).value();
        EXPECT_EQ(result.knots().kind(), kind);
        EXPECT_EQ(result.domain(), curve.domain());
        auto expected = wave(6);
        expected.erase(expected.begin() + 2);
        EXPECT_EQ(points(result), expected);
    }
    const Curve conic = delete_control_point(of_kind(KnotKind::bezier, 3, 4), 0).value();
    EXPECT_EQ(conic.degree(), 2);
    EXPECT_EQ(conic.knots().kind(), KnotKind::bezier);
}

TEST(DeleteControlPoint, custom_loses_the_knot_nearest_to_its_greville_abscissa) {
    const Curve curve = custom(3, {0, 0, 0, 0, 1, 3, 4, 7, 7, 7, 7});
    // Greville abscissae 0, 1/3, 4/3, 8/3, 14/3, 6, 7.
    EXPECT_EQ(stored(delete_control_point(curve, 2).value()), (Knots{0, 0, 0, 0, 3, 4, 7, 7, 7, 7}));
    EXPECT_EQ(stored(delete_control_point(curve, 3).value()), (Knots{0, 0, 0, 0, 1, 4, 7, 7, 7, 7}));
    EXPECT_EQ(stored(delete_control_point(curve, 6).value()), (Knots{0, 0, 0, 0, 1, 3, 7, 7, 7, 7}));
}

TEST(DeleteControlPoint, undoes_adding_on_a_custom_vector) {
    const Curve curve = custom(3, {0, 0, 0, 0, 1, 3, 4, 7, 7, 7, 7}, {1, 2, 3, 4, 3, 2, 1});
    for (std::size_t index = 2; index <= 5; ++index) {
        const Curve added = add_control_point(curve, index, {0, 0}).value();
        const Curve rest = delete_control_point(added, index).value();
        EXPECT_EQ(points(rest), points(curve));
        EXPECT_TRUE(std::ranges::equal(rest.weights(), curve.weights()));
    }
}

TEST(DeleteControlPoint, refuses_the_last_that_can_be_spared) {
    EXPECT_EQ(delete_control_point(of_kind(KnotKind::clamped_uniform, 3, 4), 1).error(),
              (CurveError{.code = CurveErrorCode::too_few_points, .value = 3, .lower = 4}));
    EXPECT_EQ(delete_control_point(custom(2, {0, 0, 0, 1, 1, 2}), 1).error().code, CurveErrorCode::too_few_points);
    EXPECT_EQ(delete_control_point(of_kind(KnotKind::bezier, 1, 2), 1).error(),
              (CurveError{.code = CurveErrorCode::too_few_points, .value = 1, .lower = 2}));
    EXPECT_EQ(delete_control_point(of_kind(KnotKind::periodic, 3, 2), 1).error().code, CurveErrorCode::too_few_points);
    EXPECT_EQ(delete_control_point(of_kind(KnotKind::periodic, 3, 3), 3).error().code,
              CurveErrorCode::point_index_out_of_range);
}

TEST(DeleteControlPoint, works_on_any_curve_with_enough_points) {
    RandomCurves random(93);
    for (int i = 0; i < 1000; ++i) {
        const Curve curve = random.curve();
        const auto count = static_cast<int>(curve.control_points().size());
        const auto result = delete_control_point(curve, static_cast<std::size_t>(random.whole(0, count - 1)));
        const int least = curve.is_periodic() ? 2 : curve.degree() + 1;
        ASSERT_EQ(result.has_value(), count > least);
        if (!result) continue;
        EXPECT_EQ(result->domain(), curve.domain());
        EXPECT_TRUE(std::ranges::includes(stored(curve), stored(*result)));
    }
}

TEST(DeleteControlPoints, of_many_points_is_deleting_one_after_the_other) {
    RandomCurves random(94);
    for (int k = 0; k < 600; ++k) {
        Curve curve = insert_midpoint_knots(random.curve()).value();
        if (k % 3 == 0) curve = of_kind(KnotKind::clamped_uniform, 1 + k % 5, 12);
        if (k % 3 == 1) curve = insert_midpoint_knots(curve).value();
        std::vector<std::size_t> gone;
        for (std::size_t i = 0; i < curve.control_points().size(); ++i)
            if (random.whole(0, 2) == 0) gone.push_back(i);
        Result<Curve> expected = curve;
        for (std::size_t i = gone.size(); i-- > 0;)
            expected = expected.and_then([&](const Curve& c) { return delete_control_point(c, gone[i]); });
        const Result<Curve> found = delete_control_points(curve, gone);
        ASSERT_EQ(found.has_value(), expected.has_value());
        if (!found) {
            EXPECT_EQ(found.error(), expected.error());
            continue;
        }
        EXPECT_EQ(points(*found), points(*expected));
        ASSERT_EQ(stored(*found).size(), stored(*expected).size());
        for (std::size_t i = 0; i < stored(*found).size(); ++i)
            EXPECT_NEAR(stored(*found)[i], stored(*expected)[i], 1e-14 * curve.domain().length());
    }
}

TEST(DeleteControlPoints, deletes_each_whatever_the_order) {
    const Curve curve = of_kind(KnotKind::clamped_uniform, 2, 8);
    const Curve result = delete_control_points(curve, std::vector<std::size_t>{1, 6, 3}).value();
    const std::vector<Point> expected{{0, 0}, {2, 0}, {4, 0}, {5, 2}, {7, 2}};
    EXPECT_EQ(points(result), expected);
    EXPECT_EQ(delete_control_points(curve, {}).value(), curve);
    EXPECT_EQ(delete_control_points(curve, std::vector<std::size_t>{0, 8}).error().code,
              CurveErrorCode::point_index_out_of_range);
    EXPECT_EQ(delete_control_points(curve, std::vector<std::size_t>{0, 1, 2, 3, 4, 5}).error().code,
              CurveErrorCode::too_few_points);
}

}  // namespace
// At half the radius a point goes (1 - 1/4)^2 = 9/16 of the way.
TEST(SoftMove, falls_off_to_the_radius) {
    const Curve curve =
        Curve::make(
            {.degree = 1, .knots = {0, 0, 1, 2, 3, 4, 4}, .points = {{0, 0}, {1, 0}, {2, 0}, {0, 1.9}, {0, -1}}})
            .value();
    const std::vector<std::size_t> pinned{4};
    const Curve moved = soft_move(curve, {0, 0}, 2.0, {16, -32}, pinned).value();
    EXPECT_EQ(moved.control_points()[0], Point(16, -32));
    EXPECT_EQ(moved.control_points()[1], Point(1 + 9, -18));
    EXPECT_EQ(moved.control_points()[2], Point(2, 0));
    EXPECT_NEAR(moved.control_points()[3].x, 16 * 0.0975 * 0.0975, 1e-14);
    EXPECT_EQ(moved.control_points()[4], Point(0, -1));
    EXPECT_EQ(moved.knots(), curve.knots());
    EXPECT_EQ(soft_move(curve, {0, 0}, 0.0, {1, 1}).error().code, CurveErrorCode::length_not_positive);
    EXPECT_EQ(soft_move(curve, {0, 0}, 1.0, {1, std::nan("")}).error().code, CurveErrorCode::vector_not_finite);
}

}  // namespace batten::core
