/// The conditions at the ends of a curve made from points, as control points of a spline system.
#pragma once

#include <vector>

#include "core/evaluate/detail/spline_system.h"
#include "core/make/ends.h"

namespace batten::core {

/// How many derivatives are prescribed at both ends, and the least degree that has them.
struct EndNeeds {
    std::size_t at_start = 0;
    std::size_t at_end = 0;
    int least_degree = min_degree;

    std::size_t count() const { return at_start + at_end; }
};

EndNeeds needs_of(const Ends& ends);

inline bool is_closed(const Ends& ends) {
    return std::holds_alternative<ClosedEnds>(ends);
}

/// Error: degree_too_low for what is prescribed.
Result<void> check_degree_of_ends(const Ends& ends, int degree);

/// Error: vector_not_finite.
Result<void> check_tangents(const Ends& ends);

/// The control points that the ends decide over clamped `knots`: the first and the last, and beside an end with a
/// condition the next one, known or bound to the one after it.
EndPoints end_points(Point first, Point last, const Ends& ends, const KnotVector& knots);

}  // namespace batten::core
