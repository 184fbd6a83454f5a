/// Commands as lines of text, so that a session can be kept, replayed and handed out.
#pragma once

#include <string>
#include <vector>

#include "app/editor/command.h"
#include "app/editor/command_table.h"

namespace batten::editor {

/// One line of JSON: ["insert-knot", 0.5].
std::string format_command(const Command& command);

/// The inverse of format_command; the sentence says what is wrong with the line.
Outcome<Command> parse_command(const std::string& line);

/// What a person types in the palette or on the command line, "insert-knot 0.5": words separated by spaces, read by
/// parse_argument; "..." keeps spaces together and is text.
Outcome<Command> parse_typed_command(const std::string& typed);

}  // namespace batten::editor
