/// The operations of `apply`: which commands they are, and how they are read from words.
#pragma once

#include <string>
#include <vector>

#include "app/editor/command_table.h"

namespace batten::cli {

/// Whether a script can use the command: it edits the document, measures it, or says what the next one acts on.
bool is_operation(const editor::CommandSpec& spec);

/// One operation as it was given.
struct Operation {
    editor::Command command;
    std::string text;  ///< "insert-knot 0.5"
};

/// The words as operations: each a name and as many arguments as it takes, fewer where the next word is again the name
/// of an operation and what is missing can be left out. Lists are "0,1,2.5". The refusal names the word.
editor::Outcome<std::vector<Operation>> parse_operations(const std::vector<std::string>& words);

}  // namespace batten::cli
