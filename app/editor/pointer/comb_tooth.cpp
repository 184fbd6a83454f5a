#include "app/editor/pointer/comb_tooth.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {

namespace {

constexpr double tooth_length = 60.0;    // of the large curvature
constexpr double longest_tooth = 180.0;  // near cusps
constexpr double tooth_share = 0.25;     // of the longer side of the control points' box, in a figure
constexpr double handle_distance = 26.0;

}  // namespace

std::optional<CombScale> comb_scale(const EditorState& state, const core::Curve& curve, double factor) {
    const double large = state.derived.large_curvature(curve);
    if (!(large > 0.0) || !std::isfinite(large)) return std::nullopt;
    const double px = state.view.interface_scale;
    double longest = px * longest_tooth * std::max(1.0, factor);
    // A window can be moved; a figure shows its comb whole, and the curve not much smaller for it.
    if (!state.view.parts.window) {
        const core::Box box = core::control_box(curve);
        const double size = std::max(box.upper.x - box.lower.x, box.upper.y - box.lower.y);
        longest = std::min(longest, tooth_share * size * state.view.camera.scale * std::max(1.0, factor));
    }
    return CombScale{px * tooth_length * factor / large, longest};
}

std::optional<Tooth> tooth_at(const core::Curve& curve, double u, core::Side side, const CombScale& scale) {
    const auto curvature = core::curvature_at(curve, u, side);
    if (!curvature || !std::isfinite(*curvature)) return std::nullopt;
    const core::Jet at = core::derivatives_at(curve, u, 1, side);
    const core::Vector tangent = at[1] / core::robust_length(at[1]);
    const double length = std::clamp(*curvature * scale.px_per_curvature, -scale.longest_px, scale.longest_px);
    return Tooth{at.point, {tangent.y, tangent.x}, length};
}

std::optional<CombHandle> comb_handle(const EditorState& state, double factor) {
    const core::Curve* curve = state.visible_active_curve();
    if (curve == nullptr || !state.view.overlays.is_shown(Overlay::curvature_comb)) return std::nullopt;
    const auto scale = comb_scale(state, *curve, factor);
    if (!scale) return std::nullopt;
    const auto tooth = tooth_at(*curve, state.parameter(), core::Side::right, *scale);
    if (!tooth) return std::nullopt;
    const double least = handle_distance * state.view.interface_scale;
    const double length = std::copysign(std::max(std::abs(tooth->length_px), least), tooth->length_px);
    const glm::dvec2 foot = render::screen_from_world(state.view.camera, tooth->foot);
    return CombHandle{foot, foot + length * tooth->direction};
}

double dragged_comb_factor(const EditorState& state, double factor, glm::dvec2 moved_px) {
    const auto handle = comb_handle(state, factor);
    if (!handle) return factor;
    const glm::dvec2 arm = handle->place_px - handle->foot_px;
    const double length = glm::length(arm);
    const double dragged = length + glm::dot(moved_px, arm) / length;
    return comb_factors.clamp(factor * std::max(dragged, 0.0) / length);
}

}  // namespace batten::editor
