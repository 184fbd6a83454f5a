/// What is wrong with a command line that the parser refused. Only for sources that read CLI11.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>

namespace batten::cli {

/// A sentence, "batten figure: there is no option '--titel'; did you mean '--title'?", for what `program` refused by
/// `error`: an unknown word first, since what lacks is often what was meant by it.
std::string usage_problem(const CLI::App& program, const CLI::ParseError& error);

/// The same for words that are for the window, beside a subcommand that opens none; none where there are no such words.
std::optional<std::string> problem_of_window_words(const CLI::App& program);

/// Why `command`, or the program itself, cannot open `file`, if it cannot. A word of the program that is no path may
/// have been meant as a subcommand.
std::optional<std::string> problem_of_file(const CLI::App& command, const std::string& file);

}  // namespace batten::cli
