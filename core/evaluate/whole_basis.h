/// The basis functions over the whole of their supports, beyond the domain too.
#pragma once

#include "core/curve/knot_vector.h"

namespace batten::core {

/// A vector over which basis functions can be evaluated wherever they do not vanish.
struct WholeBasis {
    KnotVector knots;       ///< its domain reaches from the first knot to the last
    std::size_t first = 0;  ///< N_{i,p} of the original vector is its function first + i
};

/// The vector with both ends raised to multiplicity p+1, which changes none of its functions; those that are added, at
/// both ends, make the sum 1 where it was less. Of a periodic vector: of its unrolled knots, whose functions are
/// numbered without wrapping. Cost O(n).
WholeBasis whole_basis(const KnotVector& knots);

}  // namespace batten::core
