/// The card of the construction: the triangle, the line of the lecture for each of its points, and all formulas of one.
#pragma once

#include "app/editor/cards/card.h"

namespace batten::editor {

/// Of the active curve at u; of a Bézier curve it is that of de Casteljau. Of a high degree the lines of the last level
/// that is drawn. Without a curve a sentence and an example.
Card triangle_card(const EditorState& state);

}  // namespace batten::editor
