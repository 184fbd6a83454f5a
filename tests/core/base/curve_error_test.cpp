#include "core/base/curve_error.h"

#include <gtest/gtest.h>

#include <cmath>
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
        {{.code = Code::knots_too_far_apart, .lower = -1e308, .upper = 1e308},
         "the knots begin at -1e+308 and end at 1e+308; their distance is too large for a number, also where the "
         "period "
         "is repeated"},
        {{.code = Code::domain_empty, .value = 0.1},
         "the domain begins and ends at 0.1; its end must be above its beginning"},
        {{.code = Code::parameter_not_finite}, "the parameter is not a finite number; it must be finite"},
        {{.code = Code::parameter_outside_domain, .value = 1.5, .lower = 0, .upper = 1},
         "the parameter 1.5 is outside the domain; it must be from 0 to 1"},
        {{.code = Code::multiplicity_full, .value = 0.5, .upper = 3},
         "knot 0.5 cannot be inserted that many times; at most 3 equal knots are allowed there"},
        {{.code = Code::knot_index_out_of_range, .index = 11, .upper = 10}, "there is no knot 11; the last one is 10"},
        {{.code = Code::point_index_out_of_range, .index = 7, .upper = 6},
         "there is no control point 7; the last one is 6"},
        {{.code = Code::knot_not_removable, .index = 2},
         "knot 2 cannot be removed; there would be too few control points or no domain"},
        {{.code = Code::kind_not_possible},
         "these knots need another number of points; Bézier takes degree + 1, piecewise Bézier k · degree + 1"},
        {{.code = Code::length_not_positive, .value = -2},
         "a length is -2; radii, axes and other lengths must be above 0"},
        {{.code = Code::range_empty, .lower = 1, .upper = 0.5},
         "the range begins at 1 and ends at 0.5; its end must be above its beginning"},
        {{.code = Code::angle_out_of_range, .value = 400, .lower = -360, .upper = 360},
         "the angle is 400 degrees; it must be from -360 to 360 and not 0"},
        {{.code = Code::points_coincide, .index = 3, .value = 2}, "point 3 lies on point 2; the two must differ"},
        {{.code = Code::points_collinear}, "the three points lie on one line; they must make a triangle"},
        {{.code = Code::ends_apart, .value = 0.5, .upper = 1e-9},
         "the ends of the curve are 0.5 apart; at most 1e-09 counts as meeting"},
        {{.code = Code::degree_unsuitable, .value = 3, .lower = 2}, "the degree is 3; this is for degree 2 only"},
        {{.code = Code::curve_not_closed}, "the curve is not closed; its ends must meet and it must have no gaps"},
        {{.code = Code::curve_not_uniform_cubic},
         "the curve is not a uniform cubic; it must have degree 3 and equally spaced knots, without clamped ends"},
        {{.code = Code::curve_rational}, "the curve is rational; all its weights must be equal"},
        {{.code = Code::data_points_too_few, .value = 3, .lower = 4}, "3 points were found; at least 4 are needed"},
        {{.code = Code::data_point_not_finite, .index = 2},
         "point 2 has a coordinate that is not finite; every coordinate must be finite"},
        {{.code = Code::parameter_count_mismatch, .value = 3, .lower = 5},
         "3 parameters were found; 5 are needed, one for each point, and one more for the way back to the first point "
         "of a closed curve"},
        {{.code = Code::parameters_not_increasing, .index = 4},
         "parameter 4 is not above the one before it; parameters must be finite and increase from point to point"},
        {{.code = Code::degree_too_low, .value = 2, .lower = 3}, "the degree is 2; it must be at least 3 here"},
        {{.code = Code::vector_not_finite},
         "a vector has a component that is not finite; every component must be finite"},
        {{.code = Code::equations_singular},
         "these points and parameters do not determine one curve; another degree or parametrization may"},
        {{.code = Code::control_points_too_many, .value = 9, .upper = 8},
         "9 control points were asked for; at most 8 can be determined by these points"},
        {{.code = Code::smoothing_negative, .value = -1},
         "the smoothing weight is -1; it must be 0 or above, and finite"},
        {{.code = Code::points_pinned, .value = 0.5},
         "all control points that act at 0.5 are pinned; unpin one of them first"},
        {{.code = Code::tangent_not_free, .value = 0.5},
         "the tangent at 0.5 does not depend on the control points; another parameter must be taken"},
        {{.code = Code::curve_stands_still, .value = 0.25},
         "the curve has no direction at 0.25; its speed must not be 0"},
        {{.code = Code::curve_has_corner, .value = 0.5},
         "the curve has a corner or a gap at 0.5; its direction must not jump"},
        {{.code = Code::offset_too_far, .value = 0.5, .lower = 1.5, .upper = 2},
         "the distance is 2, but the radius of curvature at 0.5 is 1.5; toward the inside the distance must be less"},
        {{.code = Code::leg_vanishes, .index = 2},
         "leg 2 of the polygon would vanish or turn around; the distance must be less"},
        {{.code = Code::tolerance_not_positive, .value = 0}, "the tolerance is 0; it must be above 0 and finite"},
        {{.code = Code::tolerance_not_reached, .value = 1e-20, .lower = 1e-16},
         "the tolerance 1e-20 was not reached; the least error is 1e-16"},
        {{.code = Code::knot_not_found, .value = 0.3},
         "there is no knot 0.3 inside the domain; one of its knots is needed"},
        {{.code = Code::knots_coincide, .index = 5, .value = 1e9},
         "knot 5 would become 1e+09, equal to the one before it; different knots must stay different"},
        {{.code = Code::curve_periodic}, "the curve is periodic and has no ends; it must be an open one"},
        {{.code = Code::parameter_at_end, .value = 1, .lower = 0, .upper = 1},
         "the parameter 1 is an end of the domain; it must be above 0 and below 1"},
        {{.code = Code::deviation_too_large, .value = 0.25, .upper = 0.01},
         "the curve would deviate by 0.25; at most 0.01 is allowed"},
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

TEST(CurveError, says_that_a_stroke_is_a_dot) {
    EXPECT_EQ(describe({.code = CurveErrorCode::stroke_too_short, .value = 1.5, .lower = 2}),
              "the stroke is too short: it extends over 1.5 px and must extend over at least 2");
}

TEST(CurveError, says_what_the_weights_of_a_leg_or_piece_lack) {
    using Code = CurveErrorCode;
    EXPECT_EQ(describe({.code = Code::share_out_of_range, .value = 1.5}),
              "the share of the leg is 1.5; it must be above 0 and below 1");
    EXPECT_EQ(describe({.code = Code::legs_unequal, .value = 3, .upper = 2}),
              "the legs of the piece are 3 and 2 long; they must be equally long for an arc of a circle");
    EXPECT_EQ(describe({.code = Code::piece_not_bezier, .value = 0.5}),
              "the piece at 0.5 has knots that occur only once; an arc of its own needs each of them twice");
}

TEST(CurveError, says_what_joints_need) {
    using Code = CurveErrorCode;
    EXPECT_EQ(describe({.code = Code::tension_not_positive, .value = -1}), "the tension is -1; it must be above 0");
    EXPECT_EQ(describe({.code = Code::fillet_too_large, .value = 3, .upper = 1.5}),
              "the radius 3 is too large for an arc that touches both sides here; 1.5 is the most");
    EXPECT_EQ(describe({.code = Code::fillet_not_possible, .value = 3, .lower = 0.5, .upper = 1.5}),
              "no arc of radius 3 touches both sides here; a radius from 0.5 to 1.5 does");
    EXPECT_EQ(describe({.code = Code::chamfer_too_long, .value = 3, .upper = 1.5}),
              "the distance from the corner is 3; the side is only 1.5 long");
}

TEST(CurveError, tells_no_computed_number_that_is_not_finite) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    using Code = CurveErrorCode;
    const CurveError apart{.code = Code::ends_apart, .value = 0.5, .upper = 1e-9};
    EXPECT_EQ(refuse_computed(apart).value(), apart);
    for (const CurveError& error : {CurveError{.code = Code::ends_apart, .value = infinity, .upper = 1e-9},
                                    CurveError{.code = Code::tolerance_not_reached, .value = 1.0, .lower = -infinity},
                                    CurveError{.code = Code::outer_knots_too_far, .value = 1.0, .upper = std::nan("")}})
        EXPECT_EQ(describe(refuse_computed(error).value()),
                  "the result cannot be computed: points, weights or knots are too far apart, too large or too small");
}

TEST(CurveError, prints_numbers_in_the_fewest_digits_that_keep_them) {
    const double third = 1.0 / 3.0;
    EXPECT_EQ(
        describe({.code = CurveErrorCode::parameter_outside_domain, .value = 1e300, .lower = third, .upper = 1e-9}),
        "the parameter 1e+300 is outside the domain; it must be from 0.3333333333333333 to 1e-09");
}

}  // namespace batten::core
