/// One knot that could be removed: the points that would stand in its place and a bound of the error.
#pragma once

#include <optional>

#include "core/refine/detail/carried_point.h"

namespace batten::core {

/// The removal of knot `index` of `spline` in unrolled_for_removal().
struct RemovableKnot {
    std::size_t index = 0;             ///< the last one that equals it
    std::size_t first = 0;             ///< the first of the points to be replaced
    std::size_t replaced = 0;          ///< how many there are
    std::vector<CarriedPoint> points;  ///< one fewer
    double bound = 0.0;                ///< the curve moves by no more than this; infinite where that is not known
    bool from_upper_end = false;       ///< of a seam named at both ends of the period: which of them loses a knot
};

/// The spline whose knots `index` counts: that of `curve`, with one whole period more on both sides when periodic.
CarriedSpline unrolled_for_removal(const Curve& curve);

/// The index of the lower end of a period there; 0 for an open curve.
std::size_t removal_offset(const Curve& curve);

/// Whether the reach of a removal is less than a period, so that it does not meet its own repetitions.
bool has_room_for_removal(const Curve& curve);

/// The last knot of every run that may lose a knot: strictly inside the domain, and at a periodic seam if its
/// multiplicity is above 1.
std::vector<std::size_t> removable_indices(const Curve& curve, const CarriedSpline& spline);

/// What removing knot `index`, strictly inside the domain and the last of its run, would do; none when a weight would
/// not be positive. Cost O(p).
std::optional<RemovableKnot> removable_knot(const CarriedSpline& spline, std::size_t index);

/// Another bound of how far the curve moves without the knot, or the same: near the true distance where the weights
/// differ by much, as long as the curve does not move by more than `most` at the knot itself. Cost O(p^2) for each of
/// the spans that the knot reaches.
double nearer_bound(const CarriedSpline& spline, const RemovableKnot& knot, double most);

/// `curve` without these knots, at least one, ascending and degree + 2 or more apart, across the seam too.
[[nodiscard]] Result<Curve> without_knots(const Curve& curve, const CarriedSpline& spline,
                                          std::span<const RemovableKnot> removed);

/// A periodic curve without one knot of value `u`, where there is no room: the least squares solution of all equations
/// of inserting the knot again, each divided by its weight, and a bound of how far the curve moves. Cost O(n^3) for n
/// <= p + 1.
struct CrampedRemoval {
    Curve curve;
    double bound = 0.0;
};
std::optional<CrampedRemoval> cramped_removal(const Curve& curve, double u);

}  // namespace batten::core
