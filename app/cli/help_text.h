/// The help of the whole program in the layout from which help2man makes the manual page.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "core/base/sentence.h"

namespace batten::cli {

/// "\nOptions:\n  ..." without its first two lines; empty where there are none.
inline std::string without_heading(const std::string& group) {
    const std::size_t colon = group.find(":\n");
    return colon == std::string::npos ? "" : group.substr(colon + 2);
}

inline std::string subcommand_text(const CLI::App& subcommand) {
    const CLI::Formatter plain;
    return core::sentence("\nSubcommand {name}:\n  {description}.\n\n{arguments}{options}",
                          {{"name", subcommand.get_name()},
                           {"description", subcommand.get_description()},
                           {"arguments", without_heading(plain.make_positionals(&subcommand))},
                           {"options", without_heading(plain.make_groups(&subcommand, CLI::AppFormatMode::All))}});
}

/// The help of `app`; with CLI::AppFormatMode::All also that of its subcommands, each under a heading of its own.
inline std::string help_text(const CLI::App* app, std::string name, CLI::AppFormatMode mode) {
    const CLI::Formatter plain;
    std::string text = plain.make_help(app, std::move(name), CLI::AppFormatMode::Normal);
    if (mode != CLI::AppFormatMode::All) return text;
    for (const CLI::App* subcommand : app->get_subcommands([](const CLI::App*) { return true; }))
        text.append(subcommand_text(*subcommand));
    return text;
}

}  // namespace batten::cli
