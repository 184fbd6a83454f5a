/// The cards about dots that divide the curve.
#pragma once

#include "app/editor/cards/card.h"

namespace batten::editor {

/// The step of u, and buttons for the number of parts.
Card equal_steps_card(const EditorState& state);

/// The length of the curve and of each part, and the same buttons.
Card equal_lengths_card(const EditorState& state);

}  // namespace batten::editor
