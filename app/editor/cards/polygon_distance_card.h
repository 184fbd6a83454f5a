/// What is said of how far the control polygon is from the curve.
#pragma once

#include "app/editor/cards/card.h"
#include "app/editor/state/state.h"

namespace batten::editor {

/// The distance now and after each of the next rounds of midpoint insertion.
Card polygon_distance_card(const EditorState& state);

}  // namespace batten::editor
