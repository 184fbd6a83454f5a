#include "app/editor/pointer/plot_layout.h"

#include <algorithm>
#include <cmath>

namespace batten::editor {
namespace {

/// Heights in design pixels, at the least and at the usual height of the dock; linear between.
struct Heights {
    double above_plot;   ///< the title row and room for the numbers of the graphs
    double below_plot;   ///< from N = 0 to the strip's axis: stacks of diamonds
    double below_strip;  ///< two rows of labels
};
constexpr double least_height = 160.0;
constexpr double usual_height = 260.0;
constexpr Heights least_heights{40.0, 26.0, 46.0};
constexpr Heights usual_heights{44.0, 54.0, 54.0};
constexpr double stack_room_growth = 0.15;  ///< of what the dock is higher than usual
constexpr double plot_side_margin = 32.0;
constexpr double diamond_height = 8.0;
constexpr double widest_stack_step = 10.0;
constexpr double stack_clearance = 4.0;  ///< between the highest diamond and the plot

constexpr double usual_graph_height = 82.0;
constexpr double least_graph_height = 46.0;
constexpr double graph_gap = 8.0;  ///< below each

/// What each of `count` graphs below the strip gets of a dock of this height, with its gap.
double graph_height(double height, std::size_t count) {
    if (count == 0) return 0.0;
    const double room = (height - least_height) / static_cast<double>(count);
    return std::clamp(room, least_graph_height, usual_graph_height);
}

Heights heights_for(double height) {
    const double t = std::clamp((height - least_height) / (usual_height - least_height), 0.0, 1.0);
    const auto between = [t](double a, double b) { return a + t * (b - a); };
    const double extra = stack_room_growth * std::max(0.0, height - usual_height);
    return {between(least_heights.above_plot, usual_heights.above_plot),
            between(least_heights.below_plot, usual_heights.below_plot) + extra,
            between(least_heights.below_strip, usual_heights.below_strip)};
}

/// How many diamonds stand on others in the highest stack. Cost: as far as the first stack that can be no higher, which
/// a clamped curve begins with.
std::size_t steps_of_highest_stack(const core::Curve* curve) {
    std::size_t most = 0;
    if (curve == nullptr) return most;
    const std::span<const double> knots = curve->knots().stored();
    std::size_t steps = 0;
    for (std::size_t i = 1; i < knots.size() && most < static_cast<std::size_t>(curve->degree()); ++i) {
        steps = knots[i] == knots[i - 1] ? steps + 1 : 0;
        most = std::max(most, steps);
    }
    return most;
}

}  // namespace

std::vector<core::Quantity> plotted_now(const View& view) {
    std::vector<core::Quantity> quantities;
    for (const PlottedQuantity& plotted : plotted_quantities)
        if (view.overlays.is_shown(plotted.overlay)) quantities.push_back(plotted.quantity);
    return quantities;
}

double height_of_plots(const View& view) {
    return usual_graph_height * static_cast<double>(plotted_now(view).size());
}

core::Interval whole_plot_range(const EditorState& state) {
    // A knot that is dragged does not move the axis below it, but another curve has one of its own.
    const core::Document& present = state.history.present();
    const bool is_same = state.shown().active == present.active;
    const core::DocumentCurve* item = is_same ? present.active_curve() : nullptr;
    const core::Curve* curve = item != nullptr ? item->curve.get() : state.active_curve();
    if (curve == nullptr) return {0.0, 1.0};
    const std::span<const double> knots = curve->knots().stored();
    return {knots.front(), knots.back()};
}

PlotLayout plot_layout(const EditorState& state, glm::dvec2 size_px) {
    const double scale = state.view.interface_scale;
    const std::size_t graph_count = plotted_now(state.view).size();
    const double graph_px = scale * graph_height(size_px.y / scale, graph_count);
    size_px.y -= static_cast<double>(graph_count) * graph_px;
    const Heights heights = heights_for(size_px.y / scale);
    PlotLayout layout;
    layout.range = state.view.plot_range.value_or(whole_plot_range(state));
    layout.left_px = plot_side_margin * scale;
    layout.right_px = std::max(size_px.x - plot_side_margin * scale, layout.left_px + 1.0);
    layout.top_px = heights.above_plot * scale;
    layout.labels_px = heights.below_strip * scale;
    layout.strip_px = size_px.y - layout.labels_px;
    layout.bottom_px = std::max(layout.strip_px - heights.below_plot * scale, layout.top_px + 1.0);
    layout.diamond_px = diamond_height * scale;
    for (std::size_t k = 0; k < graph_count; ++k) {
        const double top = size_px.y + static_cast<double>(k) * graph_px;
        layout.graphs.push_back({{layout.left_px, top}, {layout.right_px, top + graph_px - graph_gap * scale}});
    }

    const auto steps = static_cast<double>(std::max<std::size_t>(1, steps_of_highest_stack(state.active_curve())));
    const double room = std::max(1.0, heights.below_plot - diamond_height - stack_clearance);
    layout.stack_px = scale * std::min(widest_stack_step, room / steps);
    return layout;
}

double x_from_parameter(const PlotLayout& layout, double u) {
    return layout.left_px + (u - layout.range.lower) / layout.range.length() * (layout.right_px - layout.left_px);
}

double parameter_from_x(const PlotLayout& layout, double x_px) {
    return layout.range.lower + (x_px - layout.left_px) / (layout.right_px - layout.left_px) * layout.range.length();
}

double y_from_value(const PlotLayout& layout, double value) {
    return layout.bottom_px - value * (layout.bottom_px - layout.top_px);
}

std::vector<KnotMark> knot_marks(const EditorState& state, const PlotLayout& layout) {
    return knot_marks(state, layout, {layout.left_px - layout.diamond_px, layout.right_px + layout.diamond_px});
}

std::vector<KnotMark> knot_marks(const EditorState& state, const PlotLayout& layout, core::Interval x_px) {
    std::vector<KnotMark> marks;
    const core::Curve* curve = state.active_curve();
    if (curve == nullptr) return marks;
    const std::span<const double> knots = curve->knots().stored();
    const auto is_left = [&](double u, double x) { return x_from_parameter(layout, u) < x; };
    const auto begin = std::lower_bound(knots.begin(), knots.end(), x_px.lower, is_left);
    double rise = 0.0;
    for (auto knot = begin; knot != knots.end() && x_from_parameter(layout, *knot) <= x_px.upper; ++knot) {
        rise = knot != begin && *knot == *std::prev(knot) ? rise + layout.stack_px : 0.0;
        const auto index = static_cast<std::size_t>(knot - knots.begin());
        marks.push_back({index, {x_from_parameter(layout, *knot), layout.strip_px - rise}});
    }
    return marks;
}

}  // namespace batten::editor
