#include "app/editor/session.h"

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

namespace batten::editor {

namespace {

using Json = nlohmann::json;

// Whole numbers without ".0", as a person would write them.
Json json_of(double value) {
    constexpr double exact_up_to = 1e15;
    const bool is_whole =
        std::trunc(value) == value && std::abs(value) < exact_up_to && !(value == 0.0 && std::signbit(value));
    return is_whole ? Json(static_cast<std::int64_t>(value)) : Json(value);
}

Json json_of(const std::string& text) {
    return text;
}

Json json_of(bool value) {
    return value;
}

Json json_of(std::monostate) {
    return nullptr;
}

Json json_of(const Word& word) {
    return word.text;
}

Json json_of(const std::vector<double>& numbers) {
    Json list = Json::array();
    for (const double number : numbers) list.push_back(json_of(number));
    return list;
}

bool is_list_of_numbers(const Json& json) {
    return json.is_array() && std::all_of(json.begin(), json.end(), [](const Json& item) { return item.is_number(); });
}

Outcome<Argument> argument_of(const Json& json) {
    if (json.is_null()) return std::monostate{};
    if (json.is_boolean()) return json.get<bool>();
    if (json.is_number()) return json.get<double>();
    if (json.is_string()) return json.get<std::string>();
    if (is_list_of_numbers(json)) return json.get<std::vector<double>>();
    return tl::unexpected("an argument is " + json.dump() + "; a number, a text or a list of numbers is needed");
}

struct TypedWord {
    std::string text;
    bool is_quoted = false;
};

constexpr const char* blanks = " \t\r\n";

// Takes the next word off the front of `rest`, which begins with it.
Outcome<TypedWord> take_word(std::string_view& rest) {
    const bool is_quoted = rest.front() == '"';
    if (is_quoted) rest.remove_prefix(1);
    const std::size_t end = is_quoted ? rest.find('"') : std::min(rest.find_first_of(blanks), rest.size());
    if (end == std::string_view::npos) return tl::unexpected(Refusal("a quotation mark \" is not closed"));
    TypedWord word{std::string(rest.substr(0, end)), is_quoted};
    rest.remove_prefix(end + (is_quoted ? 1 : 0));
    return word;
}

Outcome<std::vector<TypedWord>> words_of(std::string_view typed) {
    std::vector<TypedWord> words;
    while (true) {
        typed.remove_prefix(std::min(typed.find_first_not_of(blanks), typed.size()));
        if (typed.empty()) return words;
        Outcome<TypedWord> word = take_word(typed);
        if (!word) return tl::unexpected(word.error());
        words.push_back(*std::move(word));
    }
}

}  // namespace

std::string format_command(const Command& command) {
    Json line = Json::array({command.name});
    for (const Argument& argument : command.arguments)
        line.push_back(std::visit([](const auto& value) { return json_of(value); }, argument));
    return line.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Outcome<Command> parse_command(const std::string& line) {
    const Json json = Json::parse(line, nullptr, false);
    if (!json.is_array() || json.empty() || !json.front().is_string())
        return tl::unexpected(
            "a line of a session must be a list that begins with a command, like [\"insert-knot\", 0.5]; found " +
            line);
    Command command{json.front().get<std::string>(), {}};
    for (std::size_t i = 1; i < json.size(); ++i) {
        Outcome<Argument> argument = argument_of(json[i]);
        if (!argument) return tl::unexpected(argument.error());
        command.arguments.push_back(*std::move(argument));
    }
    return command;
}

Outcome<Command> parse_typed_command(const std::string& typed) {
    const Outcome<std::vector<TypedWord>> words = words_of(typed);
    if (!words) return tl::unexpected(words.error());
    if (words->empty()) return tl::unexpected(Refusal("nothing was typed; a command is needed, like insert-knot 0.5"));
    Command command{words->front().text, {}};
    for (std::size_t i = 1; i < words->size(); ++i) {
        const TypedWord& word = (*words)[i];
        command.arguments.push_back(word.is_quoted ? Argument(word.text) : parse_argument(word.text));
    }
    return command;
}

}  // namespace batten::editor
