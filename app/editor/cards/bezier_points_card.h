/// What is said of the Bézier points of the piece at u.
#pragma once

#include "app/editor/cards/card.h"
#include "app/editor/state/state.h"

namespace batten::editor {

/// Their names, their blossom values and places, and how they become control points step by step.
Card bezier_points_card(const EditorState& state);

}  // namespace batten::editor
