#include "core/base/curve_error.h"

#include <array>
#include <cassert>
#include <cmath>

#include "core/base/degree_range.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"

namespace batten::core {

namespace {

using Code = CurveErrorCode;

struct Template {
    Code code;
    const char* text;
    const char* for_one = nullptr;  ///< where {value} is a count and it is 1
};

constexpr std::array templates{
    Template{Code::degree_out_of_range, "the degree is {value}; it must be from {min_degree} to {max_degree}"},
    Template{Code::too_few_points, "{value} control points were found; at least {lower} are needed",
             "one control point was found; at least {lower} are needed"},
    Template{Code::knot_count_mismatch,
             "{value} knots were found; {lower} are needed, which is points + degree + 1, or points + 1 for a periodic "
             "curve",
             "one knot was found; {lower} are needed, which is points + degree + 1, or points + 1 for a periodic "
             "curve"},
    Template{Code::weight_count_mismatch,
             "{value} weights were found for {lower} control points; there must be one for each point, or none at all",
             "one weight was found for {lower} control points; there must be one for each point, or none at all"},
    Template{Code::knot_not_finite, "knot {index} is not a finite number; every knot must be finite"},
    Template{Code::point_not_finite,
             "control point {index} has a coordinate that is not finite; every coordinate must be finite"},
    Template{Code::weight_not_finite, "weight {index} is not a finite number; every weight must be finite and above 0"},
    Template{Code::weight_not_positive, "weight {index} is {value}; every weight must be above 0"},
    Template{Code::knot_decreasing,
             "knot {index} is {value}, less than knot {previous}, which is {lower}; knots must not decrease"},
    Template{Code::multiplicity_too_high,
             "knot {index} occurs {value} times; at most {upper} equal knots are allowed there"},
    Template{Code::knots_too_far_apart,
             "the knots begin at {lower} and end at {upper}; their distance is too large for a number, also where the "
             "period is repeated"},
    Template{Code::domain_empty, "the domain begins and ends at {value}; its end must be above its beginning"},
    Template{Code::parameter_not_finite, "the parameter is not a finite number; it must be finite"},
    Template{Code::parameter_outside_domain,
             "the parameter {value} is outside the domain; it must be from {lower} to {upper}"},
    Template{Code::multiplicity_full,
             "knot {value} cannot be inserted that many times; at most {upper} equal knots are allowed there"},
    Template{Code::knot_index_out_of_range, "there is no knot {index}; the last one is {upper}"},
    Template{Code::point_index_out_of_range, "there is no control point {index}; the last one is {upper}"},
    Template{Code::knot_not_removable,
             "knot {index} cannot be removed; there would be too few control points or no domain"},
    Template{Code::kind_not_possible,
             "these knots need another number of points; Bézier takes degree + 1, piecewise Bézier k · degree + 1"},
    Template{Code::length_not_positive, "a length is {value}; radii, axes and other lengths must be above 0"},
    Template{Code::range_empty, "the range begins at {lower} and ends at {upper}; its end must be above its beginning"},
    Template{Code::angle_out_of_range, "the angle is {value} degrees; it must be from {lower} to {upper} and not 0"},
    Template{Code::points_coincide, "point {index} lies on point {value}; the two must differ"},
    Template{Code::points_collinear, "the three points lie on one line; they must make a triangle"},
    Template{Code::ends_apart, "the ends of the curve are {value} apart; at most {upper} counts as meeting"},
    Template{Code::degree_unsuitable, "the degree is {value}; this is for degree {lower} only"},
    Template{Code::curve_not_closed, "the curve is not closed; its ends must meet and it must have no gaps"},
    Template{Code::curve_not_uniform_cubic,
             "the curve is not a uniform cubic; it must have degree 3 and equally spaced knots, without clamped ends"},
    Template{Code::curve_rational, "the curve is rational; all its weights must be equal"},
    Template{Code::data_points_too_few, "{value} points were found; at least {lower} are needed",
             "one point was found; at least {lower} are needed"},
    Template{Code::data_point_not_finite,
             "point {index} has a coordinate that is not finite; every coordinate must be finite"},
    Template{Code::parameter_count_mismatch,
             "{value} parameters were found; {lower} are needed, one for each point, and one more for the way back to "
             "the first point of a closed curve",
             "one parameter was found; {lower} are needed, one for each point, and one more for the way back to the "
             "first point of a closed curve"},
    Template{Code::parameters_not_increasing,
             "parameter {index} is not above the one before it; parameters must be finite and increase from point to "
             "point"},
    Template{Code::degree_too_low, "the degree is {value}; it must be at least {lower} here"},
    Template{Code::vector_not_finite, "a vector has a component that is not finite; every component must be finite"},
    Template{Code::equations_singular,
             "these points and parameters do not determine one curve; another degree or parametrization may"},
    Template{Code::control_points_too_many,
             "{value} control points were asked for; at most {upper} can be determined by these points",
             "one control point was asked for; at most {upper} can be determined by these points"},
    Template{Code::smoothing_negative, "the smoothing weight is {value}; it must be 0 or above, and finite"},
    Template{Code::points_pinned, "all control points that act at {value} are pinned; unpin one of them first"},
    Template{Code::tangent_not_free,
             "the tangent at {value} does not depend on the control points; another parameter must be taken"},
    Template{Code::curve_stands_still, "the curve has no direction at {value}; its speed must not be 0"},
    Template{Code::curve_has_corner, "the curve has a corner or a gap at {value}; its direction must not jump"},
    Template{Code::offset_too_far,
             "the distance is {upper}, but the radius of curvature at {value} is {lower}; toward the inside the "
             "distance must be less"},
    Template{Code::leg_vanishes, "leg {index} of the polygon would vanish or turn around; the distance must be less"},
    Template{Code::tolerance_not_positive, "the tolerance is {value}; it must be above 0 and finite"},
    Template{Code::tolerance_not_reached, "the tolerance {value} was not reached; the least error is {lower}"},
    Template{Code::knot_not_found, "there is no knot {value} inside the domain; one of its knots is needed"},
    Template{Code::knots_coincide,
             "knot {index} would become {value}, equal to the one before it; different knots must stay different"},
    Template{Code::curve_periodic, "the curve is periodic and has no ends; it must be an open one"},
    Template{Code::parameter_at_end,
             "the parameter {value} is an end of the domain; it must be above {lower} and below {upper}"},
    Template{Code::deviation_too_large, "the curve would deviate by {value}; at most {upper} is allowed"},
    Template{Code::curve_not_polynomial_piece,
             "the curve is not one Bézier piece; it must have degree + 1 equal knots at both ends and no others"},
    Template{Code::curve_closed, "the ends of the curve meet; only a curve that is open there can go on"},
    Template{Code::extension_too_far,
             "the curve cannot go on by {value}, because a weight would become 0 or a number too large before; at most "
             "{upper} is possible"},
    Template{Code::outer_knots_too_far,
             "the knots outside would have to reach {value} beyond the end, but a weight would become 0 or a number "
             "too large "
             "before; at most {upper} is possible"},
    Template{Code::joint_turns_back,
             "one curve runs straight back along the other where they meet; a smooth joint needs a turn of less than "
             "180 degrees"},
    Template{Code::share_out_of_range, "the share of the leg is {value}; it must be above 0 and below 1"},
    Template{Code::legs_unequal,
             "the legs of the piece are {value} and {upper} long; they must be equally long for an arc of a circle"},
    Template{Code::piece_not_bezier,
             "the piece at {value} has knots that occur only once; an arc of its own needs each of them twice"},
    Template{Code::map_not_finite, "a number of the map is not finite; every number must be finite"},
    Template{Code::map_singular,
             "the map takes the plane onto a line or a point; it must have a determinant other than 0"},
    Template{Code::point_beyond_horizon,
             "the map takes control point {index} to infinity or beyond, where its weight would be {value}; every "
             "weight must stay above 0"},
    Template{Code::fit_point_index_out_of_range, "there is no fit point {index}; the last one is {upper}"},
    Template{Code::tension_not_positive, "the tension is {value}; it must be above 0"},
    Template{Code::ends_meet, "the two ends are one point; a curve between them needs some room"},
    Template{Code::end_stands_still,
             "an end has no direction or no curvature to go on with; a smooth joint needs a curve that does not stand "
             "still there"},
    Template{Code::fillet_too_large,
             "the radius {value} is too large for an arc that touches both sides here; {upper} is the most"},
    Template{Code::fillet_not_possible,
             "no arc of radius {value} touches both sides here; a radius from {lower} to {upper} does"},
    Template{Code::no_fillet, "no arc was found that touches both sides here"},
    Template{Code::no_corner, "the curves do not meet here; a chamfer needs a corner"},
    Template{Code::chamfer_too_long, "the distance from the corner is {value}; the side is only {upper} long"},
    Template{Code::nothing_crosses,
             "nothing crosses the curve here; what goes must be bounded by a crossing with another curve or with "
             "itself"},
    Template{Code::other_not_reached, "the curve does not reach the other one, however far it is extended"},
    Template{Code::shapes_not_decided,
             "the curves run along each other too closely to tell what is inside; they must coincide or be farther "
             "apart"},
    Template{Code::shape_vanishes,
             "nothing is left at the distance {value}; it must be less than half of the width of the shape"},
    Template{Code::stroke_too_short,
             "the stroke is too short: it extends over {value} px and must extend over at least {lower}"},
    Template{Code::not_computable,
             "the result cannot be computed: points, weights or knots are too far apart, too large or too small"},
};

constexpr bool is_in_order() {
    for (std::size_t i = 0; i < templates.size(); ++i)
        if (static_cast<std::size_t>(templates[i].code) != i) return false;
    return true;
}
static_assert(is_in_order(), "a template for each code, in the order of the codes");

}  // namespace

tl::unexpected<CurveError> refuse_computed(CurveError error) {
    const bool is_known = std::isfinite(error.value) && std::isfinite(error.lower) && std::isfinite(error.upper);
    return refuse(is_known ? error : CurveError{.code = CurveErrorCode::not_computable});
}

const char* sentence_template(const CurveError& error) {
    assert(static_cast<std::size_t>(error.code) < templates.size());
    const Template& entry = templates[static_cast<std::size_t>(error.code)];
    return entry.for_one != nullptr && error.value == 1.0 ? entry.for_one : entry.text;
}

std::string describe(const CurveError& error) {
    return describe_by(sentence_template(error), error);
}

std::string describe_by(const char* pattern, const CurveError& error) {
    return filled_as_needed(pattern, {{"index", error.index},
                                      {"previous", error.index - 1},
                                      {"value", shortest_text(error.value)},
                                      {"lower", shortest_text(error.lower)},
                                      {"upper", shortest_text(error.upper)},
                                      {"min_degree", min_degree},
                                      {"max_degree", max_degree}});
}

}  // namespace batten::core
