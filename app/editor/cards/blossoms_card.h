/// The card of the blossoms: the triangle with f(u3,u4,u) in its cells, and what makes one of them.
#pragma once

#include "app/editor/cards/card.h"

namespace batten::editor {

/// By the indices or the values of the knots, as the view says.
Card blossoms_card(const EditorState& state);

}  // namespace batten::editor
