/// What is said of the insertion of a knot as corner cutting.
#pragma once

#include "app/editor/cards/card.h"
#include "app/editor/state/state.h"

namespace batten::editor {

/// The new points as blends of the old ones with their alphas, for the last insertion or for the one that u would be.
Card corner_cutting_card(const EditorState& state);

}  // namespace batten::editor
