/// Why a curve could not be made or changed, as a closed code and as a sentence.
#pragma once

#include <cstddef>
#include <string>
#include <tl/expected.hpp>

namespace batten::core {

/// Every way in which data or an edit can be refused.
enum class CurveErrorCode {
    degree_out_of_range,        ///< value = degree found
    too_few_points,             ///< value = count found, lower = least count
    knot_count_mismatch,        ///< value = count found, lower = count expected
    weight_count_mismatch,      ///< value = count found, lower = count expected
    knot_not_finite,            ///< index = knot
    point_not_finite,           ///< index = point
    weight_not_finite,          ///< index = weight
    weight_not_positive,        ///< index = weight, value = weight found
    knot_decreasing,            ///< index = the smaller later knot, value = it, lower = the knot before
    multiplicity_too_high,      ///< index = first such knot, value = multiplicity found, upper = most allowed
    domain_empty,               ///< value = the one value that the domain consists of
    parameter_not_finite,       ///< a typed parameter is NaN or infinite
    parameter_outside_domain,   ///< value = parameter, [lower, upper] = domain
    multiplicity_full,          ///< value = knot, upper = its multiplicity, the most allowed
    knot_index_out_of_range,    ///< index = asked for, upper = last allowed
    point_index_out_of_range,   ///< index = asked for, upper = last allowed
    knot_not_removable,         ///< index = knot; removing it would leave too few points or no domain
    kind_not_possible,          ///< the knots cannot be made of the kind asked for
    curve_not_polynomial_piece  ///< the operation is for one Bézier piece only
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

/// One sentence: what was found, where, and what is allowed.
/// "knot 5 is 0.25, less than knot 4, which is 0.5; knots must not decrease".
std::string describe(const CurveError& error);

}  // namespace batten::core
