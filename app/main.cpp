#include <CLI/CLI.hpp>
#include <iostream>

#include "app/cli/command_line.h"
#include "app/cli/help_text.h"
#ifdef BATTEN_WINDOW
#include "app/platform/application.h"
#endif

namespace {

#ifdef BATTEN_WINDOW

/// Adds the options of the window to the command line.
void add_window_options(CLI::App& program, batten::platform::Options& options) {
    program.add_option("files", options.files, "Files to open; the curves of all but the first are added")
        ->check(CLI::Validator(CLI::ExistingFile).description(""))
        ->type_name("FILE");
    program.add_option("--example", options.example, "Open this example, for instance circle-nurbs")->type_name("NAME");
    program.add_option("--assets", options.assets, "Folder that holds examples/")->type_name("FOLDER");
    program
        .add_option("--display-scale", options.display_scale,
                    "Window pixels per design pixel, from 0.5 to 4, instead of what the display says")
        ->check(CLI::Validator(CLI::Range(0.5, 4.0)).description(""))
        ->type_name("NUMBER");
    program.add_option("--state-report", options.state_report, "Write what is on screen to this file after each frame")
        ->type_name("FILE");
    program.add_option("--session-log", options.session_log, "Write the commands of the session to this file")
        ->type_name("FILE");
}

#endif

}  // namespace

int main(int argc, char** argv) {
    constexpr int usage_error = 2;
    CLI::App program("Batten: an interactive editor for B-spline and NURBS curves", "batten");
    program.set_version_flag("--version", "batten " BATTEN_VERSION);
    program.set_help_all_flag("--help-all", "Print this help and that of the subcommands and exit");
    program.formatter_fn(batten::cli::help_text);
    program.footer(
        "Without a subcommand the window opens.\n\n"
        "Exit status:\n  0 where all is done, 1 where the input is wrong, 2 where the command line is.");
    const batten::cli::CommandLine subcommands(program);
#ifdef BATTEN_WINDOW
    batten::platform::Options options;
    options.assets = BATTEN_ASSETS;
    add_window_options(program, options);
#endif
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? 0 : usage_error;
    }
    if (const auto status = subcommands.run({std::cout, std::cerr})) return static_cast<int>(*status);
#ifdef BATTEN_WINDOW
    return batten::platform::run(options);
#else
    std::cerr << "batten: this build has no window; the subcommands are info, eval, apply and check\n";
    return usage_error;
#endif
}
