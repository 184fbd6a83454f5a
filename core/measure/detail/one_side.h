/// What can be said of a curve on one side of a place, and how far rounding of its coordinates blurs it.
#pragma once

#include <array>
#include <optional>

#include "core/evaluate/evaluate.h"

namespace batten::core {

inline constexpr int derivatives_of_side = 3;

/// The errors of a point and its derivatives that rounded coordinates explain.
using JetNoise = std::array<double, derivatives_of_side + 1>;

struct OneSide {
    Jet jet{};  ///< with all these derivatives; the point seen from the origin asked for
    JetNoise noise{};
    std::optional<Vector> tangent{};
    std::optional<double> curvature{};
};

/// What the rounding of the coordinates in `box` leaves, a few units.
double rounding_in(const Box& box);

/// The curve at `u`, seen from `origin`, near which differences keep their digits; `rounding` is that of its points.
/// Cost O(p^3) however long the curve is.
OneSide look_at_side(const Curve& curve, double u, Side side, Point origin, double rounding);

}  // namespace batten::core
