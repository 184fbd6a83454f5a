/// A new curve between the ends of two others, which stay as they are.
#pragma once

#include "core/curve/curve.h"
#include "core/curve/curve_end.h"
#include "core/measure/meeting.h"

namespace batten::core {

/// One side of a blend.
struct BlendSide {
    GeometricContinuity continuity = GeometricContinuity::g2;
    double tension = 1.0;  ///< > 0: how far it follows the curve that it leaves; 1 is the natural length
};

/// One Bézier curve over [0, 1] from `from`, whose direction it takes, to `to`, in whose direction it arrives. Its
/// degree is the least one with room for what is given at both ends: 1 for G0 and G0, 3 for G1 and G1, 5 for G2 and G2,
/// 7 for G3 and G3. At both ends it runs with the speed that makes its parameter nearly its arc length, times the
/// tension; slower where the curves are so strongly bent that it would turn by more than 5 radians with them. Errors:
/// tension_not_positive; ends_meet where both points are one; end_stands_still where a direction or curvature is needed
/// and there is none; not_computable. Cost: some twenty times that of a length.
[[nodiscard]] Result<Curve> blend(const Passing& from, BlendSide first, const Passing& to, BlendSide second);

/// The blend from this end of `first` to that of `second`. Errors likewise, and curve_periodic; curve_closed.
[[nodiscard]] Result<Curve> blend(const Curve& first, const Curve& second, JoinedEnds ends, BlendSide at_first,
                                  BlendSide at_second);

}  // namespace batten::core
