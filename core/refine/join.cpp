#include "core/refine/join.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/continuity.h"
#include "core/measure/deviation.h"
#include "core/refine/bezier_form.h"
#include "core/refine/clamping.h"
#include "core/refine/degree.h"
#include "core/refine/detail/joint_shape.h"
#include "core/refine/detail/start_change.h"
#include "core/refine/knot_removal.h"
#include "core/refine/reparametrize.h"

namespace batten::core {

namespace {

// Two derivatives survive at an inserted knot.
constexpr int least_degree_of_change = 3;

// What rounding may leave in the points of a curve.
double rounding_of(const Curve& curve) {
    const Box box = control_box(curve);
    const double size = std::max({std::abs(box.lower.x), std::abs(box.lower.y), std::abs(box.upper.x),
                                  std::abs(box.upper.y), std::numeric_limits<double>::min()});
    return 1e-13 * size;
}

// The curve run through the other way, over the domain reflected at 0. Exact, and its own inverse.
Result<Curve> seen_from_behind(const Curve& curve) {
    CurveDefinition definition = curve.definition();
    std::ranges::reverse(definition.knots);
    for (double& knot : definition.knots) knot = 0.0 - knot;
    std::ranges::reverse(definition.points);
    std::ranges::reverse(definition.weights);
    return Curve::make(std::move(definition));
}

Result<Curve> raised_to(const Curve& curve, int degree) {
    return curve.degree() < degree ? elevate_degree(curve, degree - curve.degree()) : curve;
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

Result<CurvePair> raised(const CurvePair& pair, int least) {
    const int degree = std::max({least, pair.first.degree(), pair.second.degree()});
    const auto first = raised_to(pair.first, degree);
    if (!first) return refuse(first.error());
    return raised_to(pair.second, degree).map([&](const Curve& second) { return CurvePair{*first, second}; });
}

// The second curve as it continues the first one, and up to where it was changed for that.
struct Continuation {
    CurvePair pair;
    Curve changed;
    double until = 0.0;
};

// A polygon whose first straight part turns, so that it begins in `start` and no vertex in it becomes a corner.
Result<Continuation> turned_polygon(const CurvePair& pair, Point start) {
    const auto joints = joint_continuity(pair.second);
    const auto corner = std::ranges::find_if(
        joints, [](const JointContinuity& joint) { return joint.kind != JointKind::ends && joint.geometric < 1; });
    const double until = corner == joints.end() ? pair.second.domain().upper : corner->u;
    CurveDefinition definition = pair.second.definition();
    const Point from = definition.points.front();
    const double length = distance(from, point_at(pair.second, until, Side::left));
    const Vector move = start - from;
    for (std::size_t i = 1; i < definition.points.size() && definition.knots[i + 1] < until; ++i)
        definition.points[i] += (1.0 - std::min(1.0, distance(from, definition.points[i]) / length)) * move;
    definition.points.front() = start;
    return Curve::make(std::move(definition)).map([&](const Curve& changed) {
        return Continuation{pair, changed, until};
    });
}

// A smooth joint of curves that meet may not turn on the spot.
Result<void> check_turn(const CurvePair& pair, const Jet& wanted) {
    constexpr double nearly_back = std::numbers::pi - 1e-3;
    constexpr double small_gap = 1e-3;
    if (wanted.derivatives.empty()) return {};
    const double joint = pair.first.domain().upper;
    const Meeting meeting = meeting_of(pair.first, joint, pair.second, joint);
    const bool turns_back = meeting.angle && std::abs(*meeting.angle) > nearly_back;
    if (turns_back && meeting.gap <= small_gap * robust_length(control_box(pair.second).size()))
        return refuse({.code = CurveErrorCode::joint_turns_back});
    return {};
}

Result<Continuation> continuation(const CurvePair& pair, JoinContinuity continuity) {
    const auto wanted = wanted_start(pair.first, pair.second, continuity);
    if (!wanted) return refuse(wanted.error());
    const double joint = pair.first.domain().upper;
    if (begins_as(pair.second, *wanted))
        return raised(pair, 1).map([&](const CurvePair& even) { return Continuation{even, even.second, joint}; });
    if (const auto check = check_turn(pair, *wanted); !check) return refuse(check.error());
    if (continuity == JoinContinuity::c0 && pair.first.degree() == 1 && pair.second.degree() == 1)
        return turned_polygon(pair, wanted->point);
    const auto even = raised(pair, least_degree_of_change);
    if (!even) return refuse(even.error());
    const double until = end_of_change(even->second, *wanted);
    return with_start(even->second, *wanted, until).map([&](const Curve& changed) {
        return Continuation{*even, changed, until};
    });
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

// The end of the first to the start of the second.
Result<JoinedCurve> joined_forward(const Curve& first, const Curve& second, JoinContinuity continuity) {
    const auto pair = prepared(first, second);
    if (!pair) return refuse(pair.error());
    const auto found = continuation(*pair, continuity);
    if (!found) return refuse(found.error());
    const double joint = pair->first.domain().upper;
    return Curve::make(concatenated(found->pair.first.definition(), found->changed.definition()))
        .and_then([&](const Curve& joined) { return smoothed(joined, joint, continuity); })
        .map([&](const Curve& joined) {
            return JoinedCurve{.curve = joined,
                               .error = largest_deviation(found->pair.second, found->changed),
                               .joint = joint,
                               .changed = {joint, found->until},
                               .before = meeting_of(pair->first, joint, pair->second, joint),
                               .after = meeting_of(joined, joint, joined, joint),
                               .lost = smoothness_losses(found->pair.second, found->changed)};
        });
}

// What the two sides of a joint are when it is run through the other way.
template <class Sides>
Sides run_back(Sides sides) {
    std::swap(sides.before, sides.after);
    for (auto* value : {&sides.angle, &sides.before, &sides.after})
        if (*value) *value = -**value;
    return sides;
}

// Run through the other way.
Result<JoinedCurve> joined_backward(const Curve& first, const Curve& second, JoinContinuity continuity) {
    const auto turned = seen_from_behind(first);
    if (!turned) return refuse(turned.error());
    auto joined = joined_forward(*turned, second, continuity);
    if (!joined) return joined;
    return seen_from_behind(joined->curve).map([&](const Curve& curve) {
        auto lost = joined->lost;
        for (SmoothnessLoss& loss : lost) {
            loss.after = run_back(loss.after);
            loss.after.u = 0.0 - loss.after.u;
        }
        return JoinedCurve{.curve = curve,
                           .error = joined->error,
                           .joint = 0.0 - joined->joint,
                           .changed = {0.0 - joined->changed.upper, 0.0 - joined->changed.lower},
                           .before = run_back(joined->before),
                           .after = run_back(joined->after),
                           .lost = std::move(lost)};
    });
}

Result<void> check_open(const Curve& curve) {
    if (curve.is_periodic()) return refuse({.code = CurveErrorCode::curve_periodic});
    const bool is_point = robust_length(control_box(curve).size()) == 0.0;
    if (!is_point && is_closed(curve)) return refuse({.code = CurveErrorCode::curve_closed});
    return {};
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
        if (const auto check = check_open(*curve); !check) return refuse(check.error());
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
