/// What commands on the active curve share: when they are refused, what they act on, and how they give back a document.
#pragma once

#include "app/editor/command_table.h"

namespace batten::editor {

/// Refusals: no active curve; no active curve or a locked one; no control point selected or one of these.
std::optional<Refusal> no_curve(const EditorState& state);
std::optional<Refusal> no_editable_curve(const EditorState& state);
std::optional<Refusal> no_editable_points(const EditorState& state);

/// Why `curve` cannot be edited, if it cannot.
std::optional<Refusal> locked(const core::DocumentCurve& curve);

/// The committed active curve; there must be one.
const core::Curve& active_curve(const EditorState& state);

/// Suggestions: u; the selected knot; the selected points; the index of the active curve; one minor grid step.
std::optional<Argument> current_parameter(const EditorState& state);
std::optional<Argument> selected_knot(const EditorState& state);
std::optional<Argument> selected_points(const EditorState& state);
std::optional<Argument> active_index(const EditorState& state);
std::optional<Argument> grid_step(const EditorState& state);

/// Suggestions of lengths beside the size of the active curve: a part of it; a billionth of it, which nobody sees.
std::optional<Argument> share_of_size(const EditorState& state, double share);
std::optional<Argument> tiny_length(const EditorState& state);

/// `value` as an index; refused unless it is a whole number from 0. `what` names the parameter.
Outcome<std::size_t> index_of(double value, const char* what);

/// The numbers as indices, ascending and without repeats.
Outcome<std::vector<std::size_t>> indices_of(const std::vector<double>& values, const char* what);

/// The committed document with `curve` in place of the active one, or the reason why there is no such curve.
Outcome<Edit> edit_active(const EditorState& state, core::Result<core::Curve> curve,
                          std::optional<Selection> selection = {});

/// "P₅"; "P₅" or "3 points".
std::string point_text(double index);
std::string points_text(const std::vector<double>& indices);

}  // namespace batten::editor
