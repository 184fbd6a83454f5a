/// What is given to a command in a log or in words, before anyone knows what it is for.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace batten::editor {

/// A word as it was typed, which may be a number, a list or a text.
struct Word {
    std::string text;
    bool operator==(const Word&) const = default;
};

/// A number, a text, a list of numbers (indices, coordinates), yes or no, nothing, or a word.
using Argument = std::variant<double, std::string, std::vector<double>, bool, std::monostate, Word>;

/// A word as an argument: a number, a list like "1,2,3" ("1," for a list of one), else the text itself.
Argument parse_argument(const std::string& word);

}  // namespace batten::editor
