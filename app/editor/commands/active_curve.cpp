#include "app/editor/commands/active_curve.h"

#include <algorithm>
#include <cmath>

#include "app/editor/formula.h"
#include "app/editor/grid_step.h"
#include "core/base/number_text.h"
#include "core/measure/closing.h"

namespace batten::editor {

std::optional<Refusal> no_curve(const EditorState& state) {
    if (state.history.present().active_curve() != nullptr) return std::nullopt;
    return "there is no curve; draw one or open a file";
}

std::optional<Refusal> locked(const core::DocumentCurve& curve) {
    if (!curve.locked) return std::nullopt;
    return "curve '" + curve.name + "' is locked; unlock it in the inspector";
}

std::optional<Refusal> no_editable_curve(const EditorState& state) {
    const core::DocumentCurve* active = state.history.present().active_curve();
    return active == nullptr ? no_curve(state) : locked(*active);
}

std::optional<Refusal> no_editable_points(const EditorState& state) {
    if (std::optional<Refusal> refusal = no_editable_curve(state)) return refusal;
    if (state.selection.points.empty()) return "no control point is selected";
    return std::nullopt;
}

const core::Curve& active_curve(const EditorState& state) {
    return *state.history.present().active_curve()->curve;
}

std::optional<Argument> current_parameter(const EditorState& state) {
    return state.parameter();
}

std::optional<Argument> selected_knot(const EditorState& state) {
    if (!state.selection.knot) return std::nullopt;
    return static_cast<double>(*state.selection.knot);
}

std::optional<Argument> selected_points(const EditorState& state) {
    if (state.selection.points.empty()) return std::nullopt;
    return std::vector<double>(state.selection.points.begin(), state.selection.points.end());
}

std::optional<Argument> active_index(const EditorState& state) {
    if (state.history.present().active_curve() == nullptr) return std::nullopt;
    return static_cast<double>(state.history.present().active);
}

std::optional<Argument> grid_step(const EditorState& state) {
    return minor_grid_step(state.view.camera.scale / state.view.interface_scale);
}

std::optional<Argument> share_of_size(const EditorState& state, double share) {
    if (state.history.present().active_curve() == nullptr) return std::nullopt;
    return core::absolute_tolerance(active_curve(state), share);
}

std::optional<Argument> tiny_length(const EditorState& state) {
    return share_of_size(state, core::default_closing_tolerance);
}

Outcome<std::size_t> index_of(double value, const char* what) {
    constexpr double most = 1e9;
    if (value < 0.0 || value > most || value != std::floor(value))
        return tl::unexpected(std::string(what) + " is " + core::shortest_text(value) + "; a whole number from 0" +
                              (value > most ? " to 1000000000" : "") + " is needed");
    return static_cast<std::size_t>(value);
}

Outcome<std::vector<std::size_t>> indices_of(const std::vector<double>& values, const char* what) {
    std::vector<std::size_t> indices;
    for (const double value : values) {
        const Outcome<std::size_t> index = index_of(value, what);
        if (!index) return tl::unexpected(index.error());
        indices.push_back(*index);
    }
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    return indices;
}

Outcome<Edit> edit_active(const EditorState& state, core::Result<core::Curve> curve,
                          std::optional<Selection> selection) {
    if (!curve) return tl::unexpected(core::describe(curve.error()));
    Edit edit{state.history.present(), std::move(selection)};
    edit.document.curves[edit.document.active].curve = std::make_shared<const core::Curve>(*std::move(curve));
    return edit;
}

std::string point_text(double index) {
    return plain_text("P_{" + number_text(index, 17) + "}");
}

std::string points_text(const std::vector<double>& indices) {
    return indices.size() == 1 ? point_text(indices.front()) : std::to_string(indices.size()) + " points";
}

}  // namespace batten::editor
