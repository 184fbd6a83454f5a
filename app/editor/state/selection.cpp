#include "app/editor/state/selection.h"

#include <algorithm>

namespace batten::editor {

bool Selection::contains_point(std::size_t i) const {
    return std::binary_search(points.begin(), points.end(), i);
}

std::optional<double> hovered_u(const Hover& hover) {
    if (const auto* curve = std::get_if<HoveredCurve>(&hover)) return curve->u;
    if (const auto* lifted = std::get_if<HoveredLifted>(&hover)) return lifted->u;
    if (const auto* hodograph = std::get_if<HoveredHodograph>(&hover)) return hodograph->u;
    return std::nullopt;
}

std::optional<std::size_t> hovered_leg(const Hover& hover) {
    if (const auto* leg = std::get_if<HoveredLeg>(&hover)) return leg->index;
    const auto* hodograph = std::get_if<HoveredHodograph>(&hover);
    return hodograph != nullptr && hodograph->order == 1 ? hodograph->index : std::nullopt;
}

}  // namespace batten::editor
