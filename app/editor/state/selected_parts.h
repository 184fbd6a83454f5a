/// What is selected of all curves: asked for, put together, kept true, and as text.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/editor/derived/selected_box.h"
#include "app/editor/fields/field.h"
#include "app/editor/state/selection.h"
#include "core/base/geometry.h"
#include "core/document/document.h"

namespace batten::editor {

using SelectedParts = std::vector<SelectedPart>;

/// What is selected of each curve of the committed document, the active one included, ascending by curve; nothing where
/// only a knot or a fit point is selected.
SelectedParts selected_parts(const EditorState& state);
SelectedParts selected_parts(const Selection& selection, std::size_t active);

/// The selection that consists of these parts, which are ascending by curve.
Selection selection_of(SelectedParts parts, std::size_t active);

/// The curves of which anything is selected, ascending.
std::vector<std::size_t> selected_curves(const EditorState& state);

/// What is selected of the committed document, and the box around its control points, all of those of curves that are
/// selected as a whole. Kept as long as nothing of both changes; see KeptSelection.
std::shared_ptr<const SelectedBox> selected_box(const EditorState& state);

/// Whether `part` is the whole of `entry`, or all of its control points.
bool is_all_of(const SelectedPart& part, const core::DocumentCurve& entry);

/// The part of `parts`, ascending by curve, that is of `curve`; null where there is none.
const SelectedPart* part_of(std::span<const SelectedPart> parts, std::size_t curve);

/// `parts` and also `part`, where a whole curve swallows its points; `parts` without `part`. Both ascending by curve.
SelectedParts with_part(SelectedParts parts, const SelectedPart& part);
SelectedParts without_part(SelectedParts parts, const SelectedPart& part);

/// Whether what is selected of `entry` can be more than looked at: it is visible and not locked.
bool can_be_selected(const core::DocumentCurve& entry);

/// The same curves, of which those that can be selected.
std::vector<std::size_t> selectable(const core::Document& document, const std::vector<std::size_t>& curves);

/// How many control points these curves have in all.
std::size_t control_point_count(const core::Document& document, const std::vector<std::size_t>& curves);

/// The visible curves beside the active one whose control points are shown, and can be taken: those of which points are
/// selected, and where polygons of other curves are shown all that are not locked. Ascending.
std::vector<std::size_t> curves_showing_points(const EditorState& state);

/// All curves of the groups of `curves`, and these themselves, ascending.
std::vector<std::size_t> with_groups(const core::Document& document, const std::vector<std::size_t>& curves);

/// Drops from the selection of whole curves, and of others than the active one, what is another curve in `after` or has
/// other points, and what cannot be selected there.
void keep_parts(Selection& selection, const core::Document& before, const core::Document& after);

/// "0:1,2,5-9 3" for points 1, 2 and 5 to 9 of curve 0, and all of curve 3.
std::string text_of_parts(const SelectedParts& parts);

/// Reads such a text; the refusal says what is no part, what there is not, or what cannot be selected.
Outcome<SelectedParts> parts_of_text(const std::string& text, const core::Document& document);

}  // namespace batten::editor
