#include "app/cli/command_options.h"

#include <CLI/CLI.hpp>

namespace batten::cli {

CLI::App* add_command(CLI::App& program, const char* name, const char* description) {
    CLI::App* command = program.add_subcommand(name, description);
    command->set_help_all_flag();
    return command;
}

void add_json(CLI::App& command, bool& as_json) {
    command.add_flag("--json", as_json, "Print JSON, whose members stay the same from version to version");
}

}  // namespace batten::cli
