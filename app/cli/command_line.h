/// The command line of the whole program: the options of the window, and the subcommands.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/subcommands.h"

namespace batten::cli {

/// What the window is asked for.
struct WindowOptions {
    std::vector<std::filesystem::path> files;
    std::optional<std::string> example;
    std::filesystem::path assets;
    std::optional<double> display_scale;
    std::optional<std::filesystem::path> state_report;
    std::optional<std::filesystem::path> session_log;
    std::optional<ProfileOptions> profile;  ///< a gesture to be measured, instead of a user's work
};

/// Reads the command line and runs the subcommand that it names, if any. Returns what the process ends with; none where
/// the window is to be opened, with its options in `window`. Without a window, `window` is null.
std::optional<int> run_command_line(int argc, const char* const* argv, WindowOptions* window, Output output);

}  // namespace batten::cli
