/// The words of the subcommands on the command line. Only for sources that read CLI11.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/subcommands.h"

namespace batten::cli {

/// Adds the subcommands to a program's command line and runs the one that was given.
class Subcommands {
  public:
    explicit Subcommands(CLI::App& program);

    /// Reads the words behind the program's name.
    void parse(CLI::App& program, const std::vector<std::string>& words);

    /// What the subcommand ended with; none where none was given. To be called after parsing.
    std::optional<ExitStatus> run(Output output) const;

  private:
    ExitStatus run_check(Output output) const;
    ExitStatus run_eval(Output output) const;
    ExitStatus run_new(Output output) const;
    ExitStatus run_apply(Output output) const;
    void add_info(CLI::App& program);
    void add_eval(CLI::App& program);
    void add_apply(CLI::App& program);
    void add_new(CLI::App& program);
    void add_check(CLI::App& program);
    void add_convert(CLI::App& program);
    void add_handout(CLI::App& program);
    void add_code(CLI::App& program);
    void add_figure(CLI::App& program);

    InfoOptions info_;
    EvalOptions eval_;
    ApplyOptions apply_;
    ApplyOptions new_;
    CheckOptions check_;
    ConvertOptions convert_;
    HandoutOptions handout_;
    CodeOptions code_;
    FigureOptions figure_;
    bool lists_operations_ = false;
    const CLI::App* info_command_ = nullptr;
    const CLI::App* eval_command_ = nullptr;
    const CLI::App* apply_command_ = nullptr;
    const CLI::App* new_command_ = nullptr;
    const CLI::App* check_command_ = nullptr;
    const CLI::App* convert_command_ = nullptr;
    const CLI::App* handout_command_ = nullptr;
    const CLI::App* code_command_ = nullptr;
    const CLI::App* figure_command_ = nullptr;
};

}  // namespace batten::cli
