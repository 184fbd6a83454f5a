/// Opens and closes what covers the window.
#pragma once

#include "app/editor/state/state.h"

namespace batten::editor {

/// Shows `dialog`, or none, in place of the one shown; what waited for the old one's answer is given up.
void show_dialog(EditorState& state, Dialog dialog);

}  // namespace batten::editor
