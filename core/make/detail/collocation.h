/// The control points of an open cubic spline through points, by elimination without pivoting.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/evaluate/detail/spline_system.h"

namespace batten::core {

/// One site for each control point, ascending: where the spline passes the point of the same number. The ends say what
/// holds instead for the first and last two control points, whose points are then any near them. Site r lies between
/// the knots r+1 and r+3, as it does where knots are means of sites.
struct CubicCollocation {
    std::span<const double> knots;
    std::span<const double> sites;
    std::span<const Point> points;
    const EndPoints& ends;
};

/// The control points, right to about a unit in the last place of the largest coordinate; none where that cannot be
/// promised. The equations are a totally positive band of two on both sides of its diagonal, which needs no pivots and
/// can be eliminated from both ends at once; a processor does that side by side. The unknowns are how far the control
/// points are from the points, which is all that rounding is in proportion to. Cost O(n). Source: de Boor and Pinkus
/// 1977; de Boor 1978, chapter XIII.
std::optional<std::vector<Point>> collocated(const CubicCollocation& given);

}  // namespace batten::core
