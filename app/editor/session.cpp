#include "app/editor/session.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/editor/command_reader.h"
#include "app/editor/command_table.h"
#include "app/editor/commands/knot_commands.h"
#include "core/base/sentence.h"
#include "core/document/json_check.h"

namespace batten::editor {

namespace {

using Line = nlohmann::json;

// Whole numbers without ".0", as a person would write them.
Line json_of_number(double value) {
    constexpr double exact_up_to = 1e15;
    const bool is_whole =
        std::trunc(value) == value && std::abs(value) < exact_up_to && !(value == 0.0 && std::signbit(value));
    return is_whole ? Line(static_cast<std::int64_t>(value)) : Line(value);
}

// One case for each type of argument.
struct JsonOf {
    Line operator()(std::monostate) const { return nullptr; }
    Line operator()(bool value) const { return value; }
    Line operator()(double value) const { return json_of_number(value); }
    Line operator()(const std::string& text) const { return text; }
    Line operator()(const Word& word) const { return word.text; }
    Line operator()(const std::vector<double>& numbers) const {
        Line list = Line::array();
        for (const double number : numbers) list.push_back(json_of_number(number));
        return list;
    }
};

bool is_list_of_numbers(const Line& json) {
    return json.is_array() && std::all_of(json.begin(), json.end(), [](const Line& item) { return item.is_number(); });
}

Outcome<Argument> argument_of(const Line& json) {
    if (json.is_null()) return std::monostate{};
    if (json.is_boolean()) return json.get<bool>();
    if (json.is_number()) return json.get<double>();
    if (json.is_string()) return json.get<std::string>();
    if (is_list_of_numbers(json)) return json.get<std::vector<double>>();
    return tl::unexpected(core::sentence("an argument is {found}; a number, a text or a list of numbers is needed",
                                         {{"found", json.dump()}}));
}

// In version 0.1 a knot in the mode "stop" joined its neighbor. Its lines are told by their snap distance, which that
// mode has no more.
void bring_up_to_date(const CommandSpec& spec, std::vector<Argument>& arguments) {
    const bool joined = &spec == &MoveKnot::spec() && arguments.size() == 4 && arguments[2] == Argument("stop") &&
                        std::holds_alternative<double>(arguments[3]);
    if (!joined) return;
    arguments[2] = "snap";
    arguments[3] = 0.0;
}

}  // namespace

std::string format_command(const Command& command) {
    Line line = Line::array({command.spec().name});
    for (const Argument& argument : arguments_of(command)) line.push_back(std::visit(JsonOf{}, argument));
    return line.dump(-1, ' ', false, Line::error_handler_t::replace);
}

Outcome<Command> parse_command(const std::string& line, const EditorState& state) {
    if (const auto check = core::check_json(line); !check)
        return tl::unexpected(
            core::sentence("a line of a session must be JSON: {reason}", {{"reason", check.error().sentence()}}));
    const Line json = Line::parse(line, nullptr, false);
    if (!json.is_array() || json.empty() || !json.front().is_string())
        return tl::unexpected(
            Refusal("a line of a session must be a list that begins with a command, like [\"insert-knot\", 0.5]"));
    const Outcome<const CommandSpec*> spec = command_named(json.front().get<std::string>());
    if (!spec) return tl::unexpected(spec.error());
    std::vector<Argument> arguments;
    for (std::size_t i = 1; i < json.size(); ++i) {
        Outcome<Argument> argument = argument_of(json[i]);
        if (!argument) return tl::unexpected(argument.error());
        arguments.push_back(*std::move(argument));
    }
    bring_up_to_date(**spec, arguments);
    return read_command(**spec, state, arguments);
}

}  // namespace batten::editor
