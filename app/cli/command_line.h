/// The subcommands as the command line knows them.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>

#include "app/cli/subcommands.h"

namespace batten::cli {

/// Adds the subcommands to a program's command line and runs the one that was given.
class CommandLine {
  public:
    explicit CommandLine(CLI::App& program);

    /// What the subcommand ended with; none where none was given. To be called after parsing.
    std::optional<ExitStatus> run(Output output) const;

  private:
    void add_info(CLI::App& program);
    void add_eval(CLI::App& program);
    void add_apply(CLI::App& program);
    void add_check(CLI::App& program);

    InfoOptions info_;
    EvalOptions eval_;
    ApplyOptions apply_;
    CheckOptions check_;
    bool lists_operations_ = false;
    const CLI::App* info_command_ = nullptr;
    const CLI::App* eval_command_ = nullptr;
    const CLI::App* apply_command_ = nullptr;
    const CLI::App* check_command_ = nullptr;
};

}  // namespace batten::cli
