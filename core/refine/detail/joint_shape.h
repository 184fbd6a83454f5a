/// How a curve has to begin so that it continues another one, and how much of it has to change for that.
#pragma once

#include "core/evaluate/evaluate.h"
#include "core/refine/join.h"

namespace batten::core {

/// How many derivatives, or directions and curvatures, must agree.
int order_of(JoinContinuity continuity);

/// The start that a curve which begins like `second` must have to continue `side` with this many of its direction,
/// curvature and change of curvature: with the speed that it has, and with its acceleration along the tangent. Error:
/// curve_stands_still.
[[nodiscard]] Result<Jet> start_after(const Passing& side, const Curve& second, int order);

/// The start that `second` must have to continue `first`: with the same derivatives for C; for G as start_after() says.
/// Error: curve_stands_still.
[[nodiscard]] Result<Jet> wanted_start(const Curve& first, const Curve& second, JoinContinuity continuity);

/// Whether `second` begins as `wanted`, but for what rounding leaves in its first control points.
bool begins_as(const Curve& second, const Jet& wanted);

/// Up to where `second` is to be changed for it to begin as `wanted`: above the lower end of the domain.
double end_of_change(const Curve& second, const Jet& wanted);

}  // namespace batten::core
