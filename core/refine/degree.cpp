#include "core/refine/degree.h"

#include <cmath>

#include "core/curve/detail/edit_checks.h"
#include "core/curve/knot_kinds.h"
#include "core/measure/deviation.h"

namespace batten::core {

namespace {

Result<Curve> changed_by_shape(const Curve& curve, int degree) {
    if (degree > curve.degree()) return elevate_degree(curve, degree - curve.degree());
    Result<Curve> reduced = curve;
    while (reduced && reduced->degree() > degree) reduced = reduce_degree(*reduced);
    return reduced;
}

}  // namespace

Result<Approximation> reduce_degree(const Curve& curve, int by, double tolerance) {
    if (const auto check = check_tolerance(tolerance); !check) return refuse(check.error());
    if (by < 1 || by > curve.degree() - min_degree)
        return refuse({.code = CurveErrorCode::degree_out_of_range,
                       .value = static_cast<double>(curve.degree()) - static_cast<double>(by)});
    const auto reduced = changed_by_shape(curve, curve.degree() - by);
    if (!reduced) return refuse(reduced.error());
    const double error = largest_deviation(curve, *reduced);
    if (!(error <= tolerance))
        return refuse({.code = CurveErrorCode::deviation_too_large, .value = error, .upper = tolerance});
    return Approximation{*reduced, error};
}

Result<Curve> set_degree(const Curve& curve, int degree) {
    if (degree < min_degree || degree > max_degree)
        return tl::unexpected(
            CurveError{.code = CurveErrorCode::degree_out_of_range, .value = static_cast<double>(degree)});
    if (degree == curve.degree()) return curve;
    const KnotKind kind = curve.knots().kind();
    if (kind == KnotKind::custom) return changed_by_shape(curve, degree);
    CurveDefinition definition = curve.definition();
    const std::size_t count = definition.points.size();
    auto knots = make_knots(kind, degree, count, curve.domain());
    if (!knots && knots.error().code == CurveErrorCode::kind_not_possible)
        knots = make_knots(KnotKind::clamped_uniform, degree, count, curve.domain());
    if (!knots) return tl::unexpected(knots.error());
    return Curve::make(std::move(*knots), std::move(definition.points), std::move(definition.weights));
}

}  // namespace batten::core
