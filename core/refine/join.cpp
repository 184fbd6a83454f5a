#include "core/refine/join.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/continuity.h"
#include "core/measure/deviation.h"
#include "core/refine/bezier_form.h"
#include "core/refine/clamping.h"
#include "core/refine/detail/changed_start.h"
#include "core/refine/knot_removal.h"
#include "core/refine/reparametrize.h"

namespace batten::core {

namespace {

// What rounding may leave in the points of a curve.
double rounding_of(const Curve& curve) {
    const Box box = control_box(curve);
    const double size = std::max({std::abs(box.lower.x), std::abs(box.lower.y), std::abs(box.upper.x),
                                  std::abs(box.upper.y), std::numeric_limits<double>::min()});
    return 1e-13 * size;
}

// Both clamped where they meet, their domains one after the other.
struct CurvePair {
    Curve first;
    Curve second;
};

Result<CurvePair> prepared(const Curve& first, const Curve& second) {
    const auto a = clamp(first, CurveEnd::end);
    if (!a) return refuse(a.error());
    return clamp_ends(second)
        .and_then([&](const Curve& b) { return shift_domain(b, a->domain().upper); })
        .map([&](const Curve& b) {
            return CurvePair{*a, b};
        });
}

// The second curve as it continues the first one.
Result<ChangedStart> continuation(const CurvePair& pair, JoinContinuity continuity) {
    const auto wanted = wanted_start(pair.first, pair.second, continuity);
    if (!wanted) return refuse(wanted.error());
    return changed_start(pair.second, passing_at(pair.first, CurveEnd::end), *wanted, pair.first.degree());
}

// For C1 and C2 the joint needs fewer knots.
Result<Curve> smoothed(const Curve& curve, double joint, JoinContinuity continuity) {
    const bool is_parametric = continuity == JoinContinuity::c1 || continuity == JoinContinuity::c2;
    const int times = std::min(order_of(continuity), curve.knots().multiplicity(joint));
    if (!is_parametric || times == 0) return curve;
    return remove_knot(curve, joint, times, rounding_of(curve)).map([](const KnotRemoval& removal) {
        return removal.curve;
    });
}

// Up to the joint the one curve, from there on the other, which may be the same one.
Meeting meeting_at(const Curve& first, double joint, const Curve& second) {
    return meeting_of(passing_at(first, joint, Side::left), passing_at(second, joint, Side::right));
}

// The end of the first to the start of the second.
Result<JoinedCurve> joined_forward(const Curve& first, const Curve& second, JoinContinuity continuity) {
    const auto pair = prepared(first, second);
    if (!pair) return refuse(pair.error());
    const auto found = continuation(*pair, continuity);
    if (!found) return refuse(found.error());
    const auto first_part = raised_to(pair->first, found->after.degree());
    if (!first_part) return refuse(first_part.error());
    const double joint = pair->first.domain().upper;
    return Curve::make(concatenated(first_part->definition(), found->after.definition()))
        .and_then([&](const Curve& joined) { return smoothed(joined, joint, continuity); })
        .map([&](const Curve& joined) {
            return JoinedCurve{.curve = joined,
                               .error = largest_deviation(found->before, found->after),
                               .joint = joint,
                               .changed = {joint, found->until},
                               .before = meeting_at(pair->first, joint, pair->second),
                               .after = meeting_at(joined, joint, joined),
                               .lost = smoothness_losses(found->before, found->after)};
        });
}

// Run through the other way.
Result<JoinedCurve> joined_backward(const Curve& first, const Curve& second, JoinContinuity continuity) {
    const auto turned = seen_from_behind(first);
    if (!turned) return refuse(turned.error());
    auto joined = joined_forward(*turned, second, continuity);
    if (!joined) return joined;
    return seen_from_behind(joined->curve).map([&](const Curve& curve) {
        return JoinedCurve{.curve = curve,
                           .error = joined->error,
                           .joint = 0.0 - joined->joint,
                           .changed = {0.0 - joined->changed.upper, 0.0 - joined->changed.lower},
                           .before = run_back(joined->before),
                           .after = run_back(joined->after),
                           .lost = seen_from_behind(joined->lost)};
    });
}

}  // namespace

JoinedEnds nearest_ends(const Curve& first, const Curve& second) {
    const double rounding = rounding_of(first) + rounding_of(second);
    const auto gap = [&](JoinedEnds ends) {
        return robust_length(point_at(second, parameter_of(second.domain(), ends.second)) -
                             point_at(first, parameter_of(first.domain(), ends.first)));
    };
    JoinedEnds nearest = all_joined_ends.front();
    for (const JoinedEnds& ends : all_joined_ends)
        if (gap(ends) < gap(nearest) - rounding) nearest = ends;
    return nearest;
}

Result<JoinedCurve> join(const Curve& first, const Curve& second, JoinContinuity continuity, JoinedEnds ends) {
    for (const Curve* curve : {&first, &second})
        if (const auto check = check_has_ends(*curve); !check) return refuse(check.error());
    const auto oriented = ends.second == CurveEnd::start ? Result<Curve>(second) : seen_from_behind(second);
    if (!oriented) return refuse(oriented.error());
    auto joined = ends.first == CurveEnd::end ? joined_forward(first, *oriented, continuity)
                                              : joined_backward(first, *oriented, continuity);
    if (!joined) return joined;
    if (!std::isfinite(joined->before.gap) || !std::isfinite(joined->after.gap))
        return refuse({.code = CurveErrorCode::not_computable});
    joined->ends = ends;
    return joined;
}

Result<JoinedCurve> join(const Curve& first, const Curve& second, JoinContinuity continuity) {
    return join(first, second, continuity, nearest_ends(first, second));
}

}  // namespace batten::core
