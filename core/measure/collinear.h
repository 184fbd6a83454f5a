/// Straight pieces: runs of control points on one line, found and made.
#pragma once

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
/// points. A point counts as on the line when it is no farther than `tolerance` (times the larger side of the box of
/// the control points, and never less than the rounding of their coordinates) from the line through the first point
/// and the farthest one so far. In a periodic curve a run may pass the seam; if all points are collinear there is one
/// run of n + p points, the whole curve. Runs whose knots leave no span are left out. Cost O(n).
std::vector<CollinearRun> collinear_runs(const Curve& curve, double tolerance = default_collinear_tolerance);

/// The curve with the control points from `first` to `last` moved squarely onto the line through these two, which stay
/// (shape-changing); with p + 1 points or more a straight piece. When periodic, `last` < `first` means the way across
/// the seam. Errors: point_index_out_of_range; too_few_points (p + 1); points_coincide when `first` and `last` do.
[[nodiscard]] Result<Curve> straighten(const Curve& curve, std::size_t first, std::size_t last);

}  // namespace batten::core
