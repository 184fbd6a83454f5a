#include "app/cli/operation.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/editor/command_reader.h"
#include "app/editor/command_table.h"
#include "app/editor/fields/field_text.h"
#include "app/editor/words/nearest_name.h"
#include "core/base/sentence.h"

namespace batten::cli {

namespace {

using core::sentence;
using editor::Field;
using editor::FieldKind;

// The fields of a command, one for each part.
std::vector<const Field*> parts_of(const editor::CommandSpec& spec) {
    std::vector<const Field*> parts;
    for (const Field& field : spec.fields) parts.insert(parts.end(), field.parts.size(), &field);
    return parts;
}

bool names_curve(const Field& field, const std::string& word, const core::Document& document) {
    const bool is_curve = field.kind == FieldKind::curve_name || field.kind == FieldKind::curve_index;
    return is_curve && core::curve_meant_by(document, word);
}

// Whether a person would take the word for the name of an operation, with a slip perhaps.
bool looks_like_operation(const std::string& word) {
    const auto fits = [](char c) { return (c >= 'a' && c <= 'z') || c == '-'; };
    return !word.empty() && word.front() != '-' && std::all_of(word.begin(), word.end(), fits);
}

bool names_choice(const Field& field, const std::string& word) {
    return field.kind == FieldKind::choice &&
           std::any_of(field.choices.begin(), field.choices.end(),
                       [&](const editor::Choice& choice) { return word == choice.name; });
}

// Whether the word says something about the field, right or wrong.
bool can_mean(const Field& field, const std::string& word) {
    if (field.kind == FieldKind::curve_name || field.kind == FieldKind::curve_index) return false;
    if (field.kind == FieldKind::choice && !field.is_optional) return names_choice(field, word);
    const std::vector<editor::Argument> arguments(field.parts.size(), editor::Word{word});
    return editor::read_field(field, arguments).has_value();
}

std::vector<std::string> names_of_operations() {
    std::vector<std::string> names;
    for (const editor::CommandSpec& spec : editor::command_table())
        if (spec.offered.scripts) names.emplace_back(spec.name);
    return names;
}

}  // namespace

const editor::CommandSpec* operation_called(const std::string& name) {
    const editor::CommandSpec* spec = editor::find_command(name);
    return spec != nullptr && spec->offered.scripts ? spec : nullptr;
}

std::vector<const Field*> fields_of_arguments(const editor::CommandSpec& spec, std::size_t count) {
    std::vector<const Field*> fields = parts_of(spec);
    for (std::size_t i = fields.size(); i-- > 0 && fields.size() > count;)
        if (fields[i]->can_be_left_out()) fields.erase(fields.begin() + static_cast<std::ptrdiff_t>(i));
    fields.resize(std::min(fields.size(), count));
    return fields;
}

std::size_t needed_count(const editor::CommandSpec& spec) {
    const std::vector<const Field*> parts = parts_of(spec);
    return static_cast<std::size_t>(
        std::count_if(parts.begin(), parts.end(), [](const Field* field) { return !field->can_be_left_out(); }));
}

void OperationReader::skip_mark() {
    while (next_ < words_.size() && words_[next_] == mark) ++next_;
}

editor::Refusal OperationReader::no_operation() const {
    const core::Place word("word", words_[next_]);
    if (!before_.empty() && left_out_ != nullptr)
        return sentence(
            "'{word}' after '{before}' is neither an operation nor a value of {name}, for which {needed} is needed; "
            "batten apply --list explains all operations",
            {word,
             {"before", before_},
             {"name", left_out_->parts.front().name},
             {"needed", editor::needed_text(*left_out_)}});
    if (const auto nearest = editor::nearest_name(words_[next_], names_of_operations()))
        return sentence(
            "'{word}' is not an operation; did you mean '{nearest}'? batten apply --list explains all of "
            "them",
            {word, {"nearest", *nearest}});
    if (before_.empty())
        return sentence("'{word}' is not an operation; batten apply --list explains all of them", {word});
    return sentence("'{word}' after '{before}' is not an operation; batten apply --list explains all of them",
                    {word, {"before", before_}});
}

// Whether the next word is an argument of the operation, of which `given` are there already.
bool OperationReader::is_argument(const editor::CommandSpec& spec, std::size_t given, const core::Document& document) {
    const std::vector<const Field*> parts = parts_of(spec);
    if (next_ == words_.size() || given == parts.size()) return false;
    const bool is_needed = given < needed_count(spec);
    if (words_[next_] == mark) {
        if (is_needed) ++next_;
        return is_needed && next_ < words_.size();
    }
    if (is_needed) return true;
    const Field& field = *fields_of_arguments(spec, given + 1).back();
    const std::string& word = words_[next_];
    if (names_curve(field, word, document) || names_choice(field, word)) return true;
    if (operation_called(word) != nullptr) return false;
    if (!looks_like_operation(word) || can_mean(field, word)) return true;
    left_out_ = &field;
    return false;
}

void OperationReader::take_arguments(Operation& operation, const core::Document& document) {
    while (is_argument(*operation.spec, operation.arguments.size(), document)) {
        operation.text = fmt::format("{} {}", operation.text, words_[next_]);
        for (editor::Argument& argument :
             editor::arguments_of_word(*operation.spec, operation.arguments.size(), words_[next_]))
            operation.arguments.push_back(std::move(argument));
        ++next_;
    }
}

editor::Outcome<Operation> OperationReader::take(const core::Document& document) {
    const editor::CommandSpec* spec = operation_called(words_[next_]);
    if (spec == nullptr) return tl::unexpected(no_operation());
    ++next_;
    left_out_ = nullptr;
    Operation operation{spec, {}, spec->name};
    take_arguments(operation, document);
    before_ = operation.text;
    skip_mark();
    if (!is_at_end() && operation_called(words_[next_]) == nullptr) return tl::unexpected(no_operation());
    return operation;
}

}  // namespace batten::cli
