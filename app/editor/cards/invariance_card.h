/// The card of the view of invariance: by which map, what both ways lead to, and that they agree.
#pragma once

#include "app/editor/cards/card.h"
#include "app/editor/state/state.h"

namespace batten::editor {

Card invariance_card(const EditorState& state);

}  // namespace batten::editor
