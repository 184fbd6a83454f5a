/// Makes commands of arguments that were read from a text or a log.
#pragma once

#include "app/editor/command.h"
#include "app/editor/command_spec.h"
#include "app/editor/fields/argument.h"

namespace batten::editor {

/// The command from the arguments `given`, with suggestions for what is left out. Where fewer are given than the fields
/// have parts, the last ones that can be left out are taken as left out. A number stands for a list of one, and for the
/// text that it reads as. The sentence says why the command cannot be run now, or names the field, what was found and
/// what is needed.
Outcome<Command> read_command(const CommandSpec& spec, const EditorState& state,
                              const std::vector<Argument>& given = {});

/// The arguments that are typed as `word` where `given` come before it: x and y of a point that is typed whole, "1,2"
/// or "1;2", else the word itself.
std::vector<Argument> arguments_of_word(const CommandSpec& spec, std::size_t given, const std::string& word);

/// The arguments that stand for `command`: reading them gives it back, whatever the state.
std::vector<Argument> arguments_of(const Command& command);

/// What is wrong with the fields of `command`, if anything.
std::optional<Refusal> check_fields(const Command& command, const EditorState& state);

}  // namespace batten::editor
