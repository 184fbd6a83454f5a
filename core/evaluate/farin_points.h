/// Farin's points on the legs of the control polygon, which show the ratios of neighboring weights.
#pragma once

#include <cstddef>
#include <optional>

#include "core/curve/curve.h"

namespace batten::core {

/// How many legs the control polygon has: one for each point of a periodic curve, else one less.
std::size_t leg_count(const Curve& curve);

/// The point of a leg that divides it in the inverse ratio of the weights at its ends.
struct FarinPoint {
    Point point{};
    double share = 0.5;  ///< how much of the way from P_i to P_{i+1} it lies: w_{i+1} / (w_i + w_{i+1})
};

/// The Farin point of leg `leg` (below leg_count), from point i = leg to the next one: F_i = (w_i P_i + w_{i+1}
/// P_{i+1}) / (w_i + w_{i+1}), the middle where both weights are equal. Source: Farin 2002, chapter 13 (weight points).
FarinPoint farin_point(const Curve& curve, std::size_t leg);

/// The shares that a Farin point can be dragged to: a weight is at most a million times its neighbor.
inline constexpr Interval farin_shares{1e-6, 1.0 - 1e-6};

/// The share, within farin_shares, of the place on leg `leg` (below leg_count) that is nearest to `position`; none
/// where the leg has no length.
std::optional<double> nearest_farin_share(const Curve& curve, std::size_t leg, Point position);

}  // namespace batten::core
