#include "app/editor/pointer/weight_ring.h"

#include <algorithm>
#include <cmath>

namespace batten::editor {
namespace {

constexpr double least_radius = 9.0;
constexpr double weight_of_greatest = 100.0;

}  // namespace

double ring_radius_px(double weight, double interface_scale) {
    const double share = std::min(1.0, std::log1p(weight) / std::log1p(weight_of_greatest));
    return interface_scale * (least_radius + share * (greatest_ring_radius - least_radius));
}

std::optional<double> weight_ring_radius_px(double weight, double interface_scale) {
    if (weight == 1.0) return std::nullopt;
    return ring_radius_px(weight, interface_scale);
}

std::optional<double> weight_ring_radius_px(const EditorState& state, std::size_t index) {
    const core::Curve* curve = state.active_curve();
    if (curve == nullptr || index >= curve->weights().size()) return std::nullopt;
    const bool is_alone = state.selection.points.size() == 1 && state.selection.points.front() == index;
    const double weight = curve->weights()[index];
    if (is_alone || state.tool == Tool::weight) return ring_radius_px(weight, state.view.interface_scale);
    return weight_ring_radius_px(weight, state.view.interface_scale);
}

}  // namespace batten::editor
