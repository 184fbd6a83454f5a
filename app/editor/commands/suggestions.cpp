#include "app/editor/commands/suggestions.h"

#include "app/editor/pointer/gesture.h"
#include "app/editor/pointer/grid_step.h"
#include "app/editor/pointer/snap.h"
#include "app/editor/state/selected_parts.h"
#include "core/measure/closing.h"

namespace batten::editor::suggest {

double current_parameter(const EditorState& state) {
    return state.parameter();
}

std::optional<std::size_t> selected_knot(const EditorState& state) {
    return state.selection.knot;
}

std::optional<double> selected_knot_value(const EditorState& state) {
    const core::Curve* curve = committed_curve(state);
    if (!state.selection.knot || curve == nullptr) return std::nullopt;
    return curve->knots().stored()[*state.selection.knot];
}

std::optional<std::vector<std::size_t>> selected_points(const EditorState& state) {
    if (state.selection.points.empty()) return std::nullopt;
    return state.selection.points;
}

std::optional<std::size_t> first_selected_point(const EditorState& state) {
    if (state.selection.points.empty()) return std::nullopt;
    return state.selection.points.front();
}

std::optional<std::size_t> last_selected_point(const EditorState& state) {
    if (state.selection.points.empty()) return std::nullopt;
    return state.selection.points.back();
}

std::optional<std::size_t> active_curve(const EditorState& state) {
    if (committed_curve(state) == nullptr) return std::nullopt;
    return state.history.present().active;
}

std::optional<std::vector<std::size_t>> curves_meant(const EditorState& state) {
    if (committed_curve(state) == nullptr) return std::nullopt;
    std::vector<std::size_t> curves = selected_curves(state);
    if (curves.empty()) curves.push_back(state.history.present().active);
    return curves;
}

std::optional<std::vector<core::Point>> points_of_curve(const EditorState& state) {
    const core::Curve* curve = committed_curve(state);
    if (curve == nullptr) return std::nullopt;
    const auto points = curve->control_points();
    if (state.selection.points.size() < 2) return std::vector<core::Point>(points.begin(), points.end());
    std::vector<core::Point> selected;
    for (const std::size_t i : state.selection.points) selected.push_back(points[i]);
    return selected;
}

std::optional<std::string> next_curve_name(const EditorState& state) {
    const core::Document& document = state.history.present();
    if (document.curves.size() < 2) return std::nullopt;
    return document.curves[(document.active + 1) % document.curves.size()].name;
}

std::optional<double> domain_begin(const EditorState& state) {
    const core::Curve* curve = committed_curve(state);
    return curve == nullptr ? std::nullopt : std::optional(curve->domain().lower);
}

std::optional<double> domain_end(const EditorState& state) {
    const core::Curve* curve = committed_curve(state);
    return curve == nullptr ? std::nullopt : std::optional(curve->domain().upper);
}

core::Point middle_of_view(const EditorState& state) {
    return grid_corner(state, core::Point(state.view.camera.center));
}

double grid_step(const EditorState& state) {
    return canvas_grid_steps(state).minor;
}

double tenth_of_grid_step(const EditorState& state) {
    return grid_step(state) / 10.0;
}

std::optional<double> share_of_size(const EditorState& state, double share) {
    const core::Curve* curve = committed_curve(state);
    return curve == nullptr ? std::nullopt : std::optional(core::absolute_tolerance(*curve, share));
}

std::optional<double> tiny_length(const EditorState& state) {
    return share_of_size(state, core::default_closing_tolerance);
}

std::optional<double> hundredth_of_size(const EditorState& state) {
    return share_of_size(state, 1e-2);
}

std::optional<double> thousandth_of_size(const EditorState& state) {
    return share_of_size(state, 1e-3);
}

std::optional<double> tolerance_of_offset(const EditorState& state) {
    return share_of_size(state, offset_tolerance);
}

}  // namespace batten::editor::suggest
