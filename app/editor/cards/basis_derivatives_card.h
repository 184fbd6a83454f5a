/// The card of the derivatives of the basis functions.
#pragma once

#include "app/editor/cards/card.h"

namespace batten::editor {

/// The graphs of N' and N'' over the parameters that the plot shows, their values at u, and the formula of N' by the
/// functions one degree lower with its numbers.
Card basis_derivatives_card(const EditorState& state);

}  // namespace batten::editor
