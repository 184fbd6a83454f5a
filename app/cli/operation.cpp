#include "app/cli/operation.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "app/editor/session.h"

namespace batten::cli {

namespace {

constexpr std::array<std::string_view, 6> choices{"activate-curve", "select-points", "select-knot",
                                                  "select-all",     "select-none",   "set-parameter"};

const editor::CommandSpec* operation_called(const std::string& name) {
    const editor::CommandSpec* spec = editor::find_command(name);
    return spec != nullptr && is_operation(*spec) ? spec : nullptr;
}

// Takes the words from `next` on that are arguments of `spec`.
Operation take_operation(const editor::CommandSpec& spec, const std::vector<std::string>& words, std::size_t& next) {
    Operation operation{{spec.name, {}}, spec.name};
    for (const editor::ParameterSpec& parameter : spec.parameters) {
        if (next == words.size()) break;
        // A text may be anything, also the name of an operation, unless it can be left out.
        const bool must_be_given = parameter.kind == editor::ParameterKind::text && parameter.suggestion == nullptr;
        if (!must_be_given && operation_called(words[next]) != nullptr) break;
        operation.text += " " + words[next];
        operation.command.arguments.push_back(editor::parse_argument(words[next]));
        ++next;
    }
    return operation;
}

editor::Refusal no_operation(const std::string& word, const std::vector<Operation>& before) {
    const std::string place = before.empty() ? "" : " after '" + before.back().text + "'";
    return "'" + word + "'" + place + " is no operation; batten apply --list explains those there are";
}

}  // namespace

bool is_operation(const editor::CommandSpec& spec) {
    // The eight of them are for the arrow keys; a script says nudge.
    if (std::string_view(spec.name).starts_with("nudge-")) return false;
    if (spec.group == editor::CommandGroup::gesture || spec.group == editor::CommandGroup::file) return false;
    return spec.edit != nullptr || spec.group == editor::CommandGroup::analyze ||
           std::find(choices.begin(), choices.end(), spec.name) != choices.end();
}

editor::Outcome<std::vector<Operation>> parse_operations(const std::vector<std::string>& words) {
    std::vector<Operation> operations;
    for (std::size_t next = 0; next < words.size();) {
        const editor::CommandSpec* spec = operation_called(words[next]);
        if (spec == nullptr) return tl::unexpected(no_operation(words[next], operations));
        ++next;
        operations.push_back(take_operation(*spec, words, next));
    }
    return operations;
}

}  // namespace batten::cli
