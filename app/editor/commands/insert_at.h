/// Inserting one knot into the active curve, as several commands do.
#pragma once

#include "app/editor/command_spec.h"
#include "app/editor/state/state.h"

namespace batten::editor {

/// The committed document with `u` once more among the knots of its active curve, the last one of that value selected;
/// the reason where that cannot be.
Outcome<Edit> insert_knot_at(const EditorState& state, double u);

}  // namespace batten::editor
