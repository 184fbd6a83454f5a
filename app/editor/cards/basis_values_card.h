/// The cards of the values of basis functions: N_i(u) and their sum, and R_i(u) beside them.
#pragma once

#include "app/editor/cards/card.h"

namespace batten::editor {

/// The functions that do not vanish at u, one in a row, and their sum.
Card basis_values_card(const EditorState& state);

/// How R_i(u) = N_i(u) w_i / w(u) comes about for each of them.
Card rational_basis_card(const EditorState& state);

}  // namespace batten::editor
