/// The card about variation diminishing.
#pragma once

#include "app/editor/cards/card.h"

namespace batten::editor {

/// How often the line crosses the polygon and the curve.
Card variation_card(const EditorState& state);

}  // namespace batten::editor
