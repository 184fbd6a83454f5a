/// The one table of commands that menu, tool bar, shortcuts, palette, key sheet and the command line iterate.
#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "app/editor/command_spec.h"

namespace batten::editor {

/// All commands, in the order of menus: for (const CommandSpec& spec : command_table()).
std::span<const std::reference_wrapper<const CommandSpec>> command_table();

/// The command called `name`, or null; for the readers of text.
const CommandSpec* find_command(std::string_view name);

/// The same, or a sentence.
Outcome<const CommandSpec*> command_named(std::string_view name);

/// The command with this shortcut, or null.
const CommandSpec* find_command(const Shortcut& shortcut);

}  // namespace batten::editor
