/// What a typed knot may be.
#pragma once

#include "app/editor/fields/field.h"
#include "app/editor/state/state.h"

namespace batten::editor {

/// Why knot `index` of the active curve cannot be `u`: which neighbor is in the way, or occurs as often as is allowed,
/// and which values are possible. None where only leave to tear is missing, or nothing.
std::optional<Refusal> refusal_of_typed_knot(const EditorState& state, std::size_t index, double u);

}  // namespace batten::editor
