/// Curves of parts that an operation has kept valid.
#pragma once

#include <utility>
#include <vector>

#include "core/curve/curve.h"

namespace batten::core {

/// Makes what KnotVector::make and Curve::make would make, without reading every number again to check it. Only for
/// parts that cannot be wrong: those of a valid curve, and what an operation that keeps curves valid made of them.
struct Trusted {
    /// `values` as KnotVector::values() holds them, which are of `kind`.
    static KnotVector knots(int degree, bool is_periodic, KnotKind kind, std::vector<double> values);

    /// `values` as KnotVector::values() holds them, of `kind` where they have it, else custom. Cost: that of
    /// is_of_kind.
    static KnotVector knots_of_kind_or_custom(int degree, bool is_periodic, KnotKind kind, SharedArray<double> values);

    /// The points are finite, the weights positive; `is_rational` says whether these differ.
    static Curve curve(KnotVector knots, std::vector<Point> points, std::vector<double> weights, bool is_rational);
    static Curve curve(KnotVector knots, SharedArray<Point> points, SharedArray<double> weights, bool is_rational);

    /// The curve with other points, as many, which are finite; it shares all the rest.
    static Curve with_points(const Curve& curve, std::vector<Point> points);
};

}  // namespace batten::core
