#include "app/editor/derived/support_points.h"

#include <algorithm>

namespace batten::editor {

std::vector<std::size_t> points_with_support(const EditorState& state) {
    const core::Curve* curve = state.visible_active_curve();
    if (curve == nullptr) return {};
    std::vector<std::size_t> points = state.selection.points;
    if (points.empty()) {
        if (const auto* point = std::get_if<HoveredPoint>(&state.hover)) points = {point->index};
        if (const auto* ring = std::get_if<HoveredWeightRing>(&state.hover)) points = {ring->index};
        if (const auto* basis = std::get_if<HoveredBasis>(&state.hover)) points = {basis->index};
    }
    std::erase_if(points, [&](std::size_t i) { return i >= curve->control_points().size(); });
    points.resize(std::min(points.size(), most_supports));
    return points;
}

}  // namespace batten::editor
