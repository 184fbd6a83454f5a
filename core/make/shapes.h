/// Makes what needs no more than its points: lines, polylines, regular polygons and Bézier paths.
#pragma once

#include <span>

#include "core/curve/curve.h"

namespace batten::core {

/// The line from `from` to `to`, of degree 1 over [0, 1]. Errors: points_coincide; point_not_finite.
[[nodiscard]] Result<Curve> line(Point from, Point to);

/// The polyline through `points`, of degree 1, one unit of the parameter for each leg; periodic when `is_closed`, with
/// one leg more. Errors: too_few_points (2, or 3 when closed); points_coincide where neighbors are equal;
/// point_not_finite.
[[nodiscard]] Result<Curve> polyline(std::span<const Point> points, bool is_closed = false);

/// The regular polygon of `sides` (>= 3) sides in a circle, counter-clockwise, with its first corner in the direction
/// `start` in degrees; a periodic polyline. Errors: too_few_points; length_not_positive; points_coincide where
/// the center is so far away that corners cannot be told apart; point_not_finite.
[[nodiscard]] Result<Curve> regular_polygon(Point center, double radius, std::size_t sides, double start = 90.0);

/// Cubic Bézier pieces one after another, one unit of the parameter for each: a point, two handles, a point, and so on;
/// a closed path leaves out the last point, which is the first, and is periodic. Errors: kind_not_possible unless there
/// are 3 k + 1 points, or 3 k of a closed one, k >= 1; point_not_finite.
[[nodiscard]] Result<Curve> bezier_path(std::span<const Point> points, bool is_closed = false);

}  // namespace batten::core
