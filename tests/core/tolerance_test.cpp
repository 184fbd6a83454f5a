// Every operation that takes a tolerance wants one above 0 and finite.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "core/edit/knot_merging.h"
#include "core/edit/offset.h"
#include "core/make/conics.h"
#include "core/make/fit.h"
#include "core/refine/bezier_form.h"
#include "core/refine/degree.h"
#include "core/refine/knot_removal.h"
#include "core/refine/periodic.h"

namespace batten::core {

namespace {

class BadTolerance : public testing::TestWithParam<double> {};

template <class T>
void expect_refused(const Result<T>& result) {
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, CurveErrorCode::tolerance_not_positive);
}

TEST_P(BadTolerance, is_refused_by_every_operation) {
    const double tolerance = GetParam();
    const Curve ring = circle({0, 0}, 1.0).value();
    const std::array pieces{ring, ring};
    const std::array<Point, 4> points{Point(0, 0), Point(1, 1), Point(2, 0), Point(3, 1)};
    expect_refused(to_periodic(ring, tolerance));
    expect_refused(to_wrapped(ring, tolerance));
    expect_refused(move_seam(ring, 0.5, tolerance));
    expect_refused(offset(ring, 0.5, tolerance));
    expect_refused(merge_knots(ring, tolerance));
    expect_refused(fit_within(points, tolerance));
    expect_refused(join_pieces(pieces, tolerance));
    expect_refused(reduce_degree(ring, 1, tolerance));
    expect_refused(remove_knot(ring, 0.5, 1, tolerance));
    expect_refused(remove_knots(ring, tolerance));
}

INSTANTIATE_TEST_SUITE_P(Tolerances, BadTolerance,
                         testing::Values(0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()));

}  // namespace

}  // namespace batten::core
