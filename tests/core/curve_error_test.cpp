#include "core/curve_error.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace batten::core {

TEST(CurveError, says_what_was_found_where_and_what_is_allowed) {
    using Code = CurveErrorCode;
    const struct {
        CurveError error;
        const char* sentence;
    } expectations[] = {
        {{.code = Code::degree_out_of_range, .value = 26}, "the degree is 26; it must be from 1 to 25"},
        {{.code = Code::too_few_points, .value = 3, .lower = 4}, "3 control points were found; at least 4 are needed"},
        {{.code = Code::too_few_points, .value = 1, .lower = 2}, "one control point was found; at least 2 are needed"},
        {{.code = Code::knot_count_mismatch, .value = 6, .lower = 8},
         "6 knots were found; 8 are needed, which is points + degree + 1, or points + 1 for a periodic curve"},
        {{.code = Code::weight_count_mismatch, .value = 3, .lower = 4},
         "3 weights were found for 4 control points; there must be one for each point, or none at all"},
        {{.code = Code::knot_not_finite, .index = 7}, "knot 7 is not a finite number; every knot must be finite"},
        {{.code = Code::point_not_finite, .index = 2},
         "control point 2 has a coordinate that is not finite; every coordinate must be finite"},
        {{.code = Code::weight_not_finite, .index = 0},
         "weight 0 is not a finite number; every weight must be finite and above 0"},
        {{.code = Code::weight_not_positive, .index = 3, .value = -1}, "weight 3 is -1; every weight must be above 0"},
        {{.code = Code::knot_decreasing, .index = 5, .value = 0.25, .lower = 0.5},
         "knot 5 is 0.25, less than knot 4, which is 0.5; knots must not decrease"},
        {{.code = Code::multiplicity_too_high, .index = 4, .value = 5, .upper = 3},
         "knot 4 occurs 5 times; at most 3 equal knots are allowed there"},
        {{.code = Code::domain_empty, .value = 0.1},
         "the domain begins and ends at 0.1; its end must be above its beginning"},
        {{.code = Code::parameter_not_finite}, "the parameter is not a finite number; it must be finite"},
        {{.code = Code::parameter_outside_domain, .value = 1.5, .lower = 0, .upper = 1},
         "the parameter 1.5 is outside the domain; it must be from 0 to 1"},
        {{.code = Code::multiplicity_full, .value = 0.5, .upper = 3},
         "the knot 0.5 cannot be inserted that often; at most 3 equal knots are allowed there"},
        {{.code = Code::knot_index_out_of_range, .index = 11, .upper = 10}, "there is no knot 11; the last one is 10"},
        {{.code = Code::point_index_out_of_range, .index = 7, .upper = 6},
         "there is no control point 7; the last one is 6"},
        {{.code = Code::knot_not_removable, .index = 2},
         "knot 2 cannot be removed; there would be too few control points or no domain"},
        {{.code = Code::kind_not_possible},
         "these knots need other counts; Bézier takes degree + 1 points, piecewise Bézier k · degree + 1"},
        {{.code = Code::curve_not_polynomial_piece},
         "the curve is not one Bézier piece; it must have degree + 1 equal knots at both ends and no others"},
    };
    std::set<CurveErrorCode> seen;
    for (const auto& [error, sentence] : expectations) {
        EXPECT_EQ(describe(error), sentence);
        seen.insert(error.code);
    }
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(CurveErrorCode::curve_not_polynomial_piece) + 1);
}

TEST(CurveError, prints_numbers_in_the_fewest_digits_that_keep_them) {
    const double third = 1.0 / 3.0;
    EXPECT_EQ(
        describe({.code = CurveErrorCode::parameter_outside_domain, .value = 1e300, .lower = third, .upper = 1e-9}),
        "the parameter 1e+300 is outside the domain; it must be from 0.3333333333333333 to 1e-09");
}

}  // namespace batten::core
