/// The part of a curve that the removal of one knot reaches, as a curve of its own, so that removing costs the same
/// however long the curve is.
#pragma once

#include <optional>

#include "core/curve/curve.h"

namespace batten::core {

/// Control points first_point, first_point + 1, ... of the unrolled curve over their own knots.
struct CurveInReach {
    Curve curve;
    std::size_t first_point = 0;
};

/// All that matters when the knot `u`, strictly inside the domain, is taken out, however often it occurs; none where
/// that is the whole of a period.
std::optional<CurveInReach> curve_in_reach(const Curve& curve, double u);

/// `curve` with `part` in place of the curve in reach, of which it has lost some of the knots `u`. Cost: one copy of
/// everything.
Curve with_part_exchanged(const Curve& curve, const CurveInReach& reach, const Curve& part, double u);

}  // namespace batten::core
