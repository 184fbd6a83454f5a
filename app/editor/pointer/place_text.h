/// What is told beside the pointer while something is placed.
#pragma once

#include <string>

#include "app/editor/state/state.h"

namespace batten::editor {

/// A coordinate or length of the world in the document's unit, with a tenth of a pixel as its last digit, or near that.
std::string length_text(const EditorState& state, double value);

/// "5 ∠ 53.13° · dx 3 · dy 4", from where the gesture began; "x 3 · y 4" where it has no beginning. As many digits as a
/// tenth of a pixel needs; in the document's unit, "5 mm ∠ 53.13°".
std::string reading_of(const EditorState& state, const ShownPlace& place);

/// What is typed with a mark where the next character goes: "length 12.5 · angle 30|". Empty where nothing is.
std::string typed_reading(const TypedPlace& typed, TypedFor typed_for = TypedFor::place);

/// Why what is typed is no place; empty where it is one.
std::string typed_problem(const EditorState& state);

}  // namespace batten::editor
