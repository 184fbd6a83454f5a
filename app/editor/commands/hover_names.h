/// What is under the pointer, as arguments of a command.
#pragma once

#include <string>
#include <vector>

#include "app/editor/command_table.h"

namespace batten::editor {

/// The hover called `kind` ("point", "cell", ...) with the numbers that say which. The sentence names what is wrong
/// with them; whether there is such a thing is not checked.
Outcome<Hover> hover_named(const std::string& kind, const std::vector<double>& values);

}  // namespace batten::editor
