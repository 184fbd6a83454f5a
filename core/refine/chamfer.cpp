#include <cmath>
#include <optional>
#include <utility>

#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/arc_length.h"
#include "core/measure/continuity.h"
#include "core/measure/intersect_curves.h"
#include "core/refine/corner_bridge.h"

namespace batten::core {

namespace {

// Where the sides of a corner meet.
struct SidesMeet {
    double on_first = 0.0;
    double on_second = 0.0;
};

// The corner that is nearest to the places picked.
class NearestCorner {
  public:
    NearestCorner(PickedPlace first, PickedPlace second)
        : first_(first.curve),
          at_first_(point_at(first.curve, first.u)),
          at_second_(point_at(second.curve, second.u)) {}

    void offer(SidesMeet corner) {
        const Point place = point_at(first_, corner.on_first);
        const double cost = robust_length(place - at_first_) + robust_length(place - at_second_);
        if (best_ && !(cost < least_)) return;
        best_ = corner;
        least_ = cost;
    }

    std::optional<SidesMeet> best() const { return best_; }

  private:
    const Curve& first_;
    Point at_first_;
    Point at_second_;
    std::optional<SidesMeet> best_{};
    double least_ = 0.0;
};

std::optional<SidesMeet> corner_between(PickedPlace first, PickedPlace second) {
    NearestCorner nearest(first, second);
    for (const CurveContact& contact : intersect_curves(first.curve, second.curve).contacts)
        nearest.offer({contact.u, contact.v});
    if (nearest.best() || first.curve.is_periodic() || second.curve.is_periodic()) return nearest.best();
    Box box = control_box(first.curve);
    const Box other = control_box(second.curve);
    box.include(other.lower);
    box.include(other.upper);
    for (const JoinedEnds& ends : ends_that_meet(first.curve, second.curve, box))
        nearest.offer(
            {parameter_of(first.curve.domain(), ends.first), parameter_of(second.curve.domain(), ends.second)});
    return nearest.best();
}

// A corner, or a crossing of the curve with itself, with the first place before and the second behind it.
std::optional<SidesMeet> corner_of_one(PickedPlace first, PickedPlace second) {
    const Curve& curve = first.curve;
    NearestCorner nearest(first, second);
    for (const JointContinuity& joint : joint_continuity(curve)) {
        if (joint.geometric >= 1) continue;
        if (joint.kind == JointKind::knot && first.u <= joint.u && joint.u <= second.u)
            nearest.offer({joint.u, joint.u});
        if (joint.kind != JointKind::knot && second.u <= first.u)
            nearest.offer({curve.domain().upper, curve.domain().lower});
    }
    for (const CurveContact& contact : self_intersections(curve).contacts)
        if (first.u <= contact.u && contact.v <= second.u) nearest.offer({contact.u, contact.v});
    return nearest.best();
}

// The parameter so far from `from` along the curve, toward its end or its start.
Result<double> along(const Curve& curve, double from, bool is_onward, double distance) {
    const ArcLengthTable table(curve);
    const double here = table.length_at(from);
    const double available = is_onward ? table.total().value - here : here;
    if (!curve.is_periodic() && !(distance < available))
        return refuse_computed({.code = CurveErrorCode::chamfer_too_long, .value = distance, .upper = available});
    return table.parameter_at(is_onward ? here + distance : here - distance);
}

// Whether the place picked is behind the corner; at the corner itself the longer side is meant.
bool is_behind(PickedPlace place, double corner) {
    if (place.u != corner) return place.u > corner;
    const Interval domain = place.curve.domain();
    return domain.upper - corner > corner - domain.lower;
}

Result<Curve> line_between(Point from, Point to) {
    if (from == to) return refuse({.code = CurveErrorCode::ends_meet});
    return Curve::make({.degree = 1, .knots = {0, 0, 1, 1}, .points = {from, to}, .kind = KnotKind::bezier});
}

}  // namespace

Result<CornerBridge> chamfer(PickedPlace first, PickedPlace second, double on_first, double on_second) {
    for (const double distance : {on_first, on_second})
        if (!(distance > 0.0) || !std::isfinite(distance))
            return refuse({.code = CurveErrorCode::length_not_positive, .value = distance});
    const bool is_one = &first.curve == &second.curve;
    const auto corner = is_one ? corner_of_one(first, second) : corner_between(first, second);
    if (!corner) return refuse({.code = CurveErrorCode::no_corner});
    const bool first_is_behind = !is_one && is_behind(first, corner->on_first);
    const bool second_is_behind = is_one || is_behind(second, corner->on_second);
    const auto u = along(first.curve, corner->on_first, first_is_behind, on_first);
    if (!u) return refuse(u.error());
    const auto v = along(second.curve, corner->on_second, second_is_behind, on_second);
    if (!v) return refuse(v.error());
    return line_between(point_at(first.curve, *u), point_at(second.curve, *v)).map([&](const Curve& line) {
        return CornerBridge{line, *u, *v, first_is_behind ? CurveEnd::end : CurveEnd::start,
                            second_is_behind ? CurveEnd::end : CurveEnd::start};
    });
}

}  // namespace batten::core
