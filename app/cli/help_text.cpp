#include "app/cli/help_text.h"

namespace batten::cli {

namespace {

// "\nOptions:\n  ..." without its first two lines; empty where there are none.
std::string without_heading(const std::string& group) {
    const std::size_t colon = group.find(":\n");
    return colon == std::string::npos ? "" : group.substr(colon + 2);
}

std::string subcommand_text(const CLI::App& subcommand) {
    const CLI::Formatter plain;
    return "\nSubcommand " + subcommand.get_name() + ":\n  " + subcommand.get_description() + ".\n\n" +
           without_heading(plain.make_positionals(&subcommand)) +
           without_heading(plain.make_groups(&subcommand, CLI::AppFormatMode::All));
}

}  // namespace

std::string help_text(const CLI::App* app, std::string name, CLI::AppFormatMode mode) {
    const CLI::Formatter plain;
    std::string text = plain.make_help(app, std::move(name), CLI::AppFormatMode::Normal);
    if (mode != CLI::AppFormatMode::All) return text;
    for (const CLI::App* subcommand : app->get_subcommands([](const CLI::App*) { return true; }))
        text += subcommand_text(*subcommand);
    return text;
}

}  // namespace batten::cli
