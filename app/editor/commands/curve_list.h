/// Edits of the list of curves that several commands make.
#pragma once

#include "app/editor/command_table.h"

namespace batten::editor {

/// The committed document without curve `index`, which there must be; a locked one is refused.
Outcome<Edit> without_curve(const EditorState& state, std::size_t index);

/// The committed document with a copy of curve `index`, which there must be, moved by `shift` to the right and down;
/// the copy is active, visible and not locked.
Outcome<Edit> with_duplicate(const EditorState& state, std::size_t index, double shift);

}  // namespace batten::editor
