#include "app/editor/scene/plot_scene.h"

#include "app/editor/scene/basis_graphs.h"
#include "app/editor/scene/knot_strip.h"
#include "app/editor/scene/plot_axes.h"
#include "app/editor/scene/plot_frame.h"

namespace batten::editor {

render::DrawList plot_scene(const EditorState& state, const PlotMode& mode, glm::dvec2 size_px) {
    render::DrawList list;
    if (state.active_curve() == nullptr) return list;
    PlotFrame frame(state, mode, size_px, list);
    const std::vector<BasisGraph> graphs = basis_graphs(frame);
    draw_plot_axes(frame);
    draw_knot_guides(frame);
    draw_basis_graphs(frame, graphs);
    draw_parameter_line(frame);
    draw_basis_values(frame);
    draw_basis_numbers(frame, graphs);
    draw_plot_title(frame);
    draw_knot_strip(frame);
    draw_knot_labels(frame);
    return list;
}

}  // namespace batten::editor
