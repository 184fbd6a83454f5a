#include "app/cli/usage_problem.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <string_view>
#include <vector>

#include "app/editor/words/nearest_name.h"
#include "core/base/ascii.h"
#include "core/base/sentence.h"

namespace batten::cli {

namespace {

using core::sentence;
using Problem = std::optional<std::string>;

/// "batten figure", or "batten" before any subcommand.
std::string name_of(const CLI::App& command) {
    if (command.get_parent() == nullptr) return command.get_name();
    return sentence("{program} {command}",
                    {{"program", command.get_parent()->get_name()}, {"command", command.get_name()}});
}

std::vector<const CLI::Option*> options_of(const CLI::App& command) {
    return command.get_options([](const CLI::Option*) { return true; });
}

/// "FILE" of a word by its place, "--output FILE" of an option, "--json" of a flag.
std::string usage_of(const CLI::Option& option) {
    if (option.get_positional()) return option.get_type_name();
    if (option.get_items_expected_max() == 0) return option.get_name();
    return sentence("{option} {type}", {{"option", option.get_name()}, {"type", option.get_type_name()}});
}

std::string unknown_option(const CLI::App& command, const std::string& given) {
    const std::string word = given.substr(0, given.find('='));
    const std::string_view name = core::trimmed(word, "-");
    std::vector<std::string> names;
    for (const CLI::Option* option : options_of(command))
        names.insert(names.end(), option->get_lnames().begin(), option->get_lnames().end());
    const core::Place place("command", name_of(command));
    if (const auto nearest = editor::nearest_name(name, names))
        return sentence("{command}: there is no option '{word}'; did you mean '--{nearest}'?",
                        {place, {"word", word}, {"nearest", *nearest}});
    return sentence("{command}: there is no option '{word}'; '{command} --help' explains those that there are",
                    {place, {"word", word}});
}

/// Why `word`, which is no file, is no subcommand either.
std::string no_subcommand(const CLI::App& program, const std::string& word) {
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    if (const auto nearest = editor::nearest_name(word, names))
        return sentence("batten: '{word}' is neither a file to open nor a subcommand; did you mean 'batten {nearest}'?",
                        {{"word", word}, {"nearest", *nearest}});
    return sentence("batten: '{word}' is neither a file to open nor a subcommand; a subcommand is {names}",
                    {{"word", word}, {"names", core::listed_as_alternatives(names)}});
}

std::string one_word_too_many(const CLI::App& command, const std::string& word) {
    if (command.get_parent() == nullptr) return no_subcommand(command, word);
    const core::Place place("command", name_of(command));
    for (const CLI::Option* option : options_of(command))
        if (option->get_positional())
            return sentence("{command}: there is no place for '{word}'; beside options one {type} is taken",
                            {place, {"word", word}, {"type", option->get_type_name()}});
    return sentence("{command}: there is no place for '{word}'; options are taken", {place, {"word", word}});
}

/// About the first word that nothing takes.
Problem problem_of_words_left(const CLI::App& command) {
    bool is_behind_mark = false;
    for (const std::string& word : command.remaining(false)) {
        const bool is_option = !is_behind_mark && word.size() > 1 && word.front() == '-';
        if (word == "--")
            is_behind_mark = true;
        else
            return is_option ? unknown_option(command, word) : one_word_too_many(command, word);
    }
    return std::nullopt;
}

/// About an option that was given more than once.
Problem problem_of_counts(const CLI::App& command) {
    for (const CLI::Option* option : options_of(command)) {
        const std::size_t count = option->results().size();
        const int most = option->get_items_expected_max();
        if (most == 0 || count <= static_cast<std::size_t>(most)) continue;
        return sentence("{command}: {option} is given {count} times, the last time as '{value}'; it can be given once",
                        {{"command", name_of(command)},
                         {"option", option->get_name()},
                         {"count", count},
                         {"value", option->results().back()}});
    }
    return std::nullopt;
}

/// Whether the parser's words, "--title: 1 required", begin with the option.
bool is_about(std::string_view told, const CLI::Option& option) {
    const std::string_view behind_dashes = core::trimmed(told, "-");
    return std::ranges::any_of(option.get_lnames(), [&](const std::string& name) {
        return behind_dashes.starts_with(name) && behind_dashes.substr(name.size()).find_first_of(": ") == 0;
    });
}

/// About an option whose value did not come, or a flag with one.
Problem problem_of_value(const CLI::App& command, const CLI::ParseError& error) {
    for (const CLI::Option* option : options_of(command)) {
        if (!is_about(error.what(), *option)) continue;
        if (option->get_items_expected_max() == 0)
            return sentence("{command}: {option} takes no value; it stands alone",
                            {{"command", name_of(command)}, {"option", option->get_name()}});
        return sentence("{command}: {option}: nothing stands behind it; {type} is needed: {meaning}",
                        {{"command", name_of(command)},
                         {"option", option->get_name()},
                         {"type", option->get_type_name()},
                         {"meaning", option->get_description()}});
    }
    return std::nullopt;
}

/// About what must be given and was not.
Problem problem_of_missing(const CLI::App& command) {
    for (const CLI::Option* option : options_of(command))
        if (option->get_required() && option->count() == 0)
            return sentence("{command}: {missing} is missing: {meaning}", {{"command", name_of(command)},
                                                                           {"missing", usage_of(*option)},
                                                                           {"meaning", option->get_description()}});
    return std::nullopt;
}

const CLI::App& command_of(const CLI::App& program) {
    const auto given = program.get_subcommands();
    return given.empty() ? program : *given.front();
}

}  // namespace

std::string usage_problem(const CLI::App& program, const CLI::ParseError& error) {
    const CLI::App& command = command_of(program);
    Problem problem = problem_of_words_left(program);
    if (!problem) problem = problem_of_words_left(command);
    if (!problem) problem = problem_of_counts(command);
    if (!problem && dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr)
        problem = problem_of_value(command, error);
    if (!problem && dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) problem = problem_of_missing(command);
    // What the checks of options say begins with the option.
    return problem.value_or(sentence("{command}: {told}", {{"command", name_of(command)}, {"told", error.what()}}));
}

Problem problem_of_window_words(const CLI::App& program) {
    const CLI::App& command = command_of(program);
    if (&command == &program) return std::nullopt;
    for (const CLI::Option* option : options_of(program)) {
        if (option->count() == 0) continue;
        if (option->get_positional()) return one_word_too_many(command, option->results().front());
        return sentence("{command}: {option} is for the window, which '{command}' does not open",
                        {{"command", name_of(command)}, {"option", option->get_name()}});
    }
    return std::nullopt;
}

Problem problem_of_file(const CLI::App& command, const std::string& file) {
    std::error_code error;
    const std::initializer_list<core::Place> places{{"command", name_of(command)}, {"file", file}};
    if (std::filesystem::is_directory(file, error))
        return sentence("{command}: {file} is a folder; files with curves are opened", places);
    if (std::filesystem::exists(file, error)) return std::nullopt;
    const bool can_be_subcommand = command.get_parent() == nullptr && file.find_first_of("./") == std::string::npos;
    return can_be_subcommand ? no_subcommand(command, file) : sentence("{command}: there is no file {file}", places);
}

}  // namespace batten::cli
