/// Keeps what refers to the document (selection, hover, view) in line when the document changes.
#pragma once

#include "app/editor/state/state.h"

namespace batten::editor {

/// Whether `hover` names something that `document` has.
bool is_in(const Hover& hover, const core::Document& document);

/// Drops a hover of what is not shown (any more).
void follow_shown(EditorState& state);

/// To be called after the committed document was `before` and became another: drops preview and ghost, a selection that
/// would now mean other points or another knot, and a construction level or zoom of the plot that no longer fits.
void follow_document(EditorState& state, const core::Document& before);

/// To be called after an edit that keeps the shape, with the document before it: remembers the one knot that came into
/// the active curve, if that is what happened; several knots are no insertion to be shown.
void note_insertion(EditorState& state, const core::Document& before);

}  // namespace batten::editor
