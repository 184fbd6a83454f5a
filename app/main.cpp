#include <CLI/CLI.hpp>

#include "app/platform/application.h"

int main(int argc, char** argv) {
    batten::platform::Options options;
    options.assets = BATTEN_ASSETS;

    CLI::App program("Batten: an interactive editor for B-spline and NURBS curves", "batten");
    program.set_version_flag("--version", "batten " BATTEN_VERSION);
    program.add_option("files", options.files, "Files to open; the curves of all but the first are added")
        ->check(CLI::ExistingFile)
        ->type_name("FILE");
    program.add_option("--example", options.example, "Open this example, for instance circle-nurbs");
    program.add_option("--assets", options.assets, "Folder that holds examples/")->type_name("FOLDER");
    program
        .add_option("--display-scale", options.display_scale,
                    "Window pixels per design pixel, instead of what the display says")
        ->check(CLI::Range(0.5, 4.0));
    program.add_option("--state-report", options.state_report, "Write what is on screen to this file after each frame")
        ->type_name("FILE");
    program.add_option("--session-log", options.session_log, "Write the commands of the session to this file")
        ->type_name("FILE");
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        constexpr int usage_error = 2;
        return program.exit(error) == 0 ? 0 : usage_error;
    }
    return batten::platform::run(options);
}
