/// Affine changes of the parameter, which keep the shape.
#pragma once

#include "core/curve/curve.h"

namespace batten::core {

/// The same curve over the domain [range.lower, range.upper], whose ends are met exactly; knots in between keep their
/// ratios to the last digits, equal knots stay equal, the kind stays. Errors: parameter_not_finite; range_empty;
/// knots_coincide when different knots are nearer together than doubles are there; not_computable.
[[nodiscard]] Result<Curve> reparametrize(const Curve& curve, Interval range);

/// The same curve with the domain beginning at `lower`, its length kept. Errors likewise.
[[nodiscard]] Result<Curve> shift_domain(const Curve& curve, double lower);

}  // namespace batten::core
