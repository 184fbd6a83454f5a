/// Makes the knot vectors that have a name: uniform, clamped uniform, Bézier, piecewise Bézier, periodic.
#pragma once

#include "core/curve/knot_vector.h"

namespace batten::core {

/// The vector of `kind` for `point_count` control points over `domain` (lower < upper).
/// Errors: degree_out_of_range; too_few_points (p+1; 2 when periodic); kind_not_possible for custom, for bezier unless
/// point_count = p+1, and for piecewise_bezier unless point_count = k p + 1; those of KnotVector::make for a domain
/// that is none.
[[nodiscard]] Result<KnotVector> make_knots(KnotKind kind, int degree, std::size_t point_count,
                                            Interval domain = {0.0, 1.0});

/// Which ends of an open curve are clamped.
struct ClampedEnds {
    bool start = false;
    bool end = false;
};

/// Equally spaced knots for `point_count` control points over `domain` (lower < upper), beyond it in the same steps
/// except at `clamped` ends, which have multiplicity p+1. Errors: degree_out_of_range; too_few_points (p+1); those of
/// KnotVector::make for a domain that is none.
[[nodiscard]] Result<KnotVector> make_even_knots(int degree, std::size_t point_count, Interval domain,
                                                 ClampedEnds clamped);

}  // namespace batten::core
