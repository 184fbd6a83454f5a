/// The card of C(u) by insertion: the levels of the construction beside the polygons after inserting u so often.
#pragma once

#include "app/editor/cards/card.h"

namespace batten::editor {

/// Pictures of the polygons side by side, the last of which has C(u) as a corner, and what each insertion does.
Card by_insertion_card(const EditorState& state);

}  // namespace batten::editor
