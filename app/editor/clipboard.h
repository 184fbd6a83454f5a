/// The text that copy and paste pass on.
#pragma once

#include <string>

#include "app/editor/state/state.h"

namespace batten::editor {

/// What was copied last: the desktop's clipboard, or the editor's own where the desktop has none.
std::string read_clipboard(const EditorState& state);

void write_clipboard(EditorState& state, const std::string& text);

}  // namespace batten::editor
