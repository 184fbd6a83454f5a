#include <algorithm>
#include <cmath>

#include "app/editor/command_table.h"
#include "core/base/number_text.h"

namespace batten::editor {

namespace {

const char* name_of(ParameterKind kind) {
    switch (kind) {
        case ParameterKind::number:
            return "a number";
        case ParameterKind::text:
            return "a text";
        case ParameterKind::numbers:
            return "a list of numbers";
    }
    return "an argument";
}

std::string described(const Argument& argument) {
    if (const auto* number = std::get_if<double>(&argument)) return core::shortest_text(*number);
    if (const auto* text = std::get_if<std::string>(&argument)) return "the text '" + *text + "'";
    if (const auto* list = std::get_if<std::vector<double>>(&argument))
        return "a list of " + std::to_string(list->size()) + " numbers";
    return "yes or no";
}

std::string counted(std::size_t count) {
    return count == 1 ? "1 argument" : std::to_string(count) + " arguments";
}

bool is_finite(const Argument& argument) {
    if (const auto* number = std::get_if<double>(&argument)) return std::isfinite(*number);
    if (const auto* numbers = std::get_if<std::vector<double>>(&argument))
        return std::all_of(numbers->begin(), numbers->end(), [](double value) { return std::isfinite(value); });
    return true;
}

Refusal refusal_of_kind(const ParameterSpec& parameter, const Argument& argument) {
    return std::string(parameter.name) + " is " + described(argument) + "; " + name_of(parameter.kind) +
           " is needed, " + parameter.meaning;
}

Outcome<Argument> of_kind(const ParameterSpec& parameter, const Argument& argument) {
    if (!is_finite(argument))
        return tl::unexpected(std::string(parameter.name) + " is not finite; " + name_of(parameter.kind) +
                              " is needed, " + parameter.meaning);
    if (argument.index() == static_cast<std::size_t>(parameter.kind)) return argument;
    if (const auto* word = std::get_if<Word>(&argument)) {
        if (parameter.kind == ParameterKind::text) return word->text;
        return of_kind(parameter, parse_argument(word->text));
    }
    if (const auto* number = std::get_if<double>(&argument)) {
        if (parameter.kind == ParameterKind::numbers) return std::vector<double>{*number};
        return core::shortest_text(*number);
    }
    return tl::unexpected(refusal_of_kind(parameter, argument));
}

Outcome<Argument> suggested(const CommandSpec& spec, const ParameterSpec& parameter, const EditorState& state) {
    const bool has_suggestion = parameter.suggestion != nullptr;
    std::optional<Argument> suggestion = has_suggestion ? parameter.suggestion(state) : std::nullopt;
    if (suggestion) return *std::move(suggestion);
    return tl::unexpected(std::string(spec.name) + " needs " + parameter.name + ", " + parameter.meaning +
                          (has_suggestion ? "; nothing of that kind is selected" : ""));
}

// Which parameters are left out when `given` arguments come: the last ones that have a suggestion.
std::vector<bool> left_out(const CommandSpec& spec, std::size_t given) {
    std::vector<bool> result(spec.parameters.size(), false);
    std::size_t missing = spec.parameters.size() - given;
    for (std::size_t i = spec.parameters.size(); i-- > 0 && missing > 0;) {
        if (spec.parameters[i].suggestion == nullptr) continue;
        result[i] = true;
        --missing;
    }
    return result;
}

}  // namespace

Outcome<Arguments> complete_arguments(const CommandSpec& spec, const EditorState& state,
                                      const std::vector<Argument>& given) {
    if (given.size() > spec.parameters.size())
        return tl::unexpected(std::string(spec.name) + " takes " + counted(spec.parameters.size()) + "; " +
                              std::to_string(given.size()) + (given.size() == 1 ? " was given" : " were given"));
    const std::vector<bool> is_left_out = left_out(spec, given.size());
    std::vector<Argument> values;
    auto next = given.begin();
    for (std::size_t i = 0; i < spec.parameters.size(); ++i) {
        const ParameterSpec& parameter = spec.parameters[i];
        const bool is_given = !is_left_out[i] && next != given.end();
        Outcome<Argument> value = is_given ? of_kind(parameter, *next++) : suggested(spec, parameter, state);
        if (!value) return tl::unexpected(value.error());
        values.push_back(*std::move(value));
    }
    return Arguments(std::move(values));
}

}  // namespace batten::editor
