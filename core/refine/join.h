/// Joins two curves to one, with the continuity asked for.
#pragma once

#include <vector>

#include "core/base/names.h"
#include "core/curve/curve.h"
#include "core/curve/curve_end.h"
#include "core/measure/meeting.h"
#include "core/measure/smoothness.h"

namespace batten::core {

/// C: equal derivatives by the parameter. G: equal tangent directions (and curvatures, and their change by arc length),
/// whatever the speed.
enum class JoinContinuity { c0, c1, c2, g1, g2, g3 };

template <>
struct Names<JoinContinuity> {
    static constexpr std::array table{Named{JoinContinuity::c0, "C0", "C0"}, Named{JoinContinuity::c1, "C1", "C1"},
                                      Named{JoinContinuity::c2, "C2", "C2"}, Named{JoinContinuity::g1, "G1", "G1"},
                                      Named{JoinContinuity::g2, "G2", "G2"}, Named{JoinContinuity::g3, "G3", "G3"}};
};

struct JoinedCurve {
    Curve curve;
    double error = 0.0;  ///< how far the second curve moved: the largest deviation of its part
    JoinedEnds ends{};
    double joint = 0.0;  ///< the parameter where the curves meet
    Interval changed{};  ///< the part of the second curve that moved, by the parameter; empty where none did
    Meeting before{};    ///< the joint as it was
    Meeting after{};     ///< and as it is
    std::vector<SmoothnessLoss> lost{};  ///< where the second curve became less smooth
};

/// The two ends that are nearest to each other. Of ends that are equally near, but for rounding, those go before with
/// which `second` keeps its direction, and then the end of `first` before its start.
JoinedEnds nearest_ends(const Curve& first, const Curve& second);

/// One curve of `first`, which keeps its shape, its direction and its parameters, and of `second`, which follows it or
/// goes before it, turned where these ends need it and with the spacing of its knots kept.
///
/// Where the curves do not meet as they shall, `second` is changed beside the joint: over a quarter of its length, over
/// up to half of it where the joint turns far, or over three times the gap if that is longer; less where the first
/// curve is so fast by its parameter, or bends so strongly, that it would lead astray. All of the rest stays, and so
/// does the continuity at the knots: a knot at which the curve is smoother by its shape than by its derivatives ends
/// the part that changes, unless the gap is too wide for that. For this the degree is raised to 3 at least, to 4 for
/// G3, and as many knots are inserted as derivatives are set; two polygons to be joined with C0 stay polygons, of which
/// the first straight part turns. For G the second curve begins with its own speed, up to half as much again where the
/// joint turns far. Weights are multiplied by a common factor so that they agree at the joint. The knot at the joint
/// has multiplicity p; for C1 and C2 it loses as many knots as rounding allows, all of 1 and 2 unless weights differ.
///
/// Errors: curve_periodic; curve_closed where the ends of one meet; curve_stands_still where a direction or curvature
/// is needed and an end has none; joint_turns_back where a smooth joint would have to turn on the spot; not_computable;
/// those of elevate_degree and shift_domain. Cost O(n p^2).
[[nodiscard]] Result<JoinedCurve> join(const Curve& first, const Curve& second, JoinContinuity continuity,
                                       JoinedEnds ends);

/// The same at the nearest ends.
[[nodiscard]] Result<JoinedCurve> join(const Curve& first, const Curve& second, JoinContinuity continuity);

}  // namespace batten::core
