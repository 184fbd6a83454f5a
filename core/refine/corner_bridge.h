/// Fillets and chamfers: what takes the place of a corner between two curves, or of one.
#pragma once

#include <vector>

#include "core/curve/curve.h"
#include "core/curve/curve_end.h"

namespace batten::core {

/// An arc or a line from one curve to another, and what is left of them.
struct CornerBridge {
    Curve bridge;                              ///< from the first curve to the second one
    double u = 0.0;                            ///< where it leaves the first one
    double v = 0.0;                            ///< where it arrives at the second one
    CurveEnd kept_of_first = CurveEnd::start;  ///< the end of the first curve that stays, with all up to u
    CurveEnd kept_of_second = CurveEnd::end;   ///< and that of the second, with all up to v
};

/// The place on a curve that was pointed at.
struct PickedPlace {
    const Curve& curve;
    double u = 0.0;  ///< in the domain
};

/// The arc of a circle of this radius (> 0) that touches both curves, as a rational quadratic in pieces of at most 90
/// degrees. Of all such arcs of at most 180 degrees and more than 1e-6 radians, of which two lines that cross have
/// four, the one whose ends are nearest to the places picked. Each curve is kept on the side from which it runs
/// smoothly into the arc. The circle is found by Newton's iteration on the intersection of the offset curves, right to
/// about 1e-14 of the size of both; where two such intersections are nearer than a tenth of a span, they may be missed.
/// Where both places are on one curve (the same object), the arc joins what is before it to what is behind it. Errors:
/// length_not_positive; fillet_too_large and fillet_not_possible, which say what is allowed, of short curves;
/// no_fillet. Cost O(n p^2 log n); some hundred times that for an error.
[[nodiscard]] Result<CornerBridge> fillet(PickedPlace first, PickedPlace second, double radius);

/// The straight line between the places that are so far from the corner, along the curves on the sides of the places
/// picked; the corner is where the curves meet, nearest to these, and of one curve (the same object) the corner or
/// crossing with itself between them. Errors: length_not_positive; no_corner; chamfer_too_long, which says what is
/// allowed. Cost: that of the intersections and of the lengths.
[[nodiscard]] Result<CornerBridge> chamfer(PickedPlace first, PickedPlace second, double on_first, double on_second);

/// What is left of a curve that is kept from this end up to `u`; a closed one stays whole.
[[nodiscard]] Result<Curve> kept_part(const Curve& curve, CurveEnd end, double u);

/// The one curve whose corner the bridge takes away: what is before, the bridge, what is behind. A periodic curve stays
/// periodic, one whose ends meet stays closed.
[[nodiscard]] Result<Curve> with_corner_bridged(const Curve& curve, const CornerBridge& bridge);

/// Both curves and the bridge as one, in the direction of the first.
[[nodiscard]] Result<Curve> joined_by_bridge(const Curve& first, const Curve& second, const CornerBridge& bridge);

}  // namespace batten::core
