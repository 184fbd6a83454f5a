#include "core/refine/clamping.h"

#include <algorithm>
#include <utility>

#include "core/refine/detail/carried_point.h"
#include "core/refine/detail/end_knots.h"
#include "core/refine/detail/largest_possible.h"

namespace batten::core {

namespace {

// The p+1 knots before and at the start of a domain whose spans are repeated outside it, `share` times as long.
void repeat_spans_before_start(PreciselyCarriedSpline& spline, double share) {
    const std::size_t p = spline.p;
    const std::size_t n = spline.points.size() - 1;
    for (std::size_t i = 0; i < p; ++i)
        spline.knots[p - i - 1] = spline.knots[p - i] - share * (spline.knots[n - i + 1] - spline.knots[n - i]);
}

PreciselyCarriedSpline unclamped_by(PreciselyCarriedSpline spline, double share) {
    const std::size_t p = spline.p;
    PreciselyCarriedSpline result = spline;
    repeat_spans_before_start(result, share);
    std::vector<double> values;
    for (std::size_t i = 1; i < p; ++i) values.push_back(result.knots[p - i]);
    exchange_start_knots(spline, values);
    result.points = std::move(spline.points);
    return result;
}

PreciselyCarriedSpline unclamped_at_start(PreciselyCarriedSpline spline) {
    return unclamped_by(clamped_at_start(std::move(spline)), 1.0);
}

// How far the knots would lie outside, and how far they may for positive weights.
CurveError outer_knots_too_far(const Curve& curve, CurveEnd end) {
    const PreciselyCarriedSpline spline = clamped_at_start(seen_from_end(carried_precisely(curve), end));
    const double reach = spline.knots[spline.p] - unclamped_at_start(spline).knots[1];
    const double most = largest_possible(reach, [&](double part) {
        return std::ranges::all_of(unclamped_by(spline, part / reach).points, [](const PreciselyCarriedPoint& carried) {
            const HomogeneousPoint point = rounded(carried.point);
            return is_finite(point) && point.z > 0.0;
        });
    });
    return {.code = CurveErrorCode::outer_knots_too_far, .value = reach, .upper = most};
}

// A kind that says something of the ends goes over into the one for the other sort of ends, where the values have it.
KnotKind kind_with_ends(KnotKind kind, bool clamped) {
    if (clamped) return kind == KnotKind::uniform ? KnotKind::clamped_uniform : kind;
    return kind == KnotKind::custom ? kind : KnotKind::uniform;
}

Result<Curve> with_end(const Curve& curve, CurveEnd end, PreciselyCarriedSpline (*change)(PreciselyCarriedSpline),
                       bool clamped) {
    if (curve.is_periodic()) return refuse({.code = CurveErrorCode::curve_periodic});
    PreciselyCarriedSpline spline = seen_from_end(change(seen_from_end(carried_precisely(curve), end)), end);
    return settled(curve, std::move(spline), kind_with_ends(curve.knots().kind(), clamped));
}

}  // namespace

Result<Curve> clamp(const Curve& curve, CurveEnd end) {
    if (!curve.is_periodic() && is_clamped_at(curve.knots(), end)) return curve;
    return with_end(curve, end, clamped_at_start, true);
}

Result<Curve> unclamp(const Curve& curve, CurveEnd end) {
    auto result = with_end(curve, end, unclamped_at_start, false);
    if (!result && is_carried_too_far(result.error())) return refuse_computed(outer_knots_too_far(curve, end));
    return result;
}

namespace {

Result<Curve> at_both_ends(const Curve& curve, Result<Curve> (*change)(const Curve&, CurveEnd), bool clamped) {
    return change(curve, CurveEnd::start)
        .and_then([&](const Curve& half) { return change(half, CurveEnd::end); })
        .and_then([&](const Curve& both) {
            CurveDefinition definition = both.definition();
            definition.kind = kind_with_ends(curve.knots().kind(), clamped);
            return Curve::make(std::move(definition));
        });
}

}  // namespace

Result<Curve> clamp_ends(const Curve& curve) {
    return at_both_ends(curve, clamp, true);
}

Result<Curve> unclamp_ends(const Curve& curve) {
    return at_both_ends(curve, unclamp, false);
}

bool is_clamped_at(const KnotVector& knots, CurveEnd end) {
    if (knots.is_periodic()) return false;
    return end == CurveEnd::start ? knots.values().front() == knots.domain().lower
                                  : knots.values().back() == knots.domain().upper;
}

}  // namespace batten::core
