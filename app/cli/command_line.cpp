#include "app/cli/command_line.h"

#include <ostream>

namespace batten::cli {

namespace {

constexpr const char* file_meaning = "A curve file in Batten's own format";
constexpr int most_derivatives = 25;

CLI::App* add_command(CLI::App& program, const char* name, const char* description) {
    CLI::App* command = program.add_subcommand(name, description);
    command->set_help_all_flag();
    return command;
}

void add_json(CLI::App& command, bool& as_json) {
    command.add_flag("--json", as_json, "Print JSON, whose members stay the same from version to version");
}

}  // namespace

CommandLine::CommandLine(CLI::App& program) {
    add_info(program);
    add_eval(program);
    add_apply(program);
    add_check(program);
    // A file may still be called like a subcommand: batten ./info
    program.require_subcommand(0, 1);
}

void CommandLine::add_info(CLI::App& program) {
    CLI::App* command = add_command(program, "info", "Print what the curves of a file are");
    command->add_option("file", info_.file, file_meaning)->required()->type_name("FILE");
    add_json(*command, info_.as_json);
    info_command_ = command;
}

void CommandLine::add_eval(CLI::App& program) {
    CLI::App* command = add_command(program, "eval", "Print points and derivatives of a curve");
    command->add_option("file", eval_.file, file_meaning)->required()->type_name("FILE");
    command->add_option("--at", eval_.at, "A parameter in the domain of the curve; may be given more than once")
        ->required()
        ->allow_extra_args(false)
        ->type_name("U");
    command->add_option("--curve", eval_.curve, "The name of the curve, instead of the active one")->type_name("NAME");
    command
        ->add_option("--derivatives", eval_.derivatives, "How many derivatives to print beside the point, at most 25")
        ->check(CLI::Validator(CLI::Range(0, most_derivatives)).description(""))
        ->type_name("N");
    command
        ->add_option_function<std::string>(
            "--side",
            [this](const std::string& side) { eval_.side = side == "left" ? core::Side::left : core::Side::right; },
            "From where a knot is approached: left or right (which is usual)")
        ->check(CLI::Validator(CLI::IsMember({"left", "right"})).description(""))
        ->type_name("SIDE");
    add_json(*command, eval_.as_json);
    eval_command_ = command;
}

void CommandLine::add_apply(CLI::App& program) {
    CLI::App* command = add_command(program, "apply", "Run operations on a curve, in order, and write the result");
    command->add_option("file", apply_.file, file_meaning)->type_name("FILE");
    command
        ->add_option("operations", apply_.operations,
                     "Commands of the palette, each followed by its arguments: insert-knot 0.5 elevate 1 split 0.25")
        ->type_name("OPERATION");
    command->add_option("-o,--output", apply_.result, "Where the result is written; left out, it is not kept")
        ->type_name("FILE");
    command->add_option("--curve", apply_.curve, "The curve to begin with, instead of the active one")
        ->type_name("NAME");
    command->add_flag("--list", lists_operations_, "Explain all operations");
    add_json(*command, apply_.as_json);
    apply_command_ = command;
}

void CommandLine::add_check(CLI::App& program) {
    CLI::App* command = add_command(program, "check", "Say whether files are valid, and what is wrong where not");
    command->add_option("files", check_.files, "Curve files")->required()->type_name("FILE");
    add_json(*command, check_.as_json);
    check_command_ = command;
}

std::optional<ExitStatus> CommandLine::run(Output output) const {
    if (info_command_->parsed()) return info(info_, output);
    if (eval_command_->parsed()) return eval(eval_, output);
    if (check_command_->parsed()) return check(check_, output);
    if (!apply_command_->parsed()) return std::nullopt;
    if (lists_operations_) {
        list_operations(output.results);
        return ExitStatus::done;
    }
    if (!apply_.file.empty() && !apply_.operations.empty()) return apply(apply_, output);
    output.errors << "batten apply: a file and one operation or more are needed; batten apply --list explains them\n";
    return ExitStatus::wrong_usage;
}

}  // namespace batten::cli
