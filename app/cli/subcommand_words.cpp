#include "app/cli/subcommand_words.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/cli/command_options.h"
#include "app/cli/divided_words.h"
#include "app/cli/figure_words.h"
#include "app/cli/say.h"
#include "app/cli/standard_streams.h"
#include "app/cli/table_argument.h"
#include "app/editor/fields/expression.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"

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

}  // namespace

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

}  // namespace batten::cli
