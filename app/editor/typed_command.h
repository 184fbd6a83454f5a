/// Commands as people type them: insert-knot 0.5.
#pragma once

#include <string>

#include "app/editor/command.h"
#include "app/editor/fields/field.h"

namespace batten::editor {

/// The command that was typed in the palette: its name and its fields, separated by spaces; parentheses keep spaces
/// together, and so does "...", which is text. What suggests itself in `state` may be left out. The sentence says what
/// is wrong, or why the command cannot be run now. A knot vector alone, "0 0 0 1 2 2 2", is a sample curve over it.
Outcome<Command> parse_typed_command(const std::string& typed, const EditorState& state);

}  // namespace batten::editor
