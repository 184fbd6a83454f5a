/// Where curves cross near a place.
#pragma once

#include <span>
#include <vector>

#include "core/measure/near_parts.h"

namespace batten::core {

/// A place where two curves cross, or one crosses itself.
struct NearContact {
    std::size_t first = 0;   ///< which of the curves
    std::size_t second = 0;  ///< likewise; the same where a curve crosses itself
    double u = 0.0;          ///< the parameter on the first curve
    double v = 0.0;          ///< and on the second, or the greater one on the same curve
    Point point{};           ///< the first curve at u
};

/// The contacts within `distance` of `place`, as intersect_curves and self_intersections find them, but not those on
/// stretches that two curves have in common. None where more than 16 spans come so near, which then cannot be told
/// apart. Cost: O(log n) boxes for each curve, and that of a few pairs of spans.
std::vector<NearContact> contacts_near(std::span<const NearParts* const> curves, Point place, double distance);

}  // namespace batten::core
