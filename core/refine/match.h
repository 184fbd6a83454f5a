/// Changes the end of one curve so that it meets another one, which stays as it is.
#pragma once

#include <vector>

#include "core/curve/curve.h"
#include "core/measure/meeting.h"
#include "core/measure/smoothness.h"

namespace batten::core {

struct MatchedCurve {
    Curve curve;
    double error = 0.0;                  ///< how far it moved: the largest deviation
    Interval changed{};                  ///< the part that moved, by the parameter; empty where nothing had to
    Meeting before{};                    ///< the joint as it was, run through from the other curve into this one
    Meeting after{};                     ///< and as it is
    std::vector<SmoothnessLoss> lost{};  ///< where the curve became less smooth
};

/// `curve`, changed beside this end so that it continues `target`, a place of another curve seen in the sense in which
/// this one goes on from there: its point, its direction, its curvature and the change of that by arc length, as many
/// as `continuity` says. The domain stays, and behind the part that changes so does every bit; how long that part is,
/// what is kept in it and how the degree rises is what join() says of a second curve. Errors: curve_periodic;
/// curve_closed; curve_stands_still where a direction or curvature is needed and one side has none; joint_turns_back;
/// not_computable. Cost O(n p^2).
[[nodiscard]] Result<MatchedCurve> match(const Curve& curve, CurveEnd end, const Passing& target,
                                         GeometricContinuity continuity);

/// `other` at `u`, in the domain, in the sense in which this end of `curve` turns least to go on from there; at an end
/// of an open curve in the sense that leads beyond it.
Passing passing_toward(const Curve& other, double u, const Curve& curve, CurveEnd end);

}  // namespace batten::core
