/// The card of the knot quiz: a vector, the questions with answers to choose from, and the marks.
#pragma once

#include "app/editor/cards/card.h"
#include "app/editor/state/state.h"

namespace batten::editor {

Card quiz_card(const EditorState& state);

}  // namespace batten::editor
