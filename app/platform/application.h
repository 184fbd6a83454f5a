/// The running program: window, editor, interface and painter, frame after frame.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "app/platform/profile.h"

namespace batten::platform {

struct Options {
    std::vector<std::filesystem::path> files;           ///< the first is opened, the curves of the others are added
    std::optional<std::string> example;                 ///< opened when there are no files; none: the welcome screen
    std::filesystem::path assets;                       ///< the folder that holds examples/
    std::optional<double> display_scale;                ///< instead of what the display says
    std::optional<std::filesystem::path> state_report;  ///< see state_report.h
    std::optional<std::filesystem::path> session_log;   ///< where the commands are written as they are run
};

/// Runs until the user quits. Returns the exit status; a failure to start is said in one sentence on standard error.
int run(const Options& options);

/// Makes a gesture in a window of default settings, first without a curve, then on the file, and writes what its frames
/// cost to `results`. Returns the exit status; what is wrong is said in one sentence on standard error.
int profile(const ProfileOptions& options, bool as_json, std::ostream& results);

}  // namespace batten::platform
