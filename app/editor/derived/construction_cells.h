/// Which cells of the construction at the view's parameter are drawn, and which are hovered, on the canvas or in the
/// triangle.
#pragma once

#include "app/editor/state/state.h"
#include "core/evaluate/de_boor_polygons.h"

namespace batten::editor {

/// The last level that is drawn, 0 to `degree`.
std::size_t shown_level(const View& view, int degree);

/// Whether the cell lights up: it is hovered, or is the hovered C(u), or is a hovered control point of the active
/// curve, which there must be.
bool is_lit_cell(const EditorState& state, const core::DeBoorTriangle& triangle, core::CellPlace place);

/// The hovered cell, if the triangle has it.
std::optional<core::CellPlace> hovered_cell(const EditorState& state, const core::DeBoorTriangle& triangle);

/// The points of the construction that have a mark of their own on the canvas: those of level 1 to shown_level that are
/// no point of a lower level. C(u) is not among them.
std::vector<core::CellPlace> marked_cells(const View& view, const core::DeBoorTriangle& triangle);

}  // namespace batten::editor
