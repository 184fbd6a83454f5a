#include "app/editor/derived/support_points.h"

#include <algorithm>
#include <span>

namespace batten::editor {

std::vector<std::size_t> points_with_support(const EditorState& state) {
    const core::Curve* curve = state.visible_active_curve();
    if (curve == nullptr) return {};
    // The others, which may be very many, are above these.
    const std::span selected(state.selection.points);
    const auto first = selected.first(std::min(selected.size(), most_supports));
    std::vector<std::size_t> points(first.begin(), first.end());
    if (points.empty()) {
        if (const auto* point = std::get_if<HoveredPoint>(&state.hover)) points = {point->index};
        if (const auto* ring = std::get_if<HoveredWeightRing>(&state.hover)) points = {ring->index};
        if (const auto* basis = std::get_if<HoveredBasis>(&state.hover)) points = {basis->index};
    }
    std::erase_if(points, [&](std::size_t i) { return i >= curve->control_points().size(); });
    return points;
}

}  // namespace batten::editor
