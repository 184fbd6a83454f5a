/// The card of the recurrence of the basis functions.
#pragma once

#include "app/editor/cards/card.h"

namespace batten::editor {

/// The triangle from N_{i,0}, ..., N_{i+p,0} to the shown function N_{i,p} at u, with the ratio on every line, and how
/// the cell that is pointed at, else the last one, is made of two.
Card recurrence_card(const EditorState& state);

}  // namespace batten::editor
