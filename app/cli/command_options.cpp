#include "app/cli/command_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <optional>

#include "app/editor/words/nearest_name.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"

namespace batten::cli {

namespace {

/// A check of texts, without a description of its own in the help.
CLI::Validator checked_by(std::function<std::string(const std::string&)> problem_of) {
    return CLI::Validator([problem_of = std::move(problem_of)](std::string& text) { return problem_of(text); }, "");
}

/// The number that all of the text is; none for anything else and for what is not finite.
std::optional<double> number_in(const std::string& text) {
    const auto number = core::leading_number(text);
    const bool is_all = number && number->length == text.size() && std::isfinite(number->value);
    return is_all ? std::optional(number->value) : std::nullopt;
}

}  // namespace

CLI::App* add_command(CLI::App& program, const char* name, const char* description) {
    CLI::App* command = program.add_subcommand(name, description);
    command->set_help_all_flag();
    return command;
}

void add_json(CLI::App& command, bool& as_json) {
    command.add_flag("--json", as_json, "Print JSON, whose members stay the same from version to version");
}

CLI::Validator whole_number(std::size_t least, std::size_t most) {
    return checked_by([=](const std::string& text) {
        std::size_t number = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        const bool is_whole = error == std::errc() && end == text.data() + text.size();
        if (is_whole && least <= number && number <= most) return std::string();
        return core::sentence("{found} is no whole number from {least} to {most}",
                              {{"found", text}, {"least", least}, {"most", most}});
    });
}

CLI::Validator number_within(double least, double most) {
    return checked_by([=](const std::string& text) {
        const auto number = number_in(text);
        if (number && least <= *number && *number <= most) return std::string();
        return core::sentence(
            "{found} is no number from {least} to {most}",
            {{"found", text}, {"least", core::shortest_text(least)}, {"most", core::shortest_text(most)}});
    });
}

CLI::Validator number_above_0() {
    return checked_by([](const std::string& text) {
        return number_in(text).value_or(0.0) > 0.0 ? std::string()
                                                   : core::sentence("{found} is no number above 0", {{"found", text}});
    });
}

CLI::Validator length_above_0() {
    return checked_by([](const std::string& text) {
        return number_in(text).value_or(0.0) > 0.0 ? std::string()
                                                   : core::sentence("{found} is no length above 0", {{"found", text}});
    });
}

CLI::Validator one_of(std::vector<std::string> names) {
    return checked_by([names = std::move(names)](const std::string& text) {
        if (std::find(names.begin(), names.end(), text) != names.end()) return std::string();
        const core::Place found("found", text);
        const core::Place possible("names", core::listed_as_alternatives(names));
        if (const auto nearest = editor::nearest_name(text, names))
            return core::sentence("'{found}' is none of them; did you mean '{nearest}'? possible are {names}",
                                  {found, possible, {"nearest", *nearest}});
        return core::sentence("'{found}' is none of them; possible are {names}", {found, possible});
    });
}

}  // namespace batten::cli
