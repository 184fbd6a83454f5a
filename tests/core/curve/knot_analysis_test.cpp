#include "core/curve/knot_analysis.h"

#include <gtest/gtest.h>

namespace batten::core {

namespace {

KnotVector open(int degree, std::vector<double> knots) {
    return KnotVector::make(degree, std::move(knots), KnotKind::custom, Tears::allow).value();
}

KnotVector closed(int degree, std::vector<double> period) {
    return KnotVector::make_periodic(degree, std::move(period)).value();
}

}  // namespace

TEST(KnotAnalysis, lists_the_distinct_knots) {
    const auto distinct = distinct_knots(open(2, {0, 0, 0, 1, 2, 2, 3, 3, 3}));
    ASSERT_EQ(distinct.size(), 4u);
    EXPECT_EQ(distinct[0],
              (DistinctKnot{.value = 0, .first = 0, .multiplicity = 3, .continuity = -1, .in_domain = true}));
    EXPECT_EQ(distinct[1],
              (DistinctKnot{
                  .value = 1, .first = 3, .multiplicity = 1, .continuity = 1, .in_domain = true, .is_interior = true}));
    EXPECT_EQ(distinct[2],
              (DistinctKnot{
                  .value = 2, .first = 4, .multiplicity = 2, .continuity = 0, .in_domain = true, .is_interior = true}));
    EXPECT_EQ(distinct[3].first, 6u);
}

TEST(KnotAnalysis, marks_the_knots_outside_the_domain) {
    const auto distinct = distinct_knots(open(2, {0, 1, 2, 3, 4, 5}));
    std::vector<bool> inside;
    for (const auto& knot : distinct) inside.push_back(knot.in_domain);
    EXPECT_EQ(inside, (std::vector<bool>{false, false, true, true, false, false}));
    for (const auto& knot : distinct) EXPECT_FALSE(knot.is_interior);
}

TEST(KnotAnalysis, treats_the_seam_as_an_interior_knot) {
    const auto distinct = distinct_knots(closed(3, {0, 0, 1, 2, 2}));
    ASSERT_EQ(distinct.size(), 2u);
    EXPECT_EQ(distinct[0],
              (DistinctKnot{
                  .value = 0, .first = 3, .multiplicity = 3, .continuity = 0, .in_domain = true, .is_interior = true}));
    EXPECT_EQ(distinct[1].value, 1);
    EXPECT_EQ(distinct[1].continuity, 2);
    EXPECT_EQ(least_continuity(closed(3, {0, 0, 1, 2, 2})), 0);
    EXPECT_EQ(segment_count(closed(3, {0, 0, 1, 2, 2})), 2u);
}

TEST(KnotAnalysis, finds_the_least_continuity) {
    EXPECT_EQ(least_continuity(open(3, {0, 0, 0, 0, 1, 1, 1, 1})), std::nullopt);
    EXPECT_EQ(least_continuity(open(3, {0, 0, 0, 0, 1, 2, 2, 3, 3, 3, 3})), 1);
    EXPECT_EQ(least_continuity(open(2, {0, 0, 0, 1, 1, 1, 2, 2, 2})), -1);
}

TEST(KnotAnalysis, clamped_needs_both_ends) {
    EXPECT_TRUE(is_clamped(open(2, {0, 0, 0, 1, 1, 1})));
    EXPECT_FALSE(is_clamped(open(2, {0, 0, 0, 1, 1, 2})));
    EXPECT_FALSE(is_clamped(open(2, {-1, 0, 0, 1, 1, 1})));
    EXPECT_FALSE(is_clamped(open(2, {-1, 0, 0, 0, 1, 1, 1})));
    EXPECT_FALSE(is_clamped(closed(2, {0, 0, 1, 2})));
}

TEST(KnotAnalysis, uniform_up_to_rounding_and_no_further) {
    EXPECT_TRUE(is_uniform(open(1, {0, 0, 0.1, 0.2, 0.1 + 0.2, 0.4, 0.4})));
    EXPECT_TRUE(is_uniform(open(1, {0, 0, 1e9 / 3, 2e9 / 3, 1e9, 1e9})));
    EXPECT_FALSE(is_uniform(open(1, {0, 0, 1.0000000001, 2, 2})));
    EXPECT_FALSE(is_uniform(open(1, {0, 0, 1e-9, 3e-9, 3e-9})));
    EXPECT_FALSE(is_uniform(open(2, {0, 0, 0, 1, 1, 2, 2, 2})));
}

TEST(KnotAnalysis, greville_abscissae_are_averages) {
    const std::vector<double> expected{0, 1.0 / 12, 0.25, 0.5, 0.75, 11.0 / 12, 1};
    const auto found = greville_abscissae(open(3, {0, 0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1}));
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_DOUBLE_EQ(found[i], expected[i]);
}

TEST(KnotAnalysis, greville_abscissae_of_equal_knots_are_that_knot) {
    // 0.1 + 0.1 + 0.1 divided by 3 is not 0.1 in doubles.
    const auto found = greville_abscissae(open(3, {0.1, 0.1, 0.1, 0.1, 0.7, 0.7, 0.7, 0.7}));
    EXPECT_EQ(found.front(), 0.1);
    EXPECT_EQ(found.back(), 0.7);
}

TEST(KnotAnalysis, greville_abscissae_of_an_unclamped_vector_may_lie_outside_the_domain) {
    EXPECT_EQ(greville_abscissae(open(2, {0, 1, 2, 3, 4, 5})), (std::vector<double>{1.5, 2.5, 3.5}));
}

TEST(KnotAnalysis, periodic_greville_abscissae_are_wrapped) {
    // Unrolled from u_0: -2 -1 0 1 2 3; the averages are -0.5, 0.5 and 1.5.
    EXPECT_EQ(greville_abscissae(closed(2, {0, 1, 2, 3})), (std::vector<double>{2.5, 0.5, 1.5}));
}

TEST(KnotAnalysis, classifies_the_most_special_kind) {
    EXPECT_EQ(classify(open(2, {0, 0, 0, 1, 1, 1})), KnotKind::bezier);
    EXPECT_EQ(classify(open(1, {0, 0, 1, 2, 2})), KnotKind::clamped_uniform);
    EXPECT_EQ(classify(open(2, {0, 0, 0, 1, 1, 2, 2, 2})), KnotKind::piecewise_bezier);
    EXPECT_EQ(classify(open(2, {0, 0, 0, 1, 1, 5, 5, 5})), KnotKind::piecewise_bezier);
    EXPECT_EQ(classify(open(2, {0, 1, 2, 3, 4, 5})), KnotKind::uniform);
    EXPECT_EQ(classify(open(2, {0, 1, 2, 3, 4, 6})), KnotKind::custom);
    const KnotVector kept = open(3, {0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4});
    EXPECT_EQ(kept.kind(), KnotKind::custom);
    EXPECT_EQ(kind_by_values(kept), KnotKind::clamped_uniform);
    EXPECT_EQ(kind_by_values(open(3, {0, 0, 0, 0, 1, 2, 3.5, 4, 4, 4, 4})), KnotKind::custom);
    EXPECT_EQ(classify(open(2, {0, 0, 0, 1, 3, 3, 3})), KnotKind::custom);
    EXPECT_EQ(classify(closed(2, {0, 1, 2, 3})), KnotKind::periodic);
    EXPECT_EQ(classify(closed(2, {0, 1, 2, 4})), KnotKind::custom);
    EXPECT_TRUE(is_of_kind(open(2, {0, 0, 0, 1, 1, 1}), KnotKind::piecewise_bezier));
    EXPECT_TRUE(is_of_kind(open(2, {0, 0, 0, 1, 1, 1}), KnotKind::custom));
}

TEST(KnotAnalysis, names_the_kinds) {
    EXPECT_STREQ(title_of(KnotKind::uniform), "uniform");
    EXPECT_STREQ(title_of(KnotKind::clamped_uniform), "clamped uniform");
    EXPECT_STREQ(title_of(KnotKind::bezier), "Bézier");
    EXPECT_STREQ(title_of(KnotKind::piecewise_bezier), "piecewise Bézier");
    EXPECT_STREQ(title_of(KnotKind::periodic), "periodic");
    EXPECT_STREQ(title_of(KnotKind::custom), "custom");
}

}  // namespace batten::core
