/// Commands as lines of text, so that a session can be kept, replayed and handed out. One in which a document was
/// recovered is replayed where that is offered still; elsewhere it is refused at that line, not done to another
/// document.
#pragma once

#include <string>

#include "app/editor/command.h"
#include "app/editor/fields/field.h"

namespace batten::editor {

/// One line of JSON, the command's name and its fields: ["insert-knot", 0.5].
std::string format_command(const Command& command);

/// The inverse of format_command. Fields that an older log leaves out are what suggests itself in `state`. The sentence
/// says what is wrong with the line, or why the command cannot be run now.
Outcome<Command> parse_command(const std::string& line, const EditorState& state);

}  // namespace batten::editor
