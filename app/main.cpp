#include <filesystem>
#include <iostream>
#include <sstream>

#include "app/cli/command_line.h"
#include "app/cli/standard_streams.h"
#ifdef BATTEN_WINDOW
#include "app/platform/application.h"
#endif

#ifdef BATTEN_WINDOW
namespace {

// Beside the program where it is installed, else in the sources.
std::filesystem::path assets_folder() {
    std::error_code error;
    const std::filesystem::path program = std::filesystem::canonical("/proc/self/exe", error);
    const std::filesystem::path installed = program.parent_path() / BATTEN_INSTALLED_ASSETS;
    return !error && std::filesystem::exists(installed / "examples", error) ? installed : BATTEN_ASSETS;
}

int profile(const batten::cli::ProfileOptions& options) {
    std::ostringstream results;
    const int status = batten::platform::profile({.file = options.file,
                                                  .gesture = options.gesture,
                                                  .frame_count = options.frame_count,
                                                  .commands = options.commands},
                                                 options.as_json, results);
    const bool is_written = batten::cli::write_results(results.str(), {std::cout, std::cerr});
    return is_written ? status : static_cast<int>(batten::cli::ExitStatus::wrong_input);
}

}  // namespace
#endif

int main(int argc, char** argv) {
    batten::cli::guard_standard_streams();
#ifdef BATTEN_WINDOW
    batten::cli::WindowOptions window;
    window.assets = assets_folder();
    if (const auto status = batten::cli::run_command_line(argc, argv, &window, {std::cout, std::cerr})) return *status;
    if (window.profile) return profile(*window.profile);
    return batten::platform::run({.files = std::move(window.files),
                                  .example = std::move(window.example),
                                  .assets = std::move(window.assets),
                                  .display_scale = window.display_scale,
                                  .state_report = std::move(window.state_report),
                                  .session_log = std::move(window.session_log)});
#else
    return *batten::cli::run_command_line(argc, argv, nullptr, {std::cout, std::cerr});
#endif
}
