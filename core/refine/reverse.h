/// The same curve run through from its end to its beginning.
#pragma once

#include "core/curve/curve.h"

namespace batten::core {

/// C(a + b - u) over the same domain [a, b]. Points and weights keep every bit.
///
/// Every knot becomes a + b - u, rounded once. Where that does not fit into a double, the bits that are lost cannot
/// come back when the curve is reversed again; but of all numbers that a + b - u may stand for within the rounding of
/// the domain's ends, one of at most 12 digits is preferred, unless it would change a neighboring span by more than a
/// few of its own units. So knots that were typed (0.1, 0.35) come back bit by bit, and so do all others whose
/// reflection is a double; equally spaced knots stay as they are. Errors: knots_coincide when different knots become
/// equal, which only happens to knots that differ by less than the rounding of the domain's ends; not_computable.
[[nodiscard]] Result<Curve> reverse(const Curve& curve);

}  // namespace batten::core
