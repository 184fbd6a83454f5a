/// The card with the five questions about the knots of the active curve.
#pragma once

#include "app/editor/cards/card.h"
#include "app/editor/state/state.h"

namespace batten::editor {

/// The questions with their answers and reasons, but for those that are hidden. A click on a question hides or shows
/// its answer.
Card knot_questions_card(const EditorState& state);

}  // namespace batten::editor
