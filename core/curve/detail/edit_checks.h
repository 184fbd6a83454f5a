/// The refusals that many edits share.
#pragma once

#include <cmath>

#include "core/curve/curve.h"

namespace batten::core {

/// Error: knot_index_out_of_range, unless stored() has a knot `index`.
inline Result<void> check_knot_index(const Curve& curve, std::size_t index) {
    const std::size_t last = curve.knots().stored().size() - 1;
    if (index <= last) return {};
    return refuse(
        {.code = CurveErrorCode::knot_index_out_of_range, .index = index, .upper = static_cast<double>(last)});
}

/// Error: point_index_out_of_range, unless `index` is at most `last`.
inline Result<void> check_point_index(std::size_t index, std::size_t last) {
    if (index <= last) return {};
    return refuse(
        {.code = CurveErrorCode::point_index_out_of_range, .index = index, .upper = static_cast<double>(last)});
}

/// Error: tolerance_not_positive, unless `tolerance` is above 0 and finite.
inline Result<void> check_tolerance(double tolerance) {
    if (tolerance > 0.0 && std::isfinite(tolerance)) return {};
    return refuse({.code = CurveErrorCode::tolerance_not_positive, .value = tolerance});
}

/// Error: parameter_not_finite.
inline Result<void> check_parameter_finite(double u) {
    if (std::isfinite(u)) return {};
    return refuse({.code = CurveErrorCode::parameter_not_finite});
}

/// Error: parameter_outside_domain.
inline Result<void> check_in_domain(const KnotVector& knots, double u) {
    const Interval domain = knots.domain();
    if (domain.contains(u)) return {};
    return refuse(
        {.code = CurveErrorCode::parameter_outside_domain, .value = u, .lower = domain.lower, .upper = domain.upper});
}

}  // namespace batten::core
