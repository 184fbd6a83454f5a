/// Arguments that are written @FILE: lists of numbers too long for a command line.
#pragma once

#include <string>
#include <vector>

#include "app/cli/operation.h"
#include "app/editor/words/length.h"
#include "core/document/file_text.h"

namespace batten::cli {

/// Whether a word where a list is needed names a table: "@points.csv", or "@-" for standard input.
inline bool names_table(const std::string& word) {
    return word.starts_with('@');
}

/// Whether the word names standard input.
inline bool names_standard_input(const std::string& word) {
    return word == "@-";
}

/// What a table is read for.
enum class TableContent {
    numbers,  ///< one or more on each line
    points    ///< as core::read_point_table finds them
};

/// The numbers of a table, or the coordinates of its points, and what is to be said of what was left out; mostly
/// nothing.
struct ReadTable {
    std::vector<double> numbers;
    std::string told{};
};

/// The table that `word` names. The error's place is the file's name, also where a line is meant.
core::FileResult<ReadTable> read_table(const std::string& word, TableContent content);

/// The words of `operation` that name a table where a list of points, numbers or indices is needed.
std::vector<std::string> table_words(const Operation& operation);

/// Puts the numbers of those tables in their place; points of a table are in `units`. What was left out of them is told
/// in sentences that begin with the file's name. The refusal is one sentence.
editor::Outcome<std::vector<std::string>> read_tables(Operation& operation, const editor::Units& units);

}  // namespace batten::cli
