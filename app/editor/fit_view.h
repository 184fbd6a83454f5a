/// Points the camera at the whole document.
#pragma once

#include "app/editor/state.h"

namespace batten::editor {

/// Shows all visible curves with their control points, or the surroundings of the origin where there are none.
void fit_view(EditorState& state);

}  // namespace batten::editor
