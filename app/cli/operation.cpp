#include "app/cli/operation.h"

#include <fmt/core.h>

#include "app/editor/command_table.h"
#include "app/editor/field_text.h"
#include "core/base/sentence.h"

namespace batten::cli {

namespace {

using core::sentence;

const editor::CommandSpec* operation_called(const std::string& name) {
    const editor::CommandSpec* spec = editor::find_command(name);
    return spec != nullptr && spec->offered.scripts ? spec : nullptr;
}

// A text may be anything, also the name of an operation, unless it can be left out.
bool takes_any_word(const editor::Field& field) {
    return editor::takes_text(field) && !field.can_be_left_out();
}

// Takes the words from `next` on that are arguments of `spec`.
Operation take_operation(const editor::CommandSpec& spec, const std::vector<std::string>& words, std::size_t& next) {
    Operation operation{&spec, {}, spec.name};
    for (const editor::Field& field : spec.fields)
        for (std::size_t part = 0; part < field.parts.size(); ++part) {
            if (next == words.size()) return operation;
            if (!takes_any_word(field) && operation_called(words[next]) != nullptr) return operation;
            operation.text = fmt::format("{} {}", operation.text, words[next]);
            operation.arguments.emplace_back(editor::Word{words[next]});
            ++next;
        }
    return operation;
}

editor::Refusal no_operation(const std::string& word, const std::vector<Operation>& before) {
    if (before.empty())
        return sentence("'{word}' is not an operation; batten apply --list explains all of them", {{"word", word}});
    return sentence("'{word}' after '{before}' is not an operation; batten apply --list explains all of them",
                    {{"word", word}, {"before", before.back().text}});
}

}  // namespace

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
