/// What the views of weights say.
#pragma once

#include "app/editor/cards/card.h"
#include "app/editor/state/state.h"

namespace batten::editor {

/// The ratios of the legs about the active span.
Card farin_card(const EditorState& state);

/// Kind, ratio, angle and circular weight of the quadratic piece at the parameter.
Card conic_card(const EditorState& state);

/// What the lifted curve is, and from where it is seen.
Card homogeneous_card(const EditorState& state);

}  // namespace batten::editor
