#include "core/curve/knot_kinds.h"

#include <gtest/gtest.h>

#include "core/curve/knot_analysis.h"

namespace batten::core {

namespace {

std::vector<double> stored(const Result<KnotVector>& knots) {
    const auto values = knots.value().stored();
    return {values.begin(), values.end()};
}

}  // namespace

TEST(KnotKinds, makes_the_vectors_of_the_books) {
    EXPECT_EQ(stored(make_knots(KnotKind::clamped_uniform, 3, 7)),
              (std::vector<double>{0, 0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1}));
    EXPECT_EQ(stored(make_knots(KnotKind::uniform, 2, 4, {2, 4})), (std::vector<double>{0, 1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(stored(make_knots(KnotKind::bezier, 2, 3)), (std::vector<double>{0, 0, 0, 1, 1, 1}));
    EXPECT_EQ(stored(make_knots(KnotKind::piecewise_bezier, 2, 7, {0, 3})),
              (std::vector<double>{0, 0, 0, 1, 1, 2, 2, 3, 3, 3}));
    EXPECT_EQ(stored(make_knots(KnotKind::periodic, 3, 4, {1, 3})), (std::vector<double>{1, 1.5, 2, 2.5, 3}));
}

TEST(KnotKinds, divides_by_whole_numbers_as_one_writes_them) {
    EXPECT_EQ(stored(make_knots(KnotKind::clamped_uniform, 1, 8, {0, 6})),
              (std::vector<double>{0, 0, 6.0 / 7, 12.0 / 7, 18.0 / 7, 24.0 / 7, 30.0 / 7, 36.0 / 7, 6, 6}));
    EXPECT_EQ(stored(make_knots(KnotKind::clamped_uniform, 1, 4)), (std::vector<double>{0, 0, 1.0 / 3, 2.0 / 3, 1, 1}));
}

TEST(KnotKinds, every_vector_made_is_of_its_kind_over_its_domain) {
    for (const Interval domain : {Interval{0, 1}, Interval{-0.1, 0.7}, Interval{1e9, 1e9 + 1}, Interval{0, 1e-9}})
        for (int degree = min_degree; degree <= max_degree; ++degree)
            for (std::size_t pieces = 1; pieces <= 7; ++pieces) {
                const auto p = static_cast<std::size_t>(degree);
                for (const auto& [kind, count] :
                     {std::pair{KnotKind::clamped_uniform, p + pieces}, std::pair{KnotKind::uniform, p + pieces},
                      std::pair{KnotKind::piecewise_bezier, p * pieces + 1}, std::pair{KnotKind::periodic, pieces + 1},
                      std::pair{KnotKind::bezier, p + 1}}) {
                    const auto knots = make_knots(kind, degree, count, domain);
                    ASSERT_TRUE(knots) << describe(knots.error());
                    EXPECT_EQ(knots->kind(), kind) << title_of(kind) << ' ' << degree << ' ' << count;
                    EXPECT_EQ(knots->domain(), domain);
                    EXPECT_EQ(knots->control_point_count(), count);
                }
            }
}

TEST(KnotKinds, refuses_what_cannot_be_made) {
    using Code = CurveErrorCode;
    EXPECT_EQ(make_knots(KnotKind::uniform, 0, 4).error(), (CurveError{.code = Code::degree_out_of_range, .value = 0}));
    EXPECT_EQ(make_knots(KnotKind::periodic, 26, 4).error().code, Code::degree_out_of_range);
    EXPECT_EQ(make_knots(KnotKind::clamped_uniform, 3, 3).error(),
              (CurveError{.code = Code::too_few_points, .value = 3, .lower = 4}));
    EXPECT_EQ(make_knots(KnotKind::periodic, 3, 1).error(),
              (CurveError{.code = Code::too_few_points, .value = 1, .lower = 2}));
    EXPECT_EQ(make_knots(KnotKind::custom, 3, 5).error().code, Code::kind_not_possible);
    EXPECT_EQ(make_knots(KnotKind::bezier, 3, 5).error().code, Code::kind_not_possible);
    EXPECT_EQ(make_knots(KnotKind::piecewise_bezier, 3, 6).error().code, Code::kind_not_possible);
    EXPECT_TRUE(make_knots(KnotKind::piecewise_bezier, 1, 6));
    EXPECT_EQ(make_knots(KnotKind::uniform, 3, 5, {1, 1}).error().code, Code::domain_empty);
}

}  // namespace batten::core
