#include "app/editor/scene/plot_scene.h"

#include <algorithm>
#include <iterator>

#include "app/editor/scene/basis_areas.h"
#include "app/editor/scene/basis_graphs.h"
#include "app/editor/scene/knot_strip.h"
#include "app/editor/scene/plot_axes.h"
#include "app/editor/scene/plot_frame.h"
#include "app/editor/scene/ratio_bar.h"
#include "app/editor/scene/recurrence_lines.h"
#include "app/editor/scene/views.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

/// What tells how many functions and knots there are where not all are shown; empty where they are.
std::string plot_note(const ShownBasis& basis, const ShownStacks& knots) {
    std::size_t diamonds = 0;
    for (const KnotStack& stack : knots.stacks) diamonds += stack.places.size();
    const bool has_all_functions = basis.graphs.size() >= basis.count;
    const bool has_all_knots = diamonds >= knots.count;
    if (has_all_functions && has_all_knots) return "";
    const std::initializer_list<core::Place> places{{"functions", basis.graphs.size()},
                                                    {"function_count", basis.count},
                                                    {"knots", diamonds},
                                                    {"knot_count", knots.count}};
    const char* pattern = has_all_functions ? "Showing {knots} of {knot_count} knots"
                          : has_all_knots
                              ? "Showing {functions} of {function_count} functions"
                              : "Showing {functions} of {function_count} functions and {knots} of {knot_count} knots";
    return core::filled_as_needed(pattern, places);
}

}  // namespace

render::DrawList plot_scene(const EditorState& state, const PlotMode& mode, glm::dvec2 size_px, SceneCache& cache) {
    render::DrawList list;
    if (state.active_curve() == nullptr) return list;
    PlotFrame frame(state, mode, size_px, list);
    const ShownBasis basis = basis_graphs(frame, cache.basis());
    const ShownStacks knots = knot_stacks(frame);
    draw_plot_axes(frame);
    draw_knot_guides(frame, knots.stacks);
    draw_plot_views_below(frame);
    const bool has_areas = shows_basis_areas(frame.state, frame.layout) && !shows_recurrence(frame);
    if (!has_areas) draw_basis_graphs(frame, basis.graphs);
    draw_parameter_line(frame);
    if (!has_areas) draw_basis_values(frame);
    if (!has_areas && !shows_recurrence(frame)) draw_basis_numbers(frame, basis.graphs);
    draw_plot_views_above(frame);
    draw_plot_title(frame, plot_note(basis, knots));
    draw_knot_strip(frame, knots.stacks);
    const std::vector<std::string> unplaced = draw_knot_labels(frame, knots.stacks);
    if (!state.view.parts.window) std::ranges::copy(unplaced, std::back_inserter(cache.unplaced()));
    draw_ratio_bar(frame);
    return list;
}

}  // namespace batten::editor
