/// What commands on the active curve share: when they are refused, what they act on, and how they give back a document.
#pragma once

#include "app/editor/command_spec.h"
#include "app/editor/state/state.h"
#include "core/curve/approximation.h"
#include "core/edit/plane_map.h"

namespace batten::editor {

/// Refusals: no active curve; no active curve or a locked one; no control point selected, a hidden curve or
/// one of these.
std::optional<Refusal> no_curve(const EditorState& state);
std::optional<Refusal> no_editable_curve(const EditorState& state);
std::optional<Refusal> no_editable_points(const EditorState& state);

/// Why `curve` cannot be edited, if it cannot.
std::optional<Refusal> locked(const core::DocumentCurve& curve);

/// Why what is selected of `curve` cannot: that it is hidden counts, too, since what is not seen is not changed by keys
/// and pointer. Commands that are told which curves and points they are about do not ask this.
std::optional<Refusal> locked_or_hidden(const core::DocumentCurve& curve);

/// The same of the active curve, which must be there, too.
std::optional<Refusal> no_curve_at_hand(const EditorState& state);

/// The committed active curve; there must be one.
const core::Curve& active_curve(const EditorState& state);

/// Its pinned control points, ascending.
const std::vector<std::size_t>& pinned_points(const EditorState& state);

/// What fairing leaves where they are, ascending: they, and those that make tangents that were given to fit points.
std::vector<std::size_t> held_points(const core::DocumentCurve& entry);

/// Those of `points`, of the active curve or of `entry`, that are not pinned, ascending; the reason why nothing can be
/// moved where there are none.
Outcome<std::vector<std::size_t>> free_points(const EditorState& state, const std::vector<std::size_t>& points);
Outcome<std::vector<std::size_t>> free_points(const core::DocumentCurve& entry, const std::vector<std::size_t>& points);

/// Whether the committed active curve is made of fit points; not where there is none.
bool is_made_of_points(const EditorState& state);

/// The indices, ascending and without repeats.
std::vector<std::size_t> ascending(std::vector<std::size_t> indices);

/// The committed document with `curve` in place of the active one, or the reason why there is no such curve.
Outcome<Edit> edit_active(const EditorState& state, core::Result<core::Curve> curve,
                          std::optional<Selection> selection = {});

/// The same of an approximation, whose error is told as how far the curve moved.
Outcome<Edit> edit_active(const EditorState& state, core::Result<core::Approximation> found,
                          std::optional<Selection> selection = {});

/// The committed document with the active curve mapped; an affine map takes fit points along.
Outcome<Edit> map_active(const EditorState& state, const core::PlaneMap& map);

}  // namespace batten::editor
