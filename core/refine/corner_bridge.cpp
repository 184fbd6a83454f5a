#include "core/refine/corner_bridge.h"

#include <algorithm>
#include <cmath>

#include "core/evaluate/evaluate.h"
#include "core/measure/arc_length.h"
#include "core/measure/closing.h"
#include "core/measure/continuity.h"
#include "core/refine/bezier_form.h"
#include "core/refine/clamping.h"
#include "core/refine/detail/changed_start.h"
#include "core/refine/periodic.h"
#include "core/refine/reparametrize.h"
#include "core/refine/reverse.h"
#include "core/refine/split.h"

namespace batten::core {

namespace {

// The second one as it follows the first, both of one degree. Their ends are one point, up to rounding.
Result<Curve> chained(const Curve& first, const Curve& second) {
    const int degree = std::max(first.degree(), second.degree());
    auto a = clamp_ends(first).and_then([&](const Curve& curve) { return raised_to(curve, degree); });
    if (!a) return a;
    auto b = clamp_ends(second)
                 .and_then([&](const Curve& curve) { return raised_to(curve, degree); })
                 .and_then([&](const Curve& curve) { return shift_domain(curve, a->domain().upper); });
    if (!b) return b;
    return Curve::make(concatenated(a->definition(), b->definition()));
}

// The bridge run through about as fast as the curves at its ends.
Result<Curve> paced(const Curve& bridge, double speed) {
    const double span = arc_length(bridge).value / speed;
    if (!(span > 0.0) || !std::isfinite(span)) return bridge;
    return reparametrize(bridge, {0.0, span});
}

double speed_at(const Curve& curve, double u, Side side) {
    return robust_length(derivatives_at(curve, u, 1, side)[1]);
}

// What is kept behind the bridge up to what is kept before it, where a closed curve is cut twice.
Result<Curve> ring_without_corner(const Curve& curve, const Curve& bridge, double u, double v) {
    auto ring = sub_curve(curve, v, u).and_then([&](const Curve& kept) { return chained(kept, bridge); });
    if (!ring || !curve.is_periodic()) return ring;
    return to_periodic(*ring, absolute_tolerance(*ring, default_closing_tolerance))
        .map([](const Approximation& closed) { return closed.curve; });
}

}  // namespace

Result<Curve> kept_part(const Curve& curve, CurveEnd end, double u) {
    if (is_closed(curve)) return curve;
    return end == CurveEnd::start ? sub_curve(curve, curve.domain().lower, u)
                                  : sub_curve(curve, u, curve.domain().upper);
}

Result<Curve> with_corner_bridged(const Curve& curve, const CornerBridge& bridge) {
    const double speed = 0.5 * (speed_at(curve, bridge.u, Side::left) + speed_at(curve, bridge.v, Side::right));
    auto between = paced(bridge.bridge, speed);
    if (!between) return between;
    if (curve.is_periodic() || bridge.v < bridge.u) return ring_without_corner(curve, *between, bridge.u, bridge.v);
    auto before = sub_curve(curve, curve.domain().lower, bridge.u);
    if (!before) return before;
    auto behind = sub_curve(curve, bridge.v, curve.domain().upper);
    if (!behind) return behind;
    return chained(*before, *between).and_then([&](const Curve& begun) { return chained(begun, *behind); });
}

Result<Curve> joined_by_bridge(const Curve& first, const Curve& second, const CornerBridge& bridge) {
    for (const Curve* curve : {&first, &second})
        if (const auto check = check_has_ends(*curve); !check) return refuse(check.error());
    const bool is_first_turned = bridge.kept_of_first == CurveEnd::end;
    const bool is_second_turned = bridge.kept_of_second == CurveEnd::start;
    const auto turned = [](const Curve& curve, bool is_turned) {
        return is_turned ? reverse(curve) : Result<Curve>(curve);
    };
    auto before = kept_part(first, bridge.kept_of_first, bridge.u).and_then([&](const Curve& part) {
        return turned(part, is_first_turned);
    });
    if (!before) return before;
    auto behind = kept_part(second, bridge.kept_of_second, bridge.v).and_then([&](const Curve& part) {
        return turned(part, is_second_turned);
    });
    if (!behind) return behind;
    return paced(bridge.bridge, speed_at(*before, before->domain().upper, Side::left))
        .and_then([&](const Curve& between) { return chained(*before, between); })
        .and_then([&](const Curve& begun) { return chained(begun, *behind); })
        .and_then([&](const Curve& joined) { return turned(joined, is_first_turned); });
}

}  // namespace batten::core
