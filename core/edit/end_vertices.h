/// End vertices that make a uniform cubic begin or end where its polygon does, or where another one ends
/// (shape-changing).
#pragma once

#include <optional>

#include "core/curve/curve.h"
#include "core/curve/curve_end.h"
#include "core/evaluate/uniform_cubic.h"

namespace batten::core {

/// What is added at an end with the points P0, P1, ... (at the other end likewise, counted from there). Positions,
/// derivatives per knot step and curvature are those of the new end; all three leave the rest of the curve as it is.
enum class EndVertex {
    /// P0 once more: the curve begins at P0 + (P1 - P0) / 6, in the direction P1 - P0 with C' = (P1 - P0) / 2 and no
    /// curvature. With unequal weights the share is w1 / (5 w0 + w1) instead of 1/6.
    doubled,
    /// P0 twice more: the curve begins at P0, with C' = 0, and is straight over its first span, up to where the doubled
    /// vertex begins.
    tripled,
    /// The phantom 2 P0 - P1, with the weight of P1: the curve begins at P0 with C'' = 0, so without curvature, and,
    /// with equal weights, C' = P1 - P0.
    phantom
};

/// The curve with such a vertex at `end`; the domain grows by one knot step, by two when tripled, and the old part of
/// the curve keeps its parameters. Error: curve_not_uniform_cubic; point_not_finite. Cost: the copying. Source: Barsky
/// 1982, End conditions and boundary conditions for uniform B-spline curve and surface representations; Bartels,
/// Beatty, Barsky 1987, chapter 14.
[[nodiscard]] Result<Curve> add_end_vertex(const Curve& curve, CurveEnd end, EndVertex vertex);

/// The joint with which an open uniform polynomial cubic begins or ends, or would begin or end with such a vertex;
/// derivatives per knot step, in the sense of growing u. Its index and u are of the curve as it is. Cost O(1).
Anticentroid end_joint(const Curve& curve, CurveEnd end, std::optional<EndVertex> vertex = {});

/// The curve with the three vertices at `end` moved onto those at the other end of `other`, in their order: so the one
/// begins where the other ends, with C2 by knot steps. Errors, of `curve` and then of `other`: curve_not_uniform_cubic,
/// also for periodic ones; curve_rational. Cost: the copying.
[[nodiscard]] Result<Curve> share_end_vertices(const Curve& curve, CurveEnd end, const Curve& other);

}  // namespace batten::core
