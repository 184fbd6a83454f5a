/// The one table of commands that menu, tool bar, shortcuts, palette, key sheet and the command line iterate.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/editor/command_spec.h"
#include "app/editor/state.h"

namespace batten::editor {

/// All commands, in the order of menus.
std::span<const CommandSpec> command_table();

/// The command called `name`, or null.
const CommandSpec* find_command(const std::string& name);

/// The command with this shortcut, or null.
const CommandSpec* find_command(const Shortcut& shortcut);

/// The arguments `given` to a command with suggestions filled in, checked against the table: the count, the kinds, and
/// that numbers are finite. Where fewer are given than there are parameters, the last ones that have a suggestion are
/// taken as left out. A number stands for a list of one, and for the text that it reads as. The sentence names the
/// parameter, what was found and what is needed.
Outcome<Arguments> complete_arguments(const CommandSpec& spec, const EditorState& state,
                                      const std::vector<Argument>& given);

}  // namespace batten::editor
