/// What the cards of views say that need a curve where there is none.
#pragma once

#include "app/editor/cards/card.h"

namespace batten::editor {

/// A sentence, and a button that opens the example of this name.
Card card_without_curve(const char* example);

}  // namespace batten::editor
