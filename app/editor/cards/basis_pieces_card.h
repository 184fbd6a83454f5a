/// The card of the polynomials of one basis function.
#pragma once

#include "app/editor/cards/card.h"

namespace batten::editor {

/// The pieces of the shown function, or of the one that is pointed at in the recurrence, in u and in the parameter of
/// each span; in the colors that they have in the plot.
Card basis_pieces_card(const EditorState& state);

}  // namespace batten::editor
