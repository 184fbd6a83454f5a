/// Asks the editor to hover what lies under the pointer.
#pragma once

#include "app/editor/command.h"
#include "app/editor/state.h"

namespace batten::editor {

/// The command that makes `hover` the hovered thing: hover "cell" [r, j].
Command hover_command(const Hover& hover);

/// Puts hover_command(hover) into `queue` unless it is hovered already, so that a resting pointer asks for nothing.
void request_hover(const Hover& hover, const EditorState& state, CommandQueue& queue);

}  // namespace batten::editor
