/// The derivatives at the ends of a curve, as formulas by the control points there.
#pragma once

#include <optional>

#include "core/curve/curve.h"
#include "core/curve/curve_end.h"

namespace batten::core {

/// A control point that stands in the formulas.
struct EndPoint {
    std::size_t index = 0;
    Point point{};
    double weight = 1.0;
};

/// A knot that stands in them, and how far it is from the end, > 0.
struct EndKnot {
    std::size_t index = 0;  ///< in KnotVector::values()
    double value = 0.0;
    double distance = 0.0;
};

/// C'' = far_factor (P_far - P_end) - near_factor (P_near - P_end), of degree 2 at least:
///     far_factor  = p (p-1) / (h k) * w_far / w_end
///     near_factor = p (p-1) / h (1/h + 1/k) w_near / w_end + 2 p^2 / h^2 (w_near - w_end) w_near / w_end^2
/// for the distances h and k of the knots `near` and `far`. Where the weights are equal it is the difference of two
/// legs,
///     C'' = p (p-1) / h ((P_far - P_near) / k - (P_near - P_end) / h).
struct SecondEndDerivative {
    EndPoint far_point;  ///< the next control point but one
    EndKnot far;         ///< the next knot but one, which may have the value of the next one
    double far_factor = 0.0;
    double near_factor = 0.0;
    Vector value{};
};

/// C' = factor (P_near - P_end), at the upper end with the other sign, where
///     factor = p / h * w_near / w_end
/// is p / (u_{p+1} - u_p) at the start of a clamped curve without weights.
struct EndDerivatives {
    CurveEnd end = CurveEnd::start;
    int degree = 3;
    bool is_rational = false;  ///< the weights of these control points are not equal
    EndKnot end_knot;
    EndKnot near;
    EndPoint end_point;
    EndPoint near_point;
    double factor = 0.0;
    Vector first{};
    std::optional<SecondEndDerivative> second{};  ///< none of degree 1
};

/// The formulas at this end with their numbers. None unless the curve begins or ends in a control point: where it is
/// periodic, or fewer than p knots are equal to the end of the domain. Values may not be finite for huge numbers.
/// Source: The NURBS Book, equations 3.9, 3.10 and 4.9, 4.10.
std::optional<EndDerivatives> end_derivatives(const Curve& curve, CurveEnd end);

}  // namespace batten::core
