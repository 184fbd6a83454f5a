/// Straight pieces: runs of control points on one line.
#pragma once

#include <span>
#include <vector>

#include "core/curve/curve.h"

namespace batten::core {

/// Control points on one line.
struct CollinearRun {
    std::size_t first = 0;  ///< index of a control point
    std::size_t count = 0;  ///< at least p + 1; they are first, first + 1, ..., counted on past n - 1 when periodic
    /// Where the curve is straight: between the knots u_{first + p} and u_{first + count}, unwrapped when periodic.
    Interval straight;
};

/// How far a point of a run may be off its line, as a part of the larger side of the box of the control points.
inline constexpr double default_collinear_tolerance = 1e-12;

/// The maximal runs of p + 1 or more neighboring control points that lie on one line, in order; neighbors may share
/// points. A point counts as on the line when it is no farther than `tolerance` (>= 0, times the larger side of the box
/// of the control points, and never less than the rounding of their coordinates) from the line through the first point
/// and the farthest one so far. In a periodic curve a run may pass the seam; if all points are collinear there is one
/// run of n + p points, the whole curve. Runs whose knots leave no span are left out. Cost O(n).
std::vector<CollinearRun> collinear_runs(const Curve& curve, double tolerance = default_collinear_tolerance);

/// Whether these points, at least one, are on one line in the same sense, `tolerance` being of their own box.
bool are_collinear(std::span<const Point> points, double tolerance = default_collinear_tolerance);

}  // namespace batten::core
