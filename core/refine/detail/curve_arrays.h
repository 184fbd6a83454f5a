/// The arrays of a curve, and knots coming into them.
#pragma once

#include "core/curve/curve.h"
#include "core/curve/detail/boehm.h"

namespace batten::core {

/// What an open spline is made of: points + p + 1 knots, and as many weights as points.
struct CurveArrays {
    std::size_t p = 0;  ///< degree
    std::span<const double> knots;
    std::span<const Point> points;
    std::span<const double> weights;
    bool is_rational = false;  ///< the weights are not all equal

    Interval domain() const { return {knots[p], knots[points.size()]}; }
};

/// Those of an open curve.
CurveArrays arrays_of(const Curve& curve);

/// Arrays that are being written.
struct NewCurveArrays {
    NewArray<double> knots;
    NewArray<Point> points;
    NewArray<double> weights;
    InsertedRange changed{};  ///< the points outside of it are those of the curve before
};

/// The same spline with the knots `added`, under the conditions of boehm.h. Points that no new knot reaches keep every
/// bit; of the others a coordinate may not be finite where it is too large for its differences. Cost: at most p blends
/// for each knot, and one copy of everything.
NewCurveArrays refined(const CurveArrays& arrays, std::span<const double> added);

/// Whether all weights are equal.
bool are_equal(std::span<const double> weights);

}  // namespace batten::core
