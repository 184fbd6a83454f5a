#include "app/cli/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <new>
#include <ostream>

#include "app/cli/command_options.h"
#include "app/cli/divided_words.h"
#include "app/cli/figure_words.h"
#include "app/cli/help_text.h"
#include "app/cli/say.h"
#include "app/cli/standard_streams.h"
#include "app/cli/table_argument.h"
#include "app/cli/usage_problem.h"
#include "app/cli/window_options.h"
#include "app/editor/fields/expression.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/base/version.h"

namespace batten::cli {

namespace {

constexpr const char* file_meaning =
    "A curve file of Batten, or of the program that its ending names; - is standard input";
constexpr const char* result_meaning = "Where the result is written; - is standard output";
constexpr std::size_t most_derivatives = 25;
constexpr std::size_t least_samples = 2;
constexpr std::size_t most_samples = 10'000'000;

// Replaces a formula by the number that it stands for; returns what is wrong with it. The name of a table stays.
std::string evaluate(std::string& text) {
    if (names_table(text)) return {};
    const auto value = editor::parse_expression(text);
    if (!value) return core::sentence("{found}: {problem}", {{"found", text}, {"problem", value.error()}});
    text = core::shortest_text(*value);
    return {};
}

FileKind kind_named(const std::string& name) {
    const auto format = core::value_named<exchange::Format>(name);
    return format ? FileKind(*format) : FileKind(NativeKind{});
}

// `meaning` has a place for the names.
void add_kind(CLI::App& command, const char* option, std::optional<FileKind>& kind, const char* meaning) {
    std::vector<std::string> names{"batten"};
    for (const auto& entry : core::Names<exchange::Format>::table) names.emplace_back(entry.name);
    command
        .add_option_function<std::string>(
            option, [&kind](const std::string& name) { kind = kind_named(name); },
            core::sentence(meaning, {{"names", core::listed_as_alternatives(names)}}))
        ->check(one_of(names))
        ->type_name("FORMAT");
}

void add_operations(CLI::App& command, ApplyOptions& options) {
    command
        .add_option("operations", options.operations,
                    "Commands of the palette, each followed by its arguments: insert-knot 0.5 elevate 1 split 0.25; "
                    "-- ends the arguments of one; @FILE stands for a list that is read from a table of numbers, @- "
                    "for one from "
                    "standard input")
        ->type_name("OPERATION");
    command.add_option("-o,--output", options.result, result_meaning)->type_name("FILE");
}

// Adds the subcommands to a program's command line and runs the one that was given.
class Subcommands {
  public:
    explicit Subcommands(CLI::App& program);

    // Reads the words behind the program's name.
    void parse(CLI::App& program, const std::vector<std::string>& words);

    // What the subcommand ended with; none where none was given. To be called after parsing.
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

Subcommands::Subcommands(CLI::App& program) {
    add_info(program);
    add_eval(program);
    add_apply(program);
    add_new(program);
    add_convert(program);
    add_check(program);
    add_handout(program);
    add_code(program);
    add_figure(program);
    // A file may still be called like a subcommand: batten ./info
    program.require_subcommand(0, 1);
}

void Subcommands::add_info(CLI::App& program) {
    CLI::App* command = add_command(program, "info", "Describe the curves of a file");
    command->add_option("file", info_.file, file_meaning)->required()->type_name("FILE");
    add_json(*command, info_.as_json);
    info_command_ = command;
}

void Subcommands::add_eval(CLI::App& program) {
    CLI::App* command = add_command(program, "eval", "Print points, derivatives and basis functions of a curve");
    command->add_option("file", eval_.file, file_meaning)->required()->type_name("FILE");
    command
        ->add_option(
            "--at", eval_.at,
            "A parameter in the domain of the curve, or @FILE for a table of them; may be given more than once")
        ->required()
        ->allow_extra_args(false)
        ->transform(CLI::Validator(evaluate, ""))
        ->type_name("U");
    command->add_option("--curve", eval_.curve, "The name or number of the curve, instead of the active one")
        ->type_name("NAME");
    command
        ->add_option("--derivatives", eval_.derivatives, "How many derivatives to print beside each value, at most 25")
        ->check(whole_number(0, most_derivatives))
        ->type_name("N");
    command->add_flag("--basis", eval_.basis,
                      "Print the basis functions that do not vanish there instead of points, a line for each: the "
                      "parameter, i, N_i and its derivatives, and for a rational curve R_i and its derivatives");
    command
        ->add_option_function<std::string>(
            "--side",
            [this](const std::string& side) { eval_.side = side == "left" ? core::Side::left : core::Side::right; },
            "The side from which a knot is approached: left or right (the default)")
        ->check(one_of({"left", "right"}))
        ->type_name("SIDE");
    add_json(*command, eval_.as_json);
    eval_command_ = command;
}

void Subcommands::add_apply(CLI::App& program) {
    CLI::App* command = add_command(program, "apply", "Run operations on a curve, in order, and write the result");
    command->add_option("file", apply_.file, file_meaning)->type_name("FILE");
    add_operations(*command, apply_);
    command
        ->add_option("--curve", apply_.curve,
                     "The name or number of the curve to begin with, instead of the active one")
        ->type_name("NAME");
    command->add_flag("--list", lists_operations_, "Explain all operations");
    add_json(*command, apply_.as_json);
    apply_command_ = command;
}

void Subcommands::add_new(CLI::App& program) {
    CLI::App* command = add_command(program, "new", "Run operations on an empty document, and write the result");
    add_operations(*command, new_);
    add_json(*command, new_.as_json);
    new_command_ = command;
}

void Subcommands::add_check(CLI::App& program) {
    CLI::App* command = add_command(program, "check", "Check whether files are valid, and say what is wrong if not");
    command->add_option("files", check_.files, "Curve files; - is standard input")->required()->type_name("FILE");
    command->add_flag("--joints", check_.joints,
                      "List where ends of curves are near each other and where a curve is not smooth, with what jumps "
                      "there");
    command->add_option("--within", check_.within, "How near ends must be to be a joint")
        ->type_name("LENGTH")
        ->check(length_above_0());
    add_json(*command, check_.as_json);
    check_command_ = command;
}

void Subcommands::add_convert(CLI::App& program) {
    CLI::App* command = add_command(program, "convert", "Read curves from one kind of file and write them to another");
    command->add_option("file", convert_.file, file_meaning)->required()->type_name("FILE");
    command->add_option("-o,--output", convert_.result, "Where the curves are written; - is standard output")
        ->required()
        ->type_name("FILE");
    add_kind(*command, "--from", convert_.from, "What kind of file it is, instead of by its ending: {names}");
    add_kind(*command, "--to", convert_.to, "What kind of file is written, instead of by its ending: {names}");
    command
        ->add_option("--tolerance", convert_.write.tolerance,
                     "How far curves may be from their copies where the format cannot hold them as they are (default: "
                     "a millionth of the size of the drawing)")
        ->check(length_above_0())
        ->type_name("LENGTH");
    command->add_option("--samples", convert_.write.samples, "How many rows a curve has in a table (default: 101)")
        ->check(whole_number(least_samples, most_samples))
        ->type_name("N");
    add_json(*command, convert_.as_json);
    convert_command_ = command;
}

void Subcommands::add_handout(CLI::App& program) {
    CLI::App* command = add_command(program, "handout", "Write a lesson as a page to be printed");
    command->add_option("lesson", handout_.lesson, "The file of a lesson")->required()->type_name("LESSON");
    command->add_option("-o,--output", handout_.result, "Where the page, HTML, is written; - is standard output")
        ->required()
        ->type_name("FILE");
    handout_command_ = command;
}

void Subcommands::add_code(CLI::App& program) {
    CLI::App* command = add_command(program, "code", "Print a curve as text for programs and papers");
    command->add_option("file", code_.file, file_meaning)->required()->type_name("FILE");
    std::vector<std::string> languages;
    for (const auto& entry : core::Names<exchange::CodeLanguage>::table) languages.emplace_back(entry.name);
    command
        ->add_option_function<std::string>(
            "--as",
            [this](const std::string& name) { code_.language = *core::value_named<exchange::CodeLanguage>(name); },
            core::sentence("The language: {languages}", {{"languages", core::listed_as_alternatives(languages)}}))
        ->required()
        ->check(one_of(languages))
        ->type_name("LANGUAGE");
    command->add_option("--curve", code_.curve, "The name or number of the curve, instead of the active one")
        ->type_name("NAME");
    code_command_ = command;
}

void Subcommands::add_figure(CLI::App& program) {
    CLI::App* command = add_command(program, "figure", "Write a picture of a curve for a slide or a paper");
    add_figure_words(*command, figure_);
    figure_command_ = command;
}

void Subcommands::parse(CLI::App& program, const std::vector<std::string>& words) {
    ApplyOptions* options = nullptr;
    if (!words.empty() && words.front() == "apply") options = &apply_;
    if (!words.empty() && words.front() == "new") options = &new_;
    DividedWords divided_words{words, {}};
    if (options != nullptr) {
        divided_words = divided({words.begin() + 1, words.end()}, options == &apply_);
        divided_words.options.insert(divided_words.options.begin(), words.front());
    }
    std::reverse(divided_words.options.begin(), divided_words.options.end());
    program.parse(divided_words.options);
    if (options != nullptr) options->operations = std::move(divided_words.operations);
}

std::optional<ExitStatus> Subcommands::run(Output output) const {
    if (info_command_->parsed()) return info(info_, output);
    if (eval_command_->parsed()) return run_eval(output);
    if (check_command_->parsed()) return run_check(output);
    if (convert_command_->parsed()) return convert(convert_, output);
    if (handout_command_->parsed()) return handout(handout_, output);
    if (code_command_->parsed()) return code(code_, output);
    if (figure_command_->parsed()) return figure(figure_, output);
    if (new_command_->parsed()) return run_new(output);
    if (apply_command_->parsed()) return run_apply(output);
    return std::nullopt;
}

ExitStatus say_wrong_usage(Output output, const std::string& sentence) {
    say(output, sentence);
    return ExitStatus::wrong_usage;
}

ExitStatus Subcommands::run_check(Output output) const {
    if (std::count_if(check_.files.begin(), check_.files.end(), is_standard) > 1)
        return say_wrong_usage(output, "batten check: standard input, -, can be read only once");
    return check(check_, output);
}

ExitStatus Subcommands::run_eval(Output output) const {
    const auto inputs = std::count_if(eval_.at.begin(), eval_.at.end(), names_standard_input);
    if (inputs + (is_standard(eval_.file) ? 1 : 0) > 1)
        return say_wrong_usage(output, "batten eval: standard input, -, can be read only once");
    return eval(eval_, output);
}

ExitStatus Subcommands::run_new(Output output) const {
    if (!new_.operations.empty() || !new_.result.empty()) return apply(new_, output);
    return say_wrong_usage(
        output, "batten new: at least one operation, or a file to write, is needed; batten apply --list explains them");
}

ExitStatus Subcommands::run_apply(Output output) const {
    if (lists_operations_) {
        list_operations(output.results);
        return ExitStatus::done;
    }
    if (apply_.file && !apply_.operations.empty()) return apply(apply_, output);
    return say_wrong_usage(
        output, "batten apply: a file and at least one operation are needed; batten apply --list explains them");
}

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
