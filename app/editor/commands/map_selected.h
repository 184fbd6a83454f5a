/// What commands share that act on all that is selected, over several curves.
#pragma once

#include "app/editor/command_spec.h"
#include "app/editor/state/selected_parts.h"
#include "core/base/sentence.h"
#include "core/edit/plane_map.h"

namespace batten::editor {

/// Refusals: nothing is selected that has a place, or a curve of it is locked or hidden; no curve of which anything is
/// selected.
std::optional<Refusal> nothing_to_map(const EditorState& state);
std::optional<Refusal> no_selected_curve(const EditorState& state);

/// The committed document with all that is selected mapped: whole curves with what belongs to them (fit points, and a
/// symmetry of which all images are selected), else the selected control points that are not pinned. The refusal is
/// that of nothing_to_map, of points that are all pinned, or of a curve that cannot be mapped so. Cost O(n) of what is
/// selected; curves of which nothing is selected are shared.
Outcome<Edit> map_selected(const EditorState& state, const core::PlaneMap& map);

/// The same with a map for each part, `maps[k]` for `parts[k]`, which are ascending by curve.
Outcome<Edit> map_parts(const EditorState& state, const SelectedParts& parts, const std::vector<core::PlaneMap>& maps);

/// The committed document without what is selected, which there must be; a curve goes where all its points do.
Outcome<Edit> without_parts(const EditorState& state, const SelectedParts& parts);

/// The curves of which anything is selected, else the active one, which there must be; and as the place {curves} of a
/// sentence.
std::vector<std::size_t> curves_meant(const EditorState& state);
core::Place names_of_meant(const EditorState& state);

/// "P₅", "3 points", "'wave'", "4 curves", "3 points of 2 curves": what is selected.
std::string parts_words(const core::Document& document, const SelectedParts& parts, std::size_t active);
std::string selected_words(const EditorState& state);

}  // namespace batten::editor
