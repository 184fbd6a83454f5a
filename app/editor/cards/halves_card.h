/// The card of the two curves into which u splits the active one.
#pragma once

#include "app/editor/cards/card.h"

namespace batten::editor {

/// Their domains and control points, which are the sides of the triangle. Says so where there is nothing to split.
Card halves_card(const EditorState& state);

}  // namespace batten::editor
