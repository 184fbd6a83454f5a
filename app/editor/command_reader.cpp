#include "app/editor/command_reader.h"

#include <algorithm>
#include <numeric>

#include "app/editor/fields/expression.h"
#include "app/editor/fields/field_text.h"
#include "app/editor/state/state.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

using core::sentence;

std::size_t part_count(const CommandSpec& spec) {
    return std::accumulate(spec.fields.begin(), spec.fields.end(), std::size_t{0},
                           [](std::size_t sum, const Field& field) { return sum + field.parts.size(); });
}

Refusal too_many(const CommandSpec& spec, std::size_t given) {
    const std::size_t taken = part_count(spec);
    return sentence({.one = "{name} takes one argument; found {given}",
                     .many = "{name} takes {count} arguments; found {given}",
                     .none = "{name} takes no arguments; found {given}"},
                    taken, {{"name", spec.name}, {"given", given}});
}

Refusal missing(const Field& field, const FieldPart& part) {
    const std::initializer_list<core::Place> places{{"name", part.name}, {"meaning", part.meaning}};
    if (field.can_be_left_out())
        return sentence("{name} is missing: {meaning}; nothing of that kind is selected", places);
    return sentence("{name} is missing: {meaning}", places);
}

// Which parts are left out when `given` arguments come: the last ones that can be.
std::vector<bool> left_out(const CommandSpec& spec, std::size_t given) {
    std::vector<bool> can_be;
    for (const Field& field : spec.fields) can_be.insert(can_be.end(), field.parts.size(), field.can_be_left_out());
    std::vector<bool> result(can_be.size(), false);
    std::size_t missing = can_be.size() - given;
    for (std::size_t i = can_be.size(); i-- > 0 && missing > 0;) {
        if (!can_be[i]) continue;
        result[i] = true;
        --missing;
    }
    return result;
}

// Whether the argument behind `given` others is the first number of two that make a point.
bool begins_point(const CommandSpec& spec, std::size_t given) {
    std::size_t part = 0;
    for (const Field& field : spec.fields) {
        if (part == given) return field.parts.size() == 2;
        part += field.parts.size();
    }
    return false;
}

// A word for a curve's number may be its name.
Argument as_curve_index(const Argument& given, const EditorState& state) {
    const auto* word = std::get_if<Word>(&given);
    if (word == nullptr) return given;
    const std::optional<std::size_t> index = core::curve_meant_by(state.history.present(), word->text);
    return index ? Argument(static_cast<double>(*index)) : given;
}

// Goes through the arguments part by part.
class Reader {
  public:
    Reader(const CommandSpec& spec, const EditorState& state, const std::vector<Argument>& given)
        : state_(state), next_(given.begin()), end_(given.end()), is_left_out_(left_out(spec, given.size())) {}

    Outcome<FieldValue> take(const Field& field) {
        const FieldValue suggestion = field.suggestion(state_);
        const std::vector<Argument> suggested = editor::arguments_of(field, suggestion);
        std::vector<Argument> arguments;
        for (std::size_t k = 0; k < field.parts.size(); ++k) {
            if (!is_left_out_[part_++] && next_ != end_)
                arguments.push_back(taken(field));
            else if (field.can_be_left_out() && (field.is_optional || !is_absent(suggestion)))
                arguments.push_back(suggested[k]);
            else
                return tl::unexpected(missing(field, field.parts[k]));
        }
        return read_field(field, arguments, state_.history.present().units);
    }

  private:
    Argument taken(const Field& field) {
        const Argument& given = *next_++;
        return field.kind == FieldKind::curve_index ? as_curve_index(given, state_) : given;
    }

    const EditorState& state_;
    std::vector<Argument>::const_iterator next_;
    std::vector<Argument>::const_iterator end_;
    std::vector<bool> is_left_out_;
    std::size_t part_ = 0;
};

}  // namespace

Outcome<Command> read_command(const CommandSpec& spec, const EditorState& state, const std::vector<Argument>& given) {
    if (spec.refusal != nullptr)
        if (std::optional<Refusal> refusal = spec.refusal(state)) return tl::unexpected(*std::move(refusal));
    if (given.size() > part_count(spec)) return tl::unexpected(too_many(spec, given.size()));
    std::shared_ptr<void> command = spec.run.make();
    Reader reader(spec, state, given);
    for (const Field& field : spec.fields) {
        const Outcome<FieldValue> value = reader.take(field);
        if (!value) return tl::unexpected(value.error());
        if (std::optional<Refusal> refusal = check_field(field, *value, state)) return tl::unexpected(*refusal);
        field.set(command.get(), *value);
    }
    return Command(spec, std::move(command));
}

std::vector<Argument> arguments_of_word(const CommandSpec& spec, std::size_t given, const std::string& word) {
    if (begins_point(spec, given))
        for (const char* separator : {";", ","})
            if (const std::size_t at = find_outside_parentheses(word, separator); at != std::string::npos)
                return {Word{word.substr(0, at)}, Word{word.substr(at + 1)}};
    return {Word{word}};
}

std::vector<Argument> arguments_of(const Command& command) {
    std::vector<Argument> arguments;
    for (const Field& field : command.spec().fields)
        for (Argument& argument : arguments_of(field, field.get(command.fields())))
            arguments.push_back(std::move(argument));
    return arguments;
}

std::optional<Refusal> check_fields(const Command& command, const EditorState& state) {
    for (const Field& field : command.spec().fields)
        if (std::optional<Refusal> refusal = check_field(field, field.get(command.fields()), state)) return refusal;
    return std::nullopt;
}

}  // namespace batten::editor
