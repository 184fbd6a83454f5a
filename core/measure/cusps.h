/// Where a curve comes to a stop.
#pragma once

#include <optional>
#include <vector>

#include "core/curve/curve.h"

namespace batten::core {

/// A place of zero speed.
struct Cusp {
    Interval where;  ///< one parameter, or a whole piece that is a single point
    double u = 0.0;  ///< the middle of `where`
    Point point{};   ///< C(u)
    /// By how much the tangent turns, in (-pi, pi]: pi at a proper cusp, 0 where the curve only hesitates. None at the
    /// ends of an open curve.
    std::optional<double> turn;
};

/// All places of zero speed, in order of u: the common zeros of both coordinates of the hodograph, found globally.
/// Speeds that rounding cannot tell from zero are zero.
std::vector<Cusp> cusps(const Curve& curve);

}  // namespace batten::core
