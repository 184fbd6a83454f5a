/// What suggests itself for the fields of commands, from the selection, the parameter, the view and the active curve.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/editor/state/state.h"

namespace batten::editor::suggest {

/// u; the selected knot, and its value; the selected points, and the first and the last of them; the active curve.
double current_parameter(const EditorState& state);
std::optional<std::size_t> selected_knot(const EditorState& state);
std::optional<double> selected_knot_value(const EditorState& state);
std::optional<std::vector<std::size_t>> selected_points(const EditorState& state);
std::optional<std::size_t> first_selected_point(const EditorState& state);
std::optional<std::size_t> last_selected_point(const EditorState& state);
std::optional<std::size_t> active_curve(const EditorState& state);

/// The curves of which anything is selected, else the active one.
std::optional<std::vector<std::size_t>> curves_meant(const EditorState& state);

/// The selected control points of the active curve, all of them where fewer than two are selected.
std::optional<std::vector<core::Point>> points_of_curve(const EditorState& state);

/// The name of the curve after the active one, the first one after the last; none where there is no other.
std::optional<std::string> next_curve_name(const EditorState& state);

/// The ends of the active curve's domain.
std::optional<double> domain_begin(const EditorState& state);
std::optional<double> domain_end(const EditorState& state);

/// The corner of the grid nearest to the middle of the canvas.
core::Point middle_of_view(const EditorState& state);

/// One minor grid step; a tenth of it.
double grid_step(const EditorState& state);
double tenth_of_grid_step(const EditorState& state);

/// Lengths beside the size of the active curve: `share` of it; a billionth, which nobody sees; parts of it.
std::optional<double> share_of_size(const EditorState& state, double share);
std::optional<double> tiny_length(const EditorState& state);
std::optional<double> hundredth_of_size(const EditorState& state);
std::optional<double> thousandth_of_size(const EditorState& state);

/// Of the size of a curve, how far its offsets may be off, so that few points do: a tenth of a pixel where it fills a
/// window.
inline constexpr double offset_tolerance = 1e-4;
std::optional<double> tolerance_of_offset(const EditorState& state);

}  // namespace batten::editor::suggest
