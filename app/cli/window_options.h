/// What the command line says of the window. Only for sources that read CLI11.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/command_line.h"
#include "app/cli/subcommands.h"

namespace batten::cli {

/// Adds the options of the program itself.
void add_window_options(CLI::App& program, WindowOptions& options);

/// Why the session log and the report cannot be written to the files that were named, if that is so: they would take
/// the place of a document.
std::optional<std::string> problem_of_written_files(const WindowOptions& options);

/// The subcommand that opens the window itself.
class ProfileSubcommand {
  public:
    explicit ProfileSubcommand(CLI::App& program);

    bool is_given() const { return command_->parsed(); }

    /// What was asked for; none after saying what is wrong with it.
    std::optional<ProfileOptions> options(Output output) const;

  private:
    ProfileOptions options_;
    std::vector<editor::ScriptedGesture> gestures_;
    const CLI::App* command_ = nullptr;
};

}  // namespace batten::cli
