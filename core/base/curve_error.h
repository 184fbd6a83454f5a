/// Why a curve could not be made or changed, as a closed code and as a sentence.
#pragma once

#include <cstddef>
#include <string>
#include <tl/expected.hpp>

namespace batten::core {

/// Every way in which data or an edit can be refused.
enum class CurveErrorCode {
    degree_out_of_range,         ///< value = degree found
    too_few_points,              ///< value = count found, lower = least count
    knot_count_mismatch,         ///< value = count found, lower = count expected
    weight_count_mismatch,       ///< value = count found, lower = count expected
    knot_not_finite,             ///< index = knot
    point_not_finite,            ///< index = point
    weight_not_finite,           ///< index = weight
    weight_not_positive,         ///< index = weight, value = weight found
    knot_decreasing,             ///< index = the smaller later knot, value = it, lower = the knot before
    multiplicity_too_high,       ///< index = first such knot, value = multiplicity found, upper = most allowed
    knots_too_far_apart,         ///< lower, upper = the first and the last knot
    domain_empty,                ///< value = the one value that the domain consists of
    parameter_not_finite,        ///< a typed parameter is NaN or infinite
    parameter_outside_domain,    ///< value = parameter, [lower, upper] = domain
    multiplicity_full,           ///< value = knot, upper = its multiplicity, the most allowed
    knot_index_out_of_range,     ///< index = asked for, upper = last allowed
    point_index_out_of_range,    ///< index = asked for, upper = last allowed
    knot_not_removable,          ///< index = knot; removing it would leave too few points or no domain
    kind_not_possible,           ///< the knots cannot be made of the kind asked for
    length_not_positive,         ///< value = radius, axis or other length found
    range_empty,                 ///< the range wanted is from lower to upper
    angle_out_of_range,          ///< value = angle in degrees, lower, upper = least and most allowed; 0 is not
    points_coincide,             ///< index = point, value = index of the other one
    points_collinear,            ///< three points that should make a triangle
    ends_apart,                  ///< value = distance of the ends, upper = most that counts as meeting
    degree_unsuitable,           ///< value = degree found, lower = the one degree that is possible
    curve_not_closed,            ///< the ends do not meet, or the curve is torn
    curve_not_uniform_cubic,     ///< degree 3 and equally spaced, unclamped knots are needed
    curve_rational,              ///< the operation is for equal weights only
    data_points_too_few,         ///< value = count of points to go through or near, lower = least count
    data_point_not_finite,       ///< index = point to go through or near
    parameter_count_mismatch,    ///< value = count of parameters given, lower = count expected
    parameters_not_increasing,   ///< index = a parameter given that is not above the one before it
    degree_too_low,              ///< value = degree, lower = least degree for what is asked
    vector_not_finite,           ///< a tangent or other vector is NaN or infinite
    equations_singular,          ///< points and parameters do not determine one curve
    control_points_too_many,     ///< value = count asked for, upper = most that the points can determine
    smoothing_negative,          ///< value = smoothing weight
    points_pinned,               ///< value = parameter at which all control points that act are pinned
    tangent_not_free,            ///< value = parameter at which no control points can set the tangent
    curve_stands_still,          ///< value = parameter without a direction
    curve_has_corner,            ///< value = parameter at which the direction jumps or the curve is torn
    offset_too_far,              ///< value = parameter, lower = radius of curvature there, upper = distance asked for
    leg_vanishes,                ///< index = leg of a polygon that an offset would shrink to nothing
    tolerance_not_positive,      ///< value = tolerance
    tolerance_not_reached,       ///< value = tolerance, lower = least error reached
    knot_not_found,              ///< value = parameter that is no knot inside the domain
    knots_coincide,              ///< index = knot that would become equal to the one before it, value = their value
    curve_periodic,              ///< the operation is for curves with ends only
    parameter_at_end,            ///< value = parameter, [lower, upper] = domain; strictly inside is needed
    deviation_too_large,         ///< value = deviation that the edit would make, upper = tolerance
    curve_not_polynomial_piece,  ///< the operation is for one Bézier piece only
    curve_closed,                ///< the ends of an open curve meet, so that it has none to go on from
    extension_too_far,           ///< value = length asked for, upper = most that keeps every weight positive
    outer_knots_too_far,         ///< value = how far knots would lie outside, upper = most that keeps weights positive
    joint_turns_back,            ///< two curves run back along each other where they should meet smoothly
    share_out_of_range,          ///< value = share of the way along a leg, which must be between its ends
    legs_unequal,                ///< value, upper = lengths of two legs that should be equal
    piece_not_bezier,            ///< value = parameter; the knots around it must occur degree times
    map_not_finite,              ///< a number of a map of the plane is NaN or infinite
    map_singular,                ///< a map takes the plane onto a line or a point
    point_beyond_horizon,        ///< index = point, value = its weight after a projective map, 0 or less
    fit_point_index_out_of_range,  ///< index = asked for, upper = last allowed
    tension_not_positive,          ///< value = tension found
    ends_meet,                     ///< two ends are one point where a curve shall lie between them
    end_stands_still,              ///< an end without the direction or curvature that is needed
    fillet_too_large,              ///< value = radius, upper = greatest radius of an arc that touches both sides
    fillet_not_possible,           ///< value = radius, lower, upper = least and greatest radius of an arc that touches
    no_fillet,                     ///< no arc touches both curves
    no_corner,                     ///< curves that do not meet where a corner is needed
    chamfer_too_long,              ///< value = distance from the corner, upper = most that there is
    nothing_crosses,               ///< nothing bounds the part that shall go
    other_not_reached,             ///< a curve that is extended does not come to the other one
    shapes_not_decided,            ///< curves run along each other too closely to tell what lies inside
    shape_vanishes,                ///< nothing is left of a shape; value = the distance of an offset
    stroke_too_short,              ///< value = how many pixels a stroke extends, lower = least extent
    not_computable                 ///< numbers on the way are beyond what doubles can hold
};

/// One refusal: the code, the offending item, and the numbers that the sentence needs (see CurveErrorCode).
struct CurveError {
    CurveErrorCode code;
    std::size_t index = 0;
    double value = 0.0;
    double lower = 0.0;
    double upper = 0.0;

    bool operator==(const CurveError&) const = default;
};

/// A value, or the reason why there is none.
template <class T>
using Result = tl::expected<T, CurveError>;

/// The refusal `error` as the result of any operation.
inline tl::unexpected<CurveError> refuse(CurveError error) {
    return tl::unexpected(error);
}

/// The refusal `error` with numbers that were computed; not_computable where one of them is not finite.
tl::unexpected<CurveError> refuse_computed(CurveError error);

/// The English template of the sentence about `error`, with the places {index}, {previous} (the index before), {value},
/// {lower}, {upper}, {min_degree} and {max_degree} where it needs them. The plural form is that of the count it speaks
/// of.
const char* sentence_template(const CurveError& error);

/// One sentence: what was found, where, and what is allowed.
/// "knot 5 is 0.25, less than knot 4, which is 0.5; knots must not decrease".
std::string describe(const CurveError& error);

/// The same by another `pattern` with these places, as of a translation.
std::string describe_by(const char* pattern, const CurveError& error);

}  // namespace batten::core
