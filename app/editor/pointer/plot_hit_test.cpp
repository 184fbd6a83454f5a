#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "app/editor/pointer/hit_test.h"
#include "app/editor/pointer/nearest.h"
#include "app/editor/scene/basis_areas.h"
#include "core/evaluate/basis.h"

namespace batten::editor {
namespace {

/// How near the pointer must be, in design pixels.
namespace plot_reach {
constexpr double knot_diamond = 8.0;
constexpr double parameter = 5.0;
constexpr double graph = 6.0;
constexpr double strip = 16.0;  ///< above and below its axis
}  // namespace plot_reach

std::optional<Hover> hit_knot_marks(const EditorState& state, const PlotLayout& layout, glm::dvec2 position_px) {
    const double reach = plot_reach::knot_diamond * state.view.interface_scale;
    Nearest<std::size_t> nearest(reach);
    for (const KnotMark& mark : knot_marks(state, layout, {position_px.x - reach, position_px.x + reach}))
        nearest.offer(mark.index, glm::distance(position_px, mark.center_px));
    if (!nearest.found()) return std::nullopt;
    const std::span<const double> stored = state.active_curve()->knots().stored();
    std::size_t topmost = *nearest.found();
    while (topmost + 1 < stored.size() && stored[topmost + 1] == stored[*nearest.found()]) ++topmost;
    return HoveredKnot{topmost};
}

bool hits_parameter(const EditorState& state, const PlotLayout& layout, glm::dvec2 position_px) {
    const double scale = state.view.interface_scale;
    const double x = x_from_parameter(layout, state.parameter());
    const double bottom =
        layout.graphs.empty() ? layout.strip_px + plot_reach::strip * scale : layout.graphs.back().upper_px.y;
    return std::abs(position_px.x - x) <= plot_reach::parameter * scale &&
           position_px.y >= layout.top_px - plot_reach::graph * scale && position_px.y <= bottom;
}

/// The area, of those that are stacked, that the pointer is in.
std::optional<Hover> hit_areas(const PlotBasis& functions, double u, double value) {
    const core::BasisValues basis = core::basis_functions(functions.knots(), u);
    double sum = 0.0;
    for (std::size_t j = 0; j < basis.derivatives[0].size(); ++j) {
        const std::optional<std::size_t> function = functions.function(basis.span, j);
        if (!function) continue;
        const double before = sum;
        sum += basis.derivatives[0][j];
        if (before <= value && value < sum) return HoveredBasis{*function};
    }
    return std::nullopt;
}

/// The graph whose tangent at the pointer's u passes nearest to the pointer.
std::optional<Hover> hit_graphs(const EditorState& state, const PlotLayout& layout, glm::dvec2 position_px) {
    const std::shared_ptr<const PlotBasis> functions = state.derived.plot_basis(state.active_curve()->knots());
    const core::KnotVector& knots = functions->knots();
    const double u = parameter_from_x(layout, position_px.x);
    const double scale = state.view.interface_scale;
    if (!knots.domain().contains(u) || position_px.y > layout.bottom_px + plot_reach::graph * scale)
        return std::nullopt;

    const double height_px = layout.bottom_px - layout.top_px;
    if (shows_basis_areas(state, layout))
        return hit_areas(*functions, u, (layout.bottom_px - position_px.y) / height_px);
    const core::BasisValues basis = core::basis_functions(knots, u, 1);
    const double px_per_unit = (layout.right_px - layout.left_px) / layout.range.length();
    double least = plot_reach::graph * scale;
    std::optional<Hover> nearest;
    for (std::size_t j = 0; j < basis.derivatives[0].size(); ++j) {
        const std::optional<std::size_t> function = functions->function(basis.span, j);
        if (!function) continue;
        const double slope = basis.derivatives[1][j] * height_px / px_per_unit;
        const double distance =
            std::abs(y_from_value(layout, basis.derivatives[0][j]) - position_px.y) / std::sqrt(1.0 + slope * slope);
        if (distance > least) continue;
        least = distance;
        nearest = HoveredBasis{*function};
    }
    return nearest;
}

}  // namespace

Hover hit_plot(const EditorState& state, const PlotLayout& layout, glm::dvec2 position_px) {
    const core::Curve* curve = state.active_curve();
    if (curve == nullptr) return HoveredNothing{};
    if (const auto hit = hit_knot_marks(state, layout, position_px)) return *hit;
    if (hits_parameter(state, layout, position_px)) return HoveredParameter{};
    if (const auto hit = hit_graphs(state, layout, position_px)) return *hit;
    const double u = parameter_from_x(layout, position_px.x);
    const bool is_on_strip =
        std::abs(position_px.y - layout.strip_px) <= plot_reach::strip * state.view.interface_scale;
    if (is_on_strip && curve->domain().contains(u)) return HoveredSpan{curve->knots().span_at(u)};
    return HoveredNothing{};
}

}  // namespace batten::editor
