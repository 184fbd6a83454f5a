/// Curves mapped by their control points: affine maps exactly, projective ones with the weights.
#pragma once

#include <span>

#include "core/curve/curve.h"
#include "core/edit/plane_map.h"

namespace batten::core {

/// The curve whose every point is the image of a point of `curve`: its control points are mapped, and where the map is
/// projective their weights multiplied by weight_factor, which makes a polynomial curve rational. Knots, and for an
/// affine map weights, stay. A map and its negative are one, so that all factors may also be negative. Source: The
/// NURBS Book, P4.9.
/// Errors, in this order: those of check_map; point_beyond_horizon; point_not_finite; weight_not_finite;
/// weight_not_positive. Cost O(n).
[[nodiscard]] Result<Curve> transform(const Curve& curve, const PlaneMap& map);

/// The same of the control points `indices` alone, each once, which changes the shape. Error first:
/// point_index_out_of_range.
[[nodiscard]] Result<Curve> transform_points(const Curve& curve, std::span<const std::size_t> indices,
                                             const PlaneMap& map);

/// How far two ways of mapping a curve are apart.
struct MapDifference {
    double distance = 0.0;
    double parameter = 0.0;  ///< where it was found
};

/// The largest distance between the images of points of `curve` and the points of `image`, which is over the same
/// domain, at `count` (>= 2) parameters in equal steps: rounding for image = transform(curve, map). Cost O(count).
MapDifference largest_map_difference(const Curve& curve, const PlaneMap& map, const Curve& image, int count);

}  // namespace batten::core
