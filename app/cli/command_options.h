/// What the options of several subcommands share. Only for sources that read CLI11, which takes long.
#pragma once

#include <CLI/App.hpp>
#include <cstddef>
#include <string>
#include <vector>

namespace batten::cli {

/// Adds a subcommand of that name.
CLI::App* add_command(CLI::App& program, const char* name, const char* description);

/// Adds the option that asks for JSON.
void add_json(CLI::App& command, bool& as_json);

/// What values of options may be; what they must not be is told in a sentence of the program. All options with numbers
/// and choices have one of these.
CLI::Validator whole_number(std::size_t least, std::size_t most);
CLI::Validator number_within(double least, double most);
CLI::Validator number_above_0();
CLI::Validator length_above_0();
CLI::Validator one_of(std::vector<std::string> names);

}  // namespace batten::cli
