#include "core/refine/degree.h"

#include <cmath>

#include "core/curve/detail/edit_checks.h"
#include "core/curve/knot_analysis.h"
#include "core/curve/knot_kinds.h"
#include "core/measure/deviation.h"
#include "core/refine/clamping.h"

namespace batten::core {

namespace {

Result<Curve> reduced_to(const Curve& curve, int degree, const Progress& progress) {
    Result<Curve> reduced = curve;
    const double steps = curve.degree() - degree;
    for (double step = 0.0; reduced && step < steps; step += 1.0)
        reduced = reduce_degree(*reduced, part_of(progress, step / steps, (step + 1.0) / steps));
    return reduced;
}

Result<Curve> changed_by_shape(const Curve& curve, int degree) {
    return degree > curve.degree() ? elevate_degree(curve, degree - curve.degree()) : reduced_to(curve, degree, {});
}

// Equal spans, or another spacing that has a name, can be made anew in any degree.
bool can_be_made_anew(const KnotVector& knots) {
    return kind_by_values(knots) != KnotKind::custom || is_uniform(knots);
}

// Knots of the same sort in `degree` for the same number of points over the same domain.
Result<KnotVector> made_anew(const Curve& curve, int degree) {
    const KnotVector& knots = curve.knots();
    const KnotKind kind = kind_by_values(knots);
    const std::size_t count = curve.control_points().size();
    const ClampedEnds clamped{is_clamped_at(knots, CurveEnd::start), is_clamped_at(knots, CurveEnd::end)};
    if (kind == KnotKind::custom) return make_even_knots(degree, count, curve.domain(), clamped);
    Result<KnotVector> same_kind = make_knots(kind, degree, count, curve.domain());
    const bool fits = same_kind || same_kind.error().code != CurveErrorCode::kind_not_possible;
    return fits ? same_kind : make_knots(KnotKind::clamped_uniform, degree, count, curve.domain());
}

}  // namespace

Result<Approximation> reduce_degree(const Curve& curve, int by, double tolerance, const Progress& progress) {
    if (const auto check = check_tolerance(tolerance); !check) return refuse(check.error());
    if (by < 1 || by > curve.degree() - min_degree)
        return refuse({.code = CurveErrorCode::degree_out_of_range,
                       .value = static_cast<double>(curve.degree()) - static_cast<double>(by)});
    const auto reduced = reduced_to(curve, curve.degree() - by, part_of(progress, 0.0, 0.9));
    if (!reduced) return refuse(reduced.error());
    const double error = largest_deviation(curve, *reduced);
    if (!(error <= tolerance))
        return refuse_computed({.code = CurveErrorCode::deviation_too_large, .value = error, .upper = tolerance});
    return Approximation{*reduced, error};
}

Result<Curve> set_degree(const Curve& curve, int degree) {
    if (degree < min_degree || degree > max_degree)
        return tl::unexpected(
            CurveError{.code = CurveErrorCode::degree_out_of_range, .value = static_cast<double>(degree)});
    if (degree == curve.degree()) return curve;
    if (!can_be_made_anew(curve.knots())) return changed_by_shape(curve, degree);
    Result<KnotVector> knots = made_anew(curve, degree);
    if (!knots) return refuse(knots.error());
    CurveDefinition definition = curve.definition();
    return Curve::make(std::move(*knots), std::move(definition.points), std::move(definition.weights));
}

}  // namespace batten::core
