/// Edits of control points and weights (shape-changing).
#pragma once

#include <span>

#include "core/curve/curve.h"

namespace batten::core {

/// The curve with control point `index` at `position`. Errors: point_index_out_of_range; point_not_finite.
[[nodiscard]] Result<Curve> set_control_point(const Curve& curve, std::size_t index, Point position);

/// The curve with the points `indices` moved by `offset`. Errors as set_control_point.
[[nodiscard]] Result<Curve> move_control_points(const Curve& curve, std::span<const std::size_t> indices,
                                                Vector offset);

/// The share of a soft move around `center` that a control point takes,
///     (1 - (|P - center| / radius)^2)^2
/// nearer than `radius` (> 0), else 0.
double soft_share(Point point, Point center, double radius);

/// The curve with every control point moved by its soft_share() of `offset`, nearer than `radius` (> 0) to `center`;
/// those `pinned` (ascending) and all others keep every bit. Errors: length_not_positive; vector_not_finite.
[[nodiscard]] Result<Curve> soft_move(const Curve& curve, Point center, double radius, Vector offset,
                                      std::span<const std::size_t> pinned = {});

/// The curve with weight `index` set to `weight`. Errors: point_index_out_of_range; weight_not_finite;
/// weight_not_positive.
[[nodiscard]] Result<Curve> set_weight(const Curve& curve, std::size_t index, double weight);

/// The curve whose Farin point of leg `leg` lies `share` (above 0, below 1) of the way along it: w_{i+1} becomes w_i
/// share / (1 - share), where i = leg. All weights after it are multiplied alike, so that the other Farin points of an
/// open curve stay; a periodic curve, whose ratios multiply to 1 around it, changes w_{i+1} alone, and with it the
/// Farin point of the next leg. Errors: point_index_out_of_range; share_out_of_range; weight_not_finite or
/// weight_not_positive where a weight would leave what doubles can hold. Source: Farin 2002, chapter 13.
[[nodiscard]] Result<Curve> set_farin_share(const Curve& curve, std::size_t leg, double share);

/// The curve with a control point at `position` inserted before point `index` (0..n+1, so also at both ends), its
/// weight interpolated along the leg, and one knot more; all other control points stay. A special kind is regenerated
/// over the same domain (Bézier: the degree grows by one up to max_degree). A custom vector, and a piecewise Bézier
/// one, which has no knots for one point more, gains the knot that halves the span most controlled by the leg. In a
/// periodic curve 0 means the same leg as n, from the last point to the first, and the new point comes last. Errors:
/// point_index_out_of_range; point_not_finite; degree_out_of_range; multiplicity_full when no span can be halved.
[[nodiscard]] Result<Curve> add_control_point(const Curve& curve, std::size_t index, Point position);

/// The curve without control point `index` and without one knot: a special kind is regenerated (Bézier: the degree
/// falls by one), a custom or piecewise Bézier vector loses the inner knot nearest to the point's Greville abscissa.
/// Errors: point_index_out_of_range; too_few_points.
[[nodiscard]] Result<Curve> delete_control_point(const Curve& curve, std::size_t index);

/// The curve without the points `indices` (distinct, any order), as if they were deleted one by one from the last.
/// Errors as delete_control_point. Cost O(p) for each point deleted, and one copy of everything.
[[nodiscard]] Result<Curve> delete_control_points(const Curve& curve, std::span<const std::size_t> indices);

}  // namespace batten::core
