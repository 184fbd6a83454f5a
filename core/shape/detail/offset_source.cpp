#include "core/shape/detail/offset_source.h"

#include <algorithm>
#include <cmath>

#include "core/curve/knot_analysis.h"
#include "core/evaluate/evaluate.h"
#include "core/evaluate/tangent.h"
#include "core/measure/continuity.h"
#include "core/measure/cusps.h"
#include "core/refine/periodic.h"

namespace batten::core {

OffsetSource::OffsetSource(const Curve& curve, double distance)
    : curve_(to_clamped(curve).value_or(curve)), distance_(distance), is_closed_(core::is_closed(curve)) {
    // Where the curve stands still it may turn back.
    std::vector<double> breaks;
    for (const Cusp& cusp : cusps(curve_)) breaks.push_back(cusp.u);
    for (const JointContinuity& joint : joint_continuity(curve)) {
        if (joint.kind != JointKind::knot)
            is_smoothly_closed_ = joint.geometric >= 2;
        else if (joint.geometric < 2)
            breaks.push_back(joint.u);
    }
    std::sort(breaks.begin(), breaks.end());
    double start = curve_.domain().lower;
    for (const double u : breaks) {
        if (!(start < u && u < curve_.domain().upper)) continue;
        stretches_.push_back({start, u});
        start = u;
    }
    stretches_.push_back({start, curve_.domain().upper});
    is_smoothly_closed_ = is_smoothly_closed_ && is_closed_ && stretches_.size() == 1;
}

Result<OffsetPlace> OffsetSource::at(double u, Side side) const {
    const Interval domain = curve_.domain();
    if (is_smoothly_closed_ && u > domain.upper) u -= domain.length();
    const Jet jet = derivatives_at(curve_, u, 1, side);
    const auto tangent = tangent_at(curve_, u, side);
    if (!tangent) return refuse({.code = CurveErrorCode::curve_stands_still, .value = u});
    // At zero speed the offset stands still, too, but for its turning.
    const double bend = curvature_at(curve_, u, side).value_or(0.0);
    return OffsetPlace{jet.point + distance_ * turned_left(*tangent), (1.0 - distance_ * bend) * jet[1], *tangent};
}

std::vector<double> OffsetSource::breaks_within(Interval part) const {
    const double period = curve_.domain().length();
    std::vector<double> breaks{part.lower};
    for (const double turn : {0.0, period})
        for (const DistinctKnot& knot : distinct_knots(curve_.knots())) {
            const double u = knot.value + turn;
            if (breaks.back() < u && u < part.upper) breaks.push_back(u);
        }
    breaks.push_back(part.upper);
    return breaks;
}

}  // namespace batten::core
