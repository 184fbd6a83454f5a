/// Maps of the plane that take lines to lines: affine ones (moved, turned, scaled, sheared, mirrored) and projective
/// ones.
#pragma once

#include <array>

#include "core/base/curve_error.h"
#include "core/base/geometry.h"

namespace batten::core {

/// Takes the point that lies at (x, y) seen from the pivot to the one at (X, Y) / W seen from it, where X, Y and W are
/// the rows times (x, y, 1). The map is affine where the last row begins with two zeros.
struct PlaneMap {
    std::array<std::array<double, 3>, 3> rows{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
    Point pivot{0.0, 0.0};

    bool is_affine() const { return rows[2][0] == 0.0 && rows[2][1] == 0.0; }
    bool operator==(const PlaneMap&) const = default;
};

/// Every point moved by `offset`.
PlaneMap translation(Vector offset);

/// Turned counterclockwise by `degrees` about the pivot, exactly by quarters of a turn.
PlaneMap rotation(double degrees, Point pivot);

/// Stretched from the pivot by a factor along x and another along y; negative ones also mirror.
PlaneMap scaling(double along_x, double along_y, Point pivot);

/// A point one unit above the pivot moves by `x_per_y` to the right, one a unit to the right of it by `y_per_x` upward.
PlaneMap shearing(double x_per_y, double y_per_x, Point pivot);

/// Mirrored in the line through the pivot in the direction `degrees`.
PlaneMap reflection(double degrees, Point pivot);

/// The same map written with the pivot (0, 0), but for rounding.
PlaneMap about_origin(const PlaneMap& map);

/// Where the map takes `point`, rounded once; not finite where that is infinitely far, or too far for a double.
Point mapped(const PlaneMap& map, Point point);

/// W of `point`: what its weight is multiplied by. It is 0, also where rounding of the numbers makes it a little more,
/// on the line that the map takes to infinity, and of different signs on its sides; constant for an affine map.
double weight_factor(const PlaneMap& map, Point point);

/// Whether the map takes different points to different places. Errors, in this order: map_not_finite; map_singular
/// where the determinant is 0 but for rounding.
[[nodiscard]] Result<void> check_map(const PlaneMap& map);

}  // namespace batten::core
