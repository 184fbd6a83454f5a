/// What lies inside closed curves.
#pragma once

#include <optional>
#include <span>

#include "core/base/names.h"
#include "core/curve/curve.h"

namespace batten::core {

/// Which places closed curves enclose, by how often they run around them.
enum class InsideRule {
    even_odd,  ///< an odd number of times
    non_zero   ///< any number of times, counter-clockwise less clockwise, but 0
};

template <>
struct Names<InsideRule> {
    static constexpr std::array table{Named{InsideRule::even_odd, "even-odd", "even-odd"},
                                      Named{InsideRule::non_zero, "non-zero", "non-zero"}};
};

/// Whether a place with this winding number is inside by `rule`.
constexpr bool is_inside(int winding, InsideRule rule) {
    return rule == InsideRule::even_odd ? winding % 2 != 0 : winding != 0;
}

/// How often `curves` together run around `place`, counter-clockwise being positive; none on a curve, but for the
/// rounding of coordinates. Ends that do not meet are taken as if a line joined them. Cost O(n p^2), of which only
/// pieces near the place are halved. Source: a piece whose box does not contain the place may be replaced by its chord.
std::optional<int> winding_number(std::span<const Curve> curves, Point place);

}  // namespace batten::core
