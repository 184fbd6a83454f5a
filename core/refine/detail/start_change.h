/// Another beginning for a curve: where it starts and how it goes on, with nothing changed behind a parameter.
#pragma once

#include "core/curve/curve.h"
#include "core/evaluate/evaluate.h"

namespace batten::core {

/// The least degree in which a start with so many derivatives can be given.
constexpr int least_degree_of_change(std::size_t derivatives) {
    return derivatives < 3 ? 3 : 4;
}

/// `curve`, open, clamped at both ends and of that degree or more, with the point and the derivatives at its start that
/// `wanted` has, at most three of these. From `until` on, which is behind the start and in the domain, it is the same
/// curve, bit by bit; before it a spline of its own degree is added to the numerator, which ends there with as many
/// equal derivatives as the inserted knots allow: two at least, three where three are wanted. So no knot of the curve
/// becomes less smooth in its parameter. As many knots are inserted as values are wanted, those that are there are
/// used. Cost O(p) for each of the points before `until` plus the copying.
[[nodiscard]] Result<Curve> with_start(const Curve& curve, const Jet& wanted, double until);

}  // namespace batten::core
