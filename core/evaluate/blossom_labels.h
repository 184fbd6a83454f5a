/// The blossom arguments that name every control point and every point of the de Boor triangle, and Greville points.
#pragma once

#include <string>
#include <vector>

#include "core/curve/curve.h"

namespace batten::core {

/// The arguments of one blossom: knots of neighboring indices, then the parameter t so many times.
struct BlossomLabel {
    std::size_t first_knot = 0;       ///< index in KnotVector::values() of the first knot
    std::vector<double> knots;        ///< their values
    std::size_t parameter_count = 0;  ///< how often t follows; knots and this make p arguments

    bool operator==(const BlossomLabel&) const = default;
};

/// The label of control point i, u_{i+1}, ..., u_{i+p}; `i` in the numbering of the unrolled points, below their count
/// (n + p when periodic).
BlossomLabel control_point_label(const KnotVector& knots, std::size_t i);

/// The label of the point P_i^r of the triangle of de Boor: u_{i+1}, ..., u_{i+p-r} and t r times. `i` as in
/// DeBoorCell, r = 0..p.
BlossomLabel de_boor_label(const KnotVector& knots, std::size_t i, std::size_t r);

/// All arguments, t in the place of the parameter: what blossom() takes to give the point that is named.
std::vector<double> arguments_of(const BlossomLabel& label, double t);

/// "u4 u5 t", by the indices of the knots.
std::string symbolic_text(const BlossomLabel& label);

/// "0.25 0.5 t", by their values, in the shortest digits that read back to the same number.
std::string value_text(const BlossomLabel& label);

/// A control point over its Greville abscissa, where it acts most; for a straight line the point of the curve itself.
struct GrevillePoint {
    double abscissa = 0.0;  ///< (u_{i+1} + ... + u_{i+p}) / p; outside the domain for end points of unclamped curves
    Point control_point{};
    Point curve_point{};  ///< C at the abscissa brought into the domain
};

/// For each control point in order. Cost O(n p^2).
std::vector<GrevillePoint> greville_points(const Curve& curve);

}  // namespace batten::core
