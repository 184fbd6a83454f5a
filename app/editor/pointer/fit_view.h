/// Points the camera at the whole document.
#pragma once

#include "app/editor/state/state.h"

namespace batten::editor {

/// Shows all visible pictures, and all visible curves with their control points and what views draw beside them, the
/// curves clear of legend and inset, as large as that allows; the legend goes to the corner where it takes least.
/// Without curves the surroundings of the origin.
void fit_view(EditorState& state);

/// The same if the camera is still where that put it, for what is drawn has changed.
void refit_view(EditorState& state);

}  // namespace batten::editor
