#include "core/curve/curve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/random_curves.h"

namespace batten::core {

namespace {

CurveDefinition parabola() {
    return {.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = {{0, 0}, {1, 2}, {3, 0}}, .weights = {1, 2, 1}};
}

CurveError error_of(CurveDefinition definition) {
    const auto curve = Curve::make(std::move(definition));
    EXPECT_FALSE(curve.has_value());
    return curve ? CurveError{} : curve.error();
}

}  // namespace

TEST(Curve, holds_what_it_was_made_of) {
    const Curve curve = Curve::make(parabola()).value();
    EXPECT_EQ(curve.degree(), 2);
    EXPECT_EQ(curve.domain(), (Interval{0, 1}));
    EXPECT_EQ(curve.control_points()[1], Point(1, 2));
    EXPECT_EQ(curve.weights()[1], 2);
    EXPECT_EQ(curve.homogeneous_point(1), HomogeneousPoint(2, 4, 2));
    EXPECT_TRUE(curve.is_rational());
}

TEST(Curve, weights_are_one_where_none_are_given) {
    CurveDefinition definition = parabola();
    definition.weights.clear();
    const Curve curve = Curve::make(definition).value();
    EXPECT_EQ(std::vector(curve.weights().begin(), curve.weights().end()), (std::vector<double>{1, 1, 1}));
    EXPECT_FALSE(curve.is_rational());
    definition.weights = {3, 3, 3};
    EXPECT_FALSE(Curve::make(definition)->is_rational());
}

TEST(Curve, periodic_points_repeat) {
    const Curve curve =
        Curve::make({.degree = 2, .knots = {0, 1, 2, 3}, .points = {{0, 0}, {1, 0}, {0, 1}}, .periodic = true}).value();
    EXPECT_EQ(curve.homogeneous_point(4), HomogeneousPoint(1, 0, 1));
    EXPECT_TRUE(curve.is_periodic());
}

TEST(Curve, refuses_each_defect_with_its_numbers) {
    using Code = CurveErrorCode;
    auto definition = parabola();
    definition.points.pop_back();
    EXPECT_EQ(error_of(definition), (CurveError{.code = Code::too_few_points, .value = 2, .lower = 3}));
    EXPECT_EQ(error_of({.degree = 2, .knots = {0, 1}, .points = {{0, 0}}, .periodic = true}),
              (CurveError{.code = Code::too_few_points, .value = 1, .lower = 2}));
    definition = parabola();
    definition.points.push_back({4, 4});
    EXPECT_EQ(error_of(definition), (CurveError{.code = Code::knot_count_mismatch, .value = 6, .lower = 7}));
    definition = parabola();
    definition.points[1].y = std::nan("");
    EXPECT_EQ(error_of(definition), (CurveError{.code = Code::point_not_finite, .index = 1}));
    definition = parabola();
    definition.weights.pop_back();
    EXPECT_EQ(error_of(definition), (CurveError{.code = Code::weight_count_mismatch, .value = 2, .lower = 3}));
    definition = parabola();
    definition.weights[2] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(error_of(definition), (CurveError{.code = Code::weight_not_finite, .index = 2}));
    definition = parabola();
    definition.weights[1] = 0;
    EXPECT_EQ(error_of(definition), (CurveError{.code = Code::weight_not_positive, .index = 1, .value = 0}));
    definition.weights[1] = -1;
    EXPECT_EQ(error_of(definition), (CurveError{.code = Code::weight_not_positive, .index = 1, .value = -1}));
}

TEST(Curve, checks_in_the_order_that_the_header_promises) {
    using Code = CurveErrorCode;
    const double nan = std::nan("");
    // All defects at once; mending the first shows the next.
    CurveDefinition definition{.degree = 0, .knots = {1, nan}, .points = {{nan, 0}}, .weights = {-1, nan}};
    EXPECT_EQ(error_of(definition).code, Code::degree_out_of_range);
    definition.degree = 1;
    EXPECT_EQ(error_of(definition).code, Code::too_few_points);
    definition.points.push_back({nan, 1});
    definition.points.push_back({1, 1});
    EXPECT_EQ(error_of(definition).code, Code::knot_count_mismatch);
    definition.knots = {1, nan, 0, 0, 0};
    EXPECT_EQ(error_of(definition).code, Code::knot_not_finite);
    definition.knots = {0, 0, 0, 1, 1};
    EXPECT_EQ(error_of(definition).code, Code::multiplicity_too_high);
    definition.knots = {0, 0, 0.5, 1, 1};
    EXPECT_EQ(error_of(definition).code, Code::point_not_finite);
    definition.points = {{0, 0}, {1, 1}, {2, 2}};
    EXPECT_EQ(error_of(definition).code, Code::weight_count_mismatch);
    definition.weights = {-1, nan, 1};
    EXPECT_EQ(error_of(definition).code, Code::weight_not_finite);
    definition.weights = {-1, 1, 1};
    EXPECT_EQ(error_of(definition).code, Code::weight_not_positive);
    definition.weights = {1, 1, 1};
    EXPECT_TRUE(Curve::make(definition));
}

TEST(Curve, over_known_knots_checks_the_same) {
    const auto knots = KnotVector::make(1, {0, 0, 1, 1}).value();
    EXPECT_EQ(Curve::make(knots, {{0, 0}, {1, 1}, {2, 2}}, {}).error(),
              (CurveError{.code = CurveErrorCode::knot_count_mismatch, .value = 4, .lower = 5}));
    EXPECT_EQ(Curve::make(knots, {{0, 0}, {1, 1}}, {1}).error().code, CurveErrorCode::weight_count_mismatch);
    EXPECT_TRUE(Curve::make(knots, {{0, 0}, {1, 1}}, {}));
}

TEST(Curve, copies_share_their_arrays) {
    const Curve curve = Curve::make(parabola()).value();
    const Curve copy = curve;
    EXPECT_EQ(copy.knots().values().data(), curve.knots().values().data());
    EXPECT_EQ(copy.control_points().data(), curve.control_points().data());
    EXPECT_EQ(copy.weights().data(), curve.weights().data());
}

TEST(Curve, is_equal_by_its_values) {
    EXPECT_EQ(Curve::make(parabola()), Curve::make(parabola()));
    for (const auto change :
         {+[](CurveDefinition& d) { d.knots.back() = 2; }, +[](CurveDefinition& d) { d.points[1].y = 3; },
          +[](CurveDefinition& d) { d.weights[1] = 3; }}) {
        CurveDefinition other = parabola();
        change(other);
        EXPECT_NE(Curve::make(other).value(), Curve::make(parabola()).value());
    }
}

TEST(Curve, definition_makes_an_equal_curve) {
    RandomCurves random(2);
    for (int k = 0; k < 100; ++k) {
        const Curve curve = random.curve();
        EXPECT_EQ(Curve::make(curve.definition()), curve);
    }
    EXPECT_EQ(Curve::make(parabola())->definition().tears, Tears::refuse);
    CurveDefinition torn{.degree = 1, .knots = {0, 0, 1, 1, 2, 2}, .points = {{0, 0}, {1, 0}, {1, 1}, {2, 1}}};
    EXPECT_FALSE(Curve::make(torn));
    torn.tears = Tears::allow;
    const Curve curve = Curve::make(torn).value();
    EXPECT_EQ(Curve::make(curve.definition()), curve);
}

}  // namespace batten::core
