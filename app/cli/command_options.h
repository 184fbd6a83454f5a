/// What the options of several subcommands share. Only for sources that read CLI11, which takes long.
#pragma once

#include <CLI/App.hpp>

namespace batten::cli {

/// Adds a subcommand of that name.
CLI::App* add_command(CLI::App& program, const char* name, const char* description);

/// Adds the option that asks for JSON.
void add_json(CLI::App& command, bool& as_json);

}  // namespace batten::cli
