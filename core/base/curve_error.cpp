#include "core/base/curve_error.h"

#include "core/base/number_text.h"
#include "core/curve/knot_vector.h"

namespace batten::core {

namespace {

std::string text(double value) {
    return shortest_text(value);
}

std::string text(std::size_t index) {
    return std::to_string(index);
}

std::string item(const char* noun, const CurveError& error) {
    return std::string(noun) + " " + text(error.index);
}

// "one knot", "7 knots"
std::string count(double number, const std::string& noun) {
    return number == 1.0 ? std::string("one ") + noun : text(number) + " " + noun + "s";
}

std::string were_found(double number, const std::string& noun) {
    return count(number, noun) + (number == 1.0 ? " was found" : " were found");
}

std::string is_out_of_range(const char* noun, const CurveError& error) {
    return std::string("there is no ") + item(noun, error) + "; the last one is " + text(error.upper);
}

std::string too_few_points(const CurveError& error) {
    return were_found(error.value, "control point") + "; at least " + text(error.lower) + " are needed";
}

std::string knot_count_mismatch(const CurveError& error) {
    return were_found(error.value, "knot") + "; " + text(error.lower) +
           " are needed, which is points + degree + 1, or points + 1 for a periodic curve";
}

std::string weight_count_mismatch(const CurveError& error) {
    return were_found(error.value, "weight") + " for " + count(error.lower, "control point") +
           "; there must be one for each point, or none at all";
}

std::string knot_decreasing(const CurveError& error) {
    return item("knot", error) + " is " + text(error.value) + ", less than knot " + text(error.index - 1) +
           ", which is " + text(error.lower) + "; knots must not decrease";
}

std::string most_equal_knots(const CurveError& error) {
    return "; at most " + text(error.upper) + " equal knots are allowed there";
}

std::string parameter_outside_domain(const CurveError& error) {
    return "the parameter " + text(error.value) + " is outside the domain; it must be from " + text(error.lower) +
           " to " + text(error.upper);
}

}  // namespace

std::string describe(const CurveError& error) {
    switch (error.code) {
        case CurveErrorCode::degree_out_of_range:
            return "the degree is " + text(error.value) + "; it must be from " + std::to_string(min_degree) + " to " +
                   std::to_string(max_degree);
        case CurveErrorCode::too_few_points:
            return too_few_points(error);
        case CurveErrorCode::knot_count_mismatch:
            return knot_count_mismatch(error);
        case CurveErrorCode::weight_count_mismatch:
            return weight_count_mismatch(error);
        case CurveErrorCode::knot_not_finite:
            return item("knot", error) + " is not a finite number; every knot must be finite";
        case CurveErrorCode::point_not_finite:
            return item("control point", error) +
                   " has a coordinate that is not finite; every coordinate must be finite";
        case CurveErrorCode::weight_not_finite:
            return item("weight", error) + " is not a finite number; every weight must be finite and above 0";
        case CurveErrorCode::weight_not_positive:
            return item("weight", error) + " is " + text(error.value) + "; every weight must be above 0";
        case CurveErrorCode::knot_decreasing:
            return knot_decreasing(error);
        case CurveErrorCode::multiplicity_too_high:
            return item("knot", error) + " occurs " + text(error.value) + " times" + most_equal_knots(error);
        case CurveErrorCode::domain_empty:
            return "the domain begins and ends at " + text(error.value) + "; its end must be above its beginning";
        case CurveErrorCode::parameter_not_finite:
            return "the parameter is not a finite number; it must be finite";
        case CurveErrorCode::parameter_outside_domain:
            return parameter_outside_domain(error);
        case CurveErrorCode::multiplicity_full:
            return "the knot " + text(error.value) + " cannot be inserted that often" + most_equal_knots(error);
        case CurveErrorCode::knot_index_out_of_range:
            return is_out_of_range("knot", error);
        case CurveErrorCode::point_index_out_of_range:
            return is_out_of_range("control point", error);
        case CurveErrorCode::knot_not_removable:
            return item("knot", error) + " cannot be removed; there would be too few control points or no domain";
        case CurveErrorCode::kind_not_possible:
            return "these knots need other counts; Bézier takes degree + 1 points, piecewise Bézier k · degree + 1";
        case CurveErrorCode::length_not_positive:
            return "a length is " + text(error.value) + "; radii, axes and other lengths must be above 0";
        case CurveErrorCode::range_empty:
            return "the range begins at " + text(error.lower) + " and ends at " + text(error.upper) +
                   "; its end must be above its beginning";
        case CurveErrorCode::angle_out_of_range:
            return "the angle is " + text(error.value) + " degrees; it must be from " + text(error.lower) + " to " +
                   text(error.upper) + " and not 0";
        case CurveErrorCode::points_coincide:
            return item("point", error) + " lies on point " + text(error.value) + "; the two must differ";
        case CurveErrorCode::points_collinear:
            return "the three points lie on one line; they must make a triangle";
        case CurveErrorCode::ends_apart:
            return "the ends of the curve are " + text(error.value) + " apart; at most " + text(error.upper) +
                   " counts as meeting";
        case CurveErrorCode::degree_unsuitable:
            return "the degree is " + text(error.value) + "; this is for degree " + text(error.lower) + " only";
        case CurveErrorCode::curve_not_closed:
            return "the curve is not closed; its ends must meet and it must have no gaps";
        case CurveErrorCode::curve_not_uniform_cubic:
            return "the curve is not a uniform cubic; it must have degree 3 and equally spaced knots, without clamped "
                   "ends";
        case CurveErrorCode::curve_rational:
            return "the curve is rational; all its weights must be equal";
        case CurveErrorCode::data_points_too_few:
            return were_found(error.value, "point") + "; at least " + text(error.lower) + " are needed";
        case CurveErrorCode::data_point_not_finite:
            return item("point", error) + " has a coordinate that is not finite; every coordinate must be finite";
        case CurveErrorCode::parameter_count_mismatch:
            return were_found(error.value, "parameter") + "; " + text(error.lower) +
                   " are needed, one for each point, and one more for the way back to the first point of a closed "
                   "curve";
        case CurveErrorCode::parameters_not_increasing:
            return item("parameter", error) +
                   " is not above the one before it; parameters must be finite and increase from point to point";
        case CurveErrorCode::degree_too_low:
            return "the degree is " + text(error.value) + "; it must be at least " + text(error.lower) + " here";
        case CurveErrorCode::vector_not_finite:
            return "a vector has a component that is not finite; every component must be finite";
        case CurveErrorCode::equations_singular:
            return "these points and parameters do not determine one curve; another degree or parametrization may";
        case CurveErrorCode::control_points_too_many:
            return count(error.value, "control point") + " were asked for; at most " + text(error.upper) +
                   " can be determined by these points";
        case CurveErrorCode::smoothing_negative:
            return "the smoothing weight is " + text(error.value) + "; it must be 0 or above, and finite";
        case CurveErrorCode::tangent_not_free:
            return "the tangent at " + text(error.value) +
                   " does not depend on the control points; another parameter must be taken";
        case CurveErrorCode::curve_stands_still:
            return "the curve has no direction at " + text(error.value) + "; its speed must not be 0";
        case CurveErrorCode::curve_has_corner:
            return "the curve has a corner or a gap at " + text(error.value) + "; its direction must not jump";
        case CurveErrorCode::offset_too_far:
            return "the distance is " + text(error.upper) + ", but the radius of curvature at " + text(error.value) +
                   " is " + text(error.lower) + "; towards the inside the distance must be less";
        case CurveErrorCode::leg_vanishes:
            return item("leg", error) + " of the polygon would vanish or turn round; the distance must be less";
        case CurveErrorCode::tolerance_not_positive:
            return "the tolerance is " + text(error.value) + "; it must be above 0 and finite";
        case CurveErrorCode::tolerance_not_reached:
            return "the tolerance " + text(error.value) + " was not reached; the least error is " + text(error.lower);
        case CurveErrorCode::knot_not_found:
            return "there is no knot " + text(error.value) + " inside the domain; one of its knots is needed";
        case CurveErrorCode::knots_coincide:
            return item("knot", error) + " would become " + text(error.value) +
                   ", equal to the one before it; different knots must stay different";
        case CurveErrorCode::curve_periodic:
            return "the curve is periodic and has no ends; it must be an open one";
        case CurveErrorCode::parameter_at_end:
            return "the parameter " + text(error.value) + " is an end of the domain; it must be above " +
                   text(error.lower) + " and below " + text(error.upper);
        case CurveErrorCode::deviation_too_large:
            return "the curve would deviate by " + text(error.value) + "; at most " + text(error.upper) + " is allowed";
        case CurveErrorCode::curve_not_polynomial_piece:
            return "the curve is not one Bézier piece; it must have degree + 1 equal knots at both ends and no others";
    }
    return "the curve is not valid";
}

}  // namespace batten::core
