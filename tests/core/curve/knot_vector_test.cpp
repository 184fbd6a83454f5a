#include "core/curve/knot_vector.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/random_curves.h"

namespace batten::core {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const double not_a_number = std::nan("");

CurveError error_of(const Result<KnotVector>& result) {
    EXPECT_FALSE(result.has_value());
    return result ? CurveError{} : result.error();
}

KnotVector clamped_cubic() {
    return KnotVector::make(3, {0, 0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1}).value();
}

std::vector<double> all(std::span<const double> values) {
    return {values.begin(), values.end()};
}

}  // namespace

TEST(KnotVector, keeps_its_values) {
    const KnotVector knots = clamped_cubic();
    EXPECT_EQ(knots.degree(), 3);
    EXPECT_EQ(knots.control_point_count(), 7u);
    EXPECT_EQ(knots.domain(), (Interval{0, 1}));
    EXPECT_EQ(all(knots.values()), (std::vector<double>{0, 0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1}));
    EXPECT_EQ(all(knots.stored()), all(knots.values()));
    EXPECT_EQ(knots.stored_offset(), 0u);
    EXPECT_FALSE(knots.is_periodic());
}

TEST(KnotVector, domain_of_an_unclamped_vector_leaves_p_knots_outside_at_both_ends) {
    const auto knots = KnotVector::make(2, {0, 1, 2, 3.5, 4, 5, 6}).value();
    EXPECT_EQ(knots.domain(), (Interval{2, 4}));
    EXPECT_EQ(knots.control_point_count(), 4u);
}

TEST(KnotVector, refuses_each_defect_with_its_numbers) {
    using Code = CurveErrorCode;
    EXPECT_EQ(error_of(KnotVector::make(0, {0, 1})), (CurveError{.code = Code::degree_out_of_range, .value = 0}));
    EXPECT_EQ(error_of(KnotVector::make(26, {0, 1})), (CurveError{.code = Code::degree_out_of_range, .value = 26}));
    EXPECT_EQ(error_of(KnotVector::make(3, {0, 0, 0, 1, 1, 1, 1})),
              (CurveError{.code = Code::knot_count_mismatch, .value = 7, .lower = 8}));
    EXPECT_EQ(error_of(KnotVector::make(1, {0, 0, infinity, infinity})),
              (CurveError{.code = Code::knot_not_finite, .index = 2}));
    EXPECT_EQ(error_of(KnotVector::make(1, {0, not_a_number, 1, 1})),
              (CurveError{.code = Code::knot_not_finite, .index = 1}));
    EXPECT_EQ(error_of(KnotVector::make(1, {0, 0, 0.5, 0.25, 1, 1})),
              (CurveError{.code = Code::knot_decreasing, .index = 3, .value = 0.25, .lower = 0.5}));
    EXPECT_EQ(error_of(KnotVector::make(2, {0, 1, 2, 2, 3, 4})), (CurveError{.code = Code::domain_empty, .value = 2}));
    EXPECT_EQ(error_of(KnotVector::make(2, {0, 0, 0, 1, 1, 1, 2, 2, 2})),
              (CurveError{.code = Code::multiplicity_too_high, .index = 3, .value = 3, .upper = 2}));
    EXPECT_EQ(error_of(KnotVector::make(2, {0, 0, 0, 0, 1, 1, 1})),
              (CurveError{.code = Code::multiplicity_too_high, .index = 0, .value = 4, .upper = 3}));
}

TEST(KnotVector, checks_in_the_order_that_the_header_promises) {
    using Code = CurveErrorCode;
    // Each vector has its own defect and all the later ones.
    EXPECT_EQ(error_of(KnotVector::make(0, {1, infinity, 0})).code, Code::degree_out_of_range);
    EXPECT_EQ(error_of(KnotVector::make(2, {1, infinity, 0})).code, Code::knot_count_mismatch);
    EXPECT_EQ(error_of(KnotVector::make(1, {1, 0, 0, 0, infinity})).code, Code::knot_not_finite);
    EXPECT_EQ(error_of(KnotVector::make(1, {1, 0, 0, 0})).code, Code::knot_decreasing);
    EXPECT_EQ(error_of(KnotVector::make(1, {-1e308, 0, 0, 1e308})).code, Code::knots_too_far_apart);
    EXPECT_EQ(error_of(KnotVector::make(1, {0, 0, 0, 0})).code, Code::domain_empty);
    EXPECT_EQ(error_of(KnotVector::make_periodic(0, {1, infinity})).code, Code::degree_out_of_range);
    EXPECT_EQ(error_of(KnotVector::make_periodic(2, {1, infinity})).code, Code::knot_count_mismatch);
    EXPECT_EQ(error_of(KnotVector::make_periodic(2, {1, 0, infinity})).code, Code::knot_not_finite);
    EXPECT_EQ(error_of(KnotVector::make_periodic(2, {1, 0, 0})).code, Code::knot_decreasing);
    EXPECT_EQ(error_of(KnotVector::make_periodic(2, {0, 0, 0})).code, Code::domain_empty);
}

TEST(KnotVector, is_no_longer_than_a_number) {
    using Code = CurveErrorCode;
    EXPECT_TRUE(KnotVector::make(1, {-8e307, -8e307, 8e307, 8e307}));
    EXPECT_EQ(error_of(KnotVector::make(1, {-1e308, -1e308, 1e308, 1e308})),
              (CurveError{.code = Code::knots_too_far_apart, .lower = -1e308, .upper = 1e308}));
    EXPECT_EQ(error_of(KnotVector::make_periodic(1, {-1e308, 0, 1e308})),
              (CurveError{.code = Code::knots_too_far_apart, .lower = -1e308, .upper = 1e308}));
    // Unrolled by two knots on both sides, from -2e307 to 4e307; by four at 1e308, from -2e308 to 3e308.
    EXPECT_TRUE(KnotVector::make_periodic(2, {0, 1e307, 2e307}));
    EXPECT_EQ(error_of(KnotVector::make_periodic(4, {0, 5e307, 1e308})),
              (CurveError{.code = Code::knots_too_far_apart, .lower = 0, .upper = 1e308}));
}

TEST(KnotVector, tears_only_where_allowed) {
    const std::vector<double> torn{0, 0, 0, 1, 1, 1, 2, 2, 2};
    EXPECT_FALSE(KnotVector::make(2, torn));
    EXPECT_TRUE(KnotVector::make(2, torn, KnotKind::custom, Tears::allow));
    EXPECT_EQ(error_of(KnotVector::make(2, {0, 0, 0, 1, 1, 1, 1, 2, 2, 2}, KnotKind::custom, Tears::allow)),
              (CurveError{.code = CurveErrorCode::multiplicity_too_high, .index = 3, .value = 4, .upper = 3}));
}

TEST(KnotVector, a_kind_that_the_values_do_not_have_becomes_custom) {
    EXPECT_EQ(KnotVector::make(1, {0, 0, 1, 2, 2}, KnotKind::clamped_uniform)->kind(), KnotKind::clamped_uniform);
    EXPECT_EQ(KnotVector::make(1, {0, 0, 1, 3, 3}, KnotKind::clamped_uniform)->kind(), KnotKind::custom);
    EXPECT_EQ(KnotVector::make_periodic(2, {0, 1, 2}, KnotKind::periodic)->kind(), KnotKind::periodic);
    EXPECT_EQ(KnotVector::make_periodic(2, {0, 1, 3}, KnotKind::periodic)->kind(), KnotKind::custom);
}

TEST(KnotVector, unrolls_a_period_to_both_sides) {
    const auto knots = KnotVector::make_periodic(3, {1, 2, 4, 5}).value();
    EXPECT_EQ(knots.control_point_count(), 3u);
    EXPECT_EQ(knots.domain(), (Interval{1, 5}));
    EXPECT_EQ(all(knots.values()), (std::vector<double>{-3, -2, 0, 1, 2, 4, 5, 6, 8, 9}));
    EXPECT_EQ(all(knots.stored()), (std::vector<double>{1, 2, 4, 5}));
    EXPECT_EQ(knots.stored_offset(), 3u);
}

TEST(KnotVector, unrolls_over_several_periods_where_the_degree_exceeds_the_points) {
    const auto knots = KnotVector::make_periodic(5, {0, 1, 3}).value();
    EXPECT_EQ(all(knots.values()), (std::vector<double>{-8, -6, -5, -3, -2, 0, 1, 3, 4, 6, 7, 9, 10}));
}

TEST(KnotVector, repeats_equal_knots_as_equal_knots_at_the_seam) {
    // 0.7 - (0.7 - 0.1) is not 0.1 in doubles.
    const auto knots = KnotVector::make_periodic(3, {0.1, 0.1, 0.3, 0.7, 0.7}).value();
    EXPECT_EQ(knots[2], 0.1);
    EXPECT_EQ(knots[8], 0.7);
    EXPECT_EQ(knots.multiplicity(0.1), 3);
    EXPECT_EQ(knots.multiplicity(0.7), 3);
}

TEST(KnotVector, counts_the_seam_once_and_refuses_more_than_p) {
    const auto refused = error_of(KnotVector::make_periodic(2, {0, 0, 1, 2, 2}));
    EXPECT_EQ(refused, (CurveError{.code = CurveErrorCode::multiplicity_too_high, .index = 0, .value = 3, .upper = 2}));
    EXPECT_TRUE(KnotVector::make_periodic(2, {0, 1, 2, 2}));
    EXPECT_EQ(error_of(KnotVector::make_periodic(2, {0, 1, 1, 1, 2})),
              (CurveError{.code = CurveErrorCode::multiplicity_too_high, .index = 1, .value = 3, .upper = 2}));
}

TEST(KnotVector, a_knot_belongs_to_the_span_on_its_right_and_the_end_to_the_last_one) {
    const KnotVector knots = clamped_cubic();
    EXPECT_EQ(knots.span_at(0), 3u);
    EXPECT_EQ(knots.span_at(0.25), 4u);
    EXPECT_EQ(knots.span_at(std::nextafter(0.25, 0.0)), 3u);
    EXPECT_EQ(knots.span_at(0.25, Side::left), 3u);
    EXPECT_EQ(knots.span_at(std::nextafter(0.25, 1.0), Side::left), 4u);
    EXPECT_EQ(knots.span_at(1), 6u);
    EXPECT_EQ(knots.span_at(0, Side::left), 3u);
    EXPECT_EQ(knots.span_at(-5), 3u);
    EXPECT_EQ(knots.span_at(5), 6u);
    EXPECT_EQ(knots.span_at(-infinity, Side::left), 3u);
    EXPECT_EQ(knots.span_at(not_a_number), 3u);
}

TEST(KnotVector, spans_hold_their_parameter_and_are_never_empty) {
    RandomCurves random(1);
    for (int k = 0; k < 500; ++k) {
        const Curve curve = random.curve();
        const KnotVector& knots = curve.knots();
        const double u = random.parameter(curve);
        const auto [lower, upper] = knots.domain();
        const std::size_t right = knots.span_at(u);
        EXPECT_LE(knots[right], u);
        EXPECT_LT(knots[right], knots[right + 1]);
        EXPECT_TRUE(u < knots[right + 1] || (u == upper && u == knots[right + 1]));
        const std::size_t left = knots.span_at(u, Side::left);
        EXPECT_LE(u, knots[left + 1]);
        EXPECT_LT(knots[left], knots[left + 1]);
        EXPECT_TRUE(knots[left] < u || (u == lower && u == knots[left]));
    }
}

TEST(KnotVector, counts_multiplicities_exactly) {
    const auto knots = KnotVector::make(3, {0, 0, 0, 0, 0.5, 0.5, std::nextafter(0.5, 1.0), 1, 1, 1, 1}).value();
    EXPECT_EQ(knots.multiplicity(0), 4);
    EXPECT_EQ(knots.multiplicity(0.5), 2);
    EXPECT_EQ(knots.multiplicity(std::nextafter(0.5, 1.0)), 1);
    EXPECT_EQ(knots.multiplicity(0.75), 0);
}

TEST(KnotVector, clamps_an_open_parameter_and_wraps_a_periodic_one) {
    const KnotVector open = clamped_cubic();
    EXPECT_EQ(open.into_domain(1.5), 1);
    EXPECT_EQ(open.into_domain(-0.5), 0);
    EXPECT_EQ(open.into_domain(infinity), 1);
    EXPECT_EQ(open.into_domain(not_a_number), 0);
    const auto periodic = KnotVector::make_periodic(2, {1, 2, 4}).value();
    EXPECT_EQ(periodic.into_domain(4.5), 1.5);
    EXPECT_EQ(periodic.into_domain(0.5), 3.5);
    EXPECT_EQ(periodic.into_domain(-8.5), 3.5);
    EXPECT_EQ(periodic.into_domain(4), 4);
    EXPECT_EQ(periodic.into_domain(-infinity), 1);
    EXPECT_EQ(periodic.into_domain(not_a_number), 1);
}

TEST(KnotVector, sees_the_seam_as_the_end_on_the_side_asked_for) {
    const auto periodic = KnotVector::make_periodic(2, {1, 2, 4}).value();
    EXPECT_EQ(periodic.into_domain(4, Side::right), 1);
    EXPECT_EQ(periodic.into_domain(1, Side::left), 4);
    EXPECT_EQ(periodic.into_domain(2, Side::left), 2);
    EXPECT_EQ(clamped_cubic().into_domain(1, Side::right), 1);
}

}  // namespace batten::core
