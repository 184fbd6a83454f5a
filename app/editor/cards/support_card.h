/// The cards about hulls and local support.
#pragma once

#include "app/editor/cards/card.h"

namespace batten::editor {

/// In which hull each piece lies.
Card span_hulls_card(const EditorState& state);

/// Which parameters and spans the selected or hovered points act on.
Card support_card(const EditorState& state);

}  // namespace batten::editor
