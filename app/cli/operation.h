/// The operations of `apply`: commands that scripts are offered, read from words.
#pragma once

#include <string>
#include <vector>

#include "app/editor/argument.h"
#include "app/editor/command_spec.h"

namespace batten::cli {

/// One operation as it was given.
struct Operation {
    const editor::CommandSpec* spec;
    std::vector<editor::Argument> arguments;
    std::string text;  ///< "insert-knot 0.5"
};

/// The words as operations: each a name and as many arguments as it takes, fewer where the next word is again the name
/// of an operation and what is missing can be left out. Lists are "0,1,2.5". The refusal names the word.
editor::Outcome<std::vector<Operation>> parse_operations(const std::vector<std::string>& words);

}  // namespace batten::cli
