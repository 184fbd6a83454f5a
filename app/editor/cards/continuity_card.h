/// The card of the continuity meter.
#pragma once

#include "app/editor/cards/card.h"

namespace batten::editor {

/// For each knot inside the domain, as many as a card can hold, what it promises, what the shape has, and how far C,
/// C', C'', direction and curvature jump; the same where the ends meet and where other curves are met. With the values
/// on both sides of the knot that is pointed at.
Card continuity_card(const EditorState& state);

}  // namespace batten::editor
