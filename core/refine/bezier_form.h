/// Curves in piecewise Bézier form, as one curve or as many, and back.
#pragma once

#include "core/curve/approximation.h"

namespace batten::core {

/// The same curve with every knot of multiplicity p, so that its control points are those of its Bézier pieces one
/// after the other; the ends of an open curve become clamped, a periodic curve stays periodic, tears stay. The kind
/// becomes Bézier or piecewise Bézier where the knots have it. Cost O(p) for each point of the result.
[[nodiscard]] Result<Curve> to_bezier(const Curve& curve);

/// One Bézier curve for each non-empty span, over the span's parameters. Cost likewise.
[[nodiscard]] Result<std::vector<Curve>> bezier_curves(const Curve& curve);

/// One curve of `pieces` (at least one), each beginning where the one before ends. Degrees are made equal by elevation;
/// a piece whose domain does not begin where the one before ends is shifted in its parameter; weights are multiplied by
/// a common factor where they differ at a joint. Knots at the joints are then removed as long as the whole curve
/// deviates by no more than `tolerance` (> 0, in the units of the points), which also is how far apart the ends that
/// meet may be; the later one gives way. The error is the largest of these gaps plus the deviation by the removals.
/// Errors: tolerance_not_positive; curve_periodic; ends_apart; knots_coincide; not_computable. Cost O(n p^2).
[[nodiscard]] Result<Approximation> join_pieces(std::span<const Curve> pieces, double tolerance);

/// The definition of `first` continued by `second`, both clamped where they meet, of equal degree and with domains that
/// follow each other, and with all their weights. The first point of `second` is dropped; its weights are brought to
/// those of `first`.
CurveDefinition concatenated(CurveDefinition first, const CurveDefinition& second);

}  // namespace batten::core
