#include "app/editor/scene/plot_frame.h"

#include <algorithm>

#include "app/editor/state/point_hues.h"

namespace batten::editor {

namespace {

std::vector<std::size_t> chosen(const EditorState& state, const PlotMode& mode) {
    std::vector<std::size_t> indices;
    if (const auto* hovered = std::get_if<HoveredKnot>(&state.hover)) indices.push_back(hovered->index);
    if (const auto* dragged = std::get_if<DraggingKnot>(&mode)) indices.push_back(dragged->index);
    if (state.selection.knot) indices.push_back(*state.selection.knot);
    return indices;
}

}  // namespace

PlotFrame::PlotFrame(const EditorState& shown_state, const PlotMode& mode, glm::dvec2 size_px, render::DrawList& list)
    : state(shown_state),
      theme(shown_theme(shown_state.view)),
      pen(list, size_px, shown_state.view.interface_scale, shown_state.view.notation),
      layout(plot_layout(shown_state, size_px)),
      curve(*shown_state.active_curve()),
      lit(highlight(shown_state)),
      basis(shown_state.derived.plot_basis(curve.knots())),
      u(shown_state.parameter()),
      span(curve.knots().span_at(u)),
      chosen_knots(chosen(shown_state, mode)) {}

std::size_t PlotFrame::hue(std::size_t i) const {
    return point_hue(*state.shown().active_curve(), i);
}

std::size_t PlotFrame::function_of(std::size_t span_index, std::size_t j) const {
    return (span_index - static_cast<std::size_t>(curve.degree()) + j) % curve.control_points().size();
}

std::optional<render::PixelBox> PlotFrame::band(core::Interval parameters) const {
    const double lower = std::max(parameters.lower, layout.range.lower);
    const double upper = std::min(parameters.upper, layout.range.upper);
    if (!(lower < upper)) return std::nullopt;
    return render::PixelBox{{x(lower), layout.top_px}, {x(upper), layout.bottom_px}};
}

bool PlotFrame::is_chosen(std::size_t stored_index) const {
    const auto stored = curve.knots().stored();
    return std::any_of(chosen_knots.begin(), chosen_knots.end(), [&](std::size_t index) {
        return index < stored.size() && stored[index] == stored[stored_index];
    });
}

}  // namespace batten::editor
