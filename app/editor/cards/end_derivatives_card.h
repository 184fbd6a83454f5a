/// The card with the derivatives at the ends.
#pragma once

#include "app/editor/cards/card.h"

namespace batten::editor {

/// For each end in a control point the formulas of C' and C'' by the control points, with the numbers put in.
Card end_derivatives_card(const EditorState& state);

}  // namespace batten::editor
