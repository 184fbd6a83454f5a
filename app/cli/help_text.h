/// The help of the whole program in the layout from which help2man makes the manual page.
#pragma once

#include <CLI/CLI.hpp>

namespace batten::cli {

/// The help of `app`; with CLI::AppFormatMode::All also that of its subcommands, each under a heading of its own.
std::string help_text(const CLI::App* app, std::string name, CLI::AppFormatMode mode);

}  // namespace batten::cli
