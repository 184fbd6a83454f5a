#include "app/cli/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <new>
#include <ostream>

#include "app/cli/help_text.h"
#include "app/cli/say.h"
#include "app/cli/standard_streams.h"
#include "app/cli/subcommand_words.h"
#include "app/cli/usage_problem.h"
#include "app/cli/window_options.h"
#include "core/base/sentence.h"
#include "core/base/version.h"

namespace batten::cli {

namespace {

// "--json=no" would ask for JSON.
void refuse_values_of_flags(CLI::App& program) {
    for (CLI::App* command : program.get_subcommands([](CLI::App*) { return true; }))
        for (CLI::Option* option : command->get_options())
            if (option->get_items_expected_max() == 0) option->disable_flag_override();
}

// An empty name is that of a variable of a script that is not set; an option instead of one, that of a file that was
// forgotten.
std::optional<std::string> problem_of_result(const CLI::App& program) {
    for (const CLI::App* command : program.get_subcommands()) {
        const CLI::Option* option = command->get_option_no_throw("--output");
        if (option == nullptr || option->count() == 0) continue;
        const std::string& file = option->results().back();
        if (file.empty())
            return core::sentence("batten {command}: -o: the name of the file is empty; - is standard output",
                                  {{"command", command->get_name()}});
        if (file.front() == '-' && command->get_option_no_throw(file) != nullptr)
            return core::sentence(
                "batten {command}: -o: '{option}' is an option, not a file; './{option}' is a file of that name",
                {{"command", command->get_name()}, {"option", file}});
    }
    return std::nullopt;
}

// What the process ends with; none where the window is to be opened.
std::optional<ExitStatus> parse_and_run(const std::vector<std::string>& words, WindowOptions* window, Output output) {
    CLI::App program("Batten: an interactive editor for B-spline and NURBS curves", "batten");
    program.set_version_flag("--version", core::sentence("batten {version}", {{"version", core::version_text}}));
    program.set_help_all_flag("--help-all", "Print this help and that of the subcommands and exit");
    program.formatter_fn(help_text);
    program.footer(
        "Without a subcommand the window opens.\n\n"
        "Exit status:\n  0 if everything was done, 1 if the input is wrong or the results cannot be written, 2 if "
        "the "
        "command line is wrong.");
    Subcommands subcommands(program);
    std::optional<ProfileSubcommand> profile;
    if (window != nullptr) {
        profile.emplace(program);
        add_window_options(program, *window);
    }
    refuse_values_of_flags(program);
    try {
        subcommands.parse(program, words);
    } catch (const CLI::Success& asked) {
        program.exit(asked, output.results, output.errors);
        return ExitStatus::done;
    } catch (const CLI::ParseError& error) {
        return say_wrong_usage(output, usage_problem(program, error));
    }
    if (window != nullptr && profile->is_given()) {
        window->profile = profile->options(output);
        return window->profile ? std::nullopt : std::optional(ExitStatus::wrong_usage);
    }
    if (const auto problem = problem_of_window_words(program)) return say_wrong_usage(output, *problem);
    if (const auto problem = problem_of_result(program)) return say_wrong_usage(output, *problem);
    if (const auto status = subcommands.run(output)) return status;
    if (window != nullptr) {
        for (const std::filesystem::path& file : window->files)
            if (const auto problem = problem_of_file(program, file.string())) return say_wrong_usage(output, *problem);
        if (const auto problem = problem_of_written_files(*window)) return say_wrong_usage(output, *problem);
        return std::nullopt;
    }
    return say_wrong_usage(output,
                           "batten: this build has no window; the subcommands are info, eval, apply, new, convert, "
                           "check, handout, code and figure");
}

}  // namespace

std::optional<int> run_command_line(int argc, const char* const* argv, WindowOptions* window, Output output) {
    std::optional<ExitStatus> status;
    ResultBuffer buffer(output);
    std::ostream results(&buffer);
    try {
        status = parse_and_run({argv + std::min(argc, 1), argv + argc}, window, {results, output.errors});
    } catch (const std::bad_alloc&) {
        output.errors << "batten: there is not enough memory\n";
        status = ExitStatus::wrong_input;
    }
    if (!status) return std::nullopt;
    if (!buffer.finish() && status == ExitStatus::done) status = ExitStatus::wrong_input;
    return static_cast<int>(*status);
}

}  // namespace batten::cli
