/// What a knot vector says about its curves: distinct knots, continuity, segments, Greville abscissae, its kind.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/curve/knot_vector.h"

namespace batten::core {

/// A run of equal knots.
struct DistinctKnot {
    double value = 0.0;
    std::size_t first = 0;     ///< index in KnotVector::values() of the run's first knot
    int multiplicity = 1;      ///< how many knots are equal, across the seam when periodic
    int continuity = 0;        ///< C^(p - multiplicity) there; -1 is a jump
    bool in_domain = false;    ///< inside the closed domain
    bool is_interior = false;  ///< strictly inside the domain, or the seam of a periodic vector

    bool operator==(const DistinctKnot&) const = default;
};

/// The run of equal knots that begins at index `first` of stored(), which is not the upper end of a period.
DistinctKnot distinct_knot(const KnotVector& knots, std::size_t first);

/// The runs of equal knots of stored(), in order. A periodic seam is one entry, at its lower end.
std::vector<DistinctKnot> distinct_knots(const KnotVector& knots);

/// Calls `use` with each of distinct_knots(), in order, keeping none of them.
void visit_distinct_knots(const KnotVector& knots, const std::function<void(const DistinctKnot&)>& use);

/// Non-empty spans of the domain.
std::size_t segment_count(const KnotVector& knots);

/// Both ends of multiplicity p+1 and no knots outside, so that the curve begins and ends in its end points. Never true
/// when periodic.
bool is_clamped(const KnotVector& knots);

/// The interior knots are simple and the knots of the domain equally spaced, up to rounding of their values.
bool is_uniform(const KnotVector& knots);

/// The least continuity at an interior knot; none when the curve is one polynomial piece.
std::optional<int> least_continuity(const KnotVector& knots);

/// The Greville abscissa (u_{i+1} + ... + u_{i+p}) / p of control point i of the unrolled curve: where it acts most.
double greville_abscissa(const KnotVector& knots, std::size_t i);

/// The Greville abscissae, one for each control point.
/// For a periodic vector the values of points 0..n-1 of the unrolled curve, brought into the domain.
std::vector<double> greville_abscissae(const KnotVector& knots);

/// Whether the values satisfy the definition of `kind`; everything satisfies that of custom.
bool is_of_kind(const KnotVector& knots, KnotKind kind);

/// The most special kind that the values satisfy (bezier before clamped_uniform and piecewise_bezier).
KnotKind classify(const KnotVector& knots);

/// The kind that the values say, whether they were typed, loaded or made: kind() where that has a name, since values
/// may satisfy several, else classify(). A vector that is kept as custom may so have a name.
KnotKind kind_by_values(const KnotVector& knots);

}  // namespace batten::core
