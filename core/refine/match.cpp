#include "core/refine/match.h"

#include <cmath>
#include <utility>

#include "core/measure/deviation.h"
#include "core/refine/clamping.h"
#include "core/refine/detail/changed_start.h"

namespace batten::core {

namespace {

// The curve begins where it shall meet the other one.
Result<MatchedCurve> matched_start(const Curve& curve, const Passing& target, GeometricContinuity continuity) {
    const auto clamped = clamp_ends(curve);
    if (!clamped) return refuse(clamped.error());
    const auto wanted = start_after(target, *clamped, order_of(continuity));
    if (!wanted) return refuse(wanted.error());
    const auto found = changed_start(*clamped, target, *wanted, clamped->degree());
    if (!found) return refuse(found.error());
    const double start = curve.domain().lower;
    const bool is_changed = found->until > start;
    return MatchedCurve{.curve = is_changed ? found->after : curve,
                        .error = is_changed ? largest_deviation(found->before, found->after) : 0.0,
                        .changed = {start, found->until},
                        .before = meeting_of(target, passing_at(curve, CurveEnd::start)),
                        .after = meeting_of(target, passing_at(found->after, CurveEnd::start)),
                        .lost = smoothness_losses(found->before, found->after)};
}

Result<MatchedCurve> matched_end(const Curve& curve, const Passing& target, GeometricContinuity continuity) {
    const auto turned = seen_from_behind(curve);
    if (!turned) return refuse(turned.error());
    auto matched = matched_start(*turned, target, continuity);
    if (!matched) return matched;
    const auto back = seen_from_behind(matched->curve);
    if (!back) return refuse(back.error());
    matched->curve = *back;
    matched->changed = {0.0 - matched->changed.upper, 0.0 - matched->changed.lower};
    matched->lost = seen_from_behind(std::move(matched->lost));
    return matched;
}

}  // namespace

Result<MatchedCurve> match(const Curve& curve, CurveEnd end, const Passing& target, GeometricContinuity continuity) {
    if (const auto check = check_has_ends(curve); !check) return refuse(check.error());
    auto matched =
        end == CurveEnd::start ? matched_start(curve, target, continuity) : matched_end(curve, target, continuity);
    if (!matched) return matched;
    if (!std::isfinite(matched->before.gap) || !std::isfinite(matched->after.gap))
        return refuse({.code = CurveErrorCode::not_computable});
    return matched;
}

Passing passing_toward(const Curve& other, double u, const Curve& curve, CurveEnd end) {
    const Interval domain = other.domain();
    if (!other.is_periodic() && u <= domain.lower) return passing_beyond(other, CurveEnd::start);
    if (!other.is_periodic() && u >= domain.upper) return passing_beyond(other, CurveEnd::end);
    const Passing onward = passing_at(other, u, Side::left);
    const Passing backward = run_back(passing_at(other, u, Side::right));
    const Passing own = end == CurveEnd::start ? passing_at(curve, end) : run_back(passing_at(curve, end));
    if (!onward.direction || !backward.direction || !own.direction) return onward;
    return dot(*backward.direction, *own.direction) > dot(*onward.direction, *own.direction) ? backward : onward;
}

}  // namespace batten::core
