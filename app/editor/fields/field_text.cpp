#include "app/editor/fields/field_text.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/editor/fields/expression.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

using core::sentence;
using Given = std::span<const Argument>;
using Numbers = std::vector<double>;

// What was given, as the sentences of refusals name it.
struct FoundText {
    std::string operator()(Absent) const { return "nothing"; }
    std::string operator()(const Word& word) const { return word.text; }
    std::string operator()(bool value) const { return flag_text(value); }
    std::string operator()(double value) const { return core::shortest_text(value); }
    std::string operator()(const std::string& value) const { return sentence("the text '{text}'", {{"text", value}}); }
    std::string operator()(const Numbers& values) const {
        return sentence({.one = "a list of one number", .many = "a list of {count} numbers"}, values.size());
    }
};

Refusal refusal_of(const Field& field, const FieldPart& part, const Argument& found) {
    return sentence("{name} is {found}; {needed} is needed, {meaning}", {{"name", part.name},
                                                                         {"found", std::visit(FoundText{}, found)},
                                                                         {"needed", needed_text(field)},
                                                                         {"meaning", part.meaning}});
}

tl::unexpected<Refusal> refuse(const Field& field, const Argument& found) {
    return tl::unexpected(refusal_of(field, field.parts.front(), found));
}

Outcome<FieldValue> read_number(const Field& field, const Argument& given) {
    if (const auto* number = std::get_if<double>(&given)) return *number;
    return refuse(field, given);
}

Outcome<std::int64_t> whole(const Field& field, double number) {
    constexpr double exact_up_to = 1e15;
    if (number == std::floor(number) && std::abs(number) <= exact_up_to) return static_cast<std::int64_t>(number);
    const core::Place name("name", field.parts.front().name);
    const core::Place found("value", core::shortest_text(number));
    const auto& [lower, upper, excludes_lower] = field.limits;
    if (lower && upper)
        return tl::unexpected(
            sentence("{name} is {value}; a whole number from {lower} to {upper} is needed",
                     {name, found, {"lower", core::shortest_text(*lower)}, {"upper", core::shortest_text(*upper)}}));
    return tl::unexpected(sentence("{name} is {value}; a whole number from 0 is needed", {name, found}));
}

Outcome<FieldValue> read_whole(const Field& field, const Argument& given) {
    const auto* number = std::get_if<double>(&given);
    if (number == nullptr) return refuse(field, given);
    return whole(field, *number).map([](std::int64_t value) { return FieldValue(value); });
}

struct FlagWord {
    const char* word;
    bool value;
};

constexpr std::array flag_words{FlagWord{"yes", true},  FlagWord{"no", false},  FlagWord{"on", true},
                                FlagWord{"off", false}, FlagWord{"true", true}, FlagWord{"false", false}};

// Flags were the numbers 1 and 0 once, and may still be typed like that.
Outcome<FieldValue> read_flag(const Field& field, const Argument& given) {
    if (const auto* value = std::get_if<bool>(&given)) return *value;
    if (const auto* number = std::get_if<double>(&given); number != nullptr && std::isfinite(*number))
        return *number != 0.0;
    if (const auto* text = std::get_if<std::string>(&given))
        for (const FlagWord& known : flag_words)
            if (*text == known.word) return known.value;
    return refuse(field, given);
}

Outcome<FieldValue> read_text(const Field& field, const Argument& given) {
    if (const auto* text = std::get_if<std::string>(&given)) return *text;
    if (const auto* number = std::get_if<double>(&given)) return core::shortest_text(*number);
    return refuse(field, given);
}

// A number stands for a list of one.
Outcome<Numbers> numbers_of(const Field& field, const Argument& given) {
    if (const auto* numbers = std::get_if<Numbers>(&given)) return *numbers;
    if (const auto* number = std::get_if<double>(&given)) return Numbers{*number};
    return refuse(field, given);
}

Outcome<FieldValue> read_indices(const Field& field, const Numbers& numbers) {
    std::vector<std::size_t> indices;
    for (const double number : numbers) {
        const Outcome<std::int64_t> index = whole(field, number);
        if (!index) return tl::unexpected(index.error());
        indices.push_back(static_cast<std::size_t>(*index));
    }
    return indices;
}

Outcome<FieldValue> read_positions(const Field& field, const Numbers& numbers) {
    if (numbers.size() % 2 != 0)
        return tl::unexpected(sentence("{name} has {count} numbers; x and y of each point are needed",
                                       {{"name", field.parts.front().name}, {"count", numbers.size()}}));
    std::vector<core::Point> points;
    for (std::size_t i = 0; i < numbers.size(); i += 2) points.emplace_back(numbers[i], numbers[i + 1]);
    return points;
}

Outcome<FieldValue> read_pair(const Field& field, Given given) {
    Numbers pair;
    if (field.parts.size() == 1) {
        const Outcome<Numbers> list = numbers_of(field, given.front());
        if (!list) return tl::unexpected(list.error());
        if (list->size() != 2) return refuse(field, given.front());
        pair = *list;
    } else {
        for (std::size_t k = 0; k < field.parts.size(); ++k) {
            const auto* number = std::get_if<double>(&given[k]);
            if (number == nullptr) return tl::unexpected(refusal_of(field, field.parts[k], given[k]));
            pair.push_back(*number);
        }
    }
    return core::Point(pair[0], pair[1]);
}

// What stands for absent: nothing in a log, "none" where it is typed, and what stood for it once.
bool means_absent(const Field& field, const Argument& given) {
    if (std::holds_alternative<Absent>(given)) return true;
    const bool is_free_text = field.kind == FieldKind::text || field.kind == FieldKind::file;
    if (!is_free_text && given == Argument("none")) return true;
    return field.absent_word != nullptr && parse_argument(field.absent_word) == given;
}

Outcome<FieldValue> read_kind(const Field& field, Given given) {
    const auto as_list = [&](auto read) {
        return numbers_of(field, given.front()).and_then([&](const Numbers& numbers) { return read(field, numbers); });
    };
    switch (field.kind) {
        case FieldKind::number:
        case FieldKind::parameter:
        case FieldKind::length:
        case FieldKind::angle:
            return read_number(field, given.front());
        case FieldKind::count:
        case FieldKind::point_index:
        case FieldKind::knot_index:
        case FieldKind::curve_index:
            return read_whole(field, given.front());
        case FieldKind::flag:
            return read_flag(field, given.front());
        case FieldKind::position:
        case FieldKind::vector:
            return read_pair(field, given);
        case FieldKind::positions:
            return as_list(read_positions);
        case FieldKind::parameters:
            return as_list([](const Field&, const Numbers& numbers) { return Outcome<FieldValue>(numbers); });
        case FieldKind::point_indices:
        case FieldKind::curve_indices:
            return as_list(read_indices);
        case FieldKind::choice:
        case FieldKind::curve_name:
        case FieldKind::color:
        case FieldKind::text:
        case FieldKind::file:
            return read_text(field, given.front());
    }
    return refuse(field, given.front());
}

bool is_number(const Field& field) {
    switch (field.kind) {
        case FieldKind::number:
        case FieldKind::parameter:
        case FieldKind::length:
        case FieldKind::angle:
        case FieldKind::count:
        case FieldKind::point_index:
        case FieldKind::knot_index:
        case FieldKind::curve_index:
            return true;
        case FieldKind::position:
        case FieldKind::vector:
            return field.parts.size() == 2;
        default:
            return false;
    }
}

bool is_list(const Field& field) {
    switch (field.kind) {
        case FieldKind::position:
        case FieldKind::vector:
            return field.parts.size() == 1;
        case FieldKind::positions:
        case FieldKind::parameters:
        case FieldKind::point_indices:
        case FieldKind::curve_indices:
            return true;
        default:
            return false;
    }
}

tl::expected<Argument, std::string> evaluated(const Field& field, const std::string& text, const Units& units) {
    if (is_of_lengths(field) && is_list(field)) return parse_lengths(text, units);
    if (is_of_lengths(field)) return parse_length(text, units);
    if (is_list(field)) return parse_expressions(text);
    return parse_expression(text, field.kind == FieldKind::angle ? ExpressionUnit::degrees : ExpressionUnit::number);
}

// A word is a text where the field is one, else the number or list that it stands for. What has no digit is no formula
// but something else.
Outcome<Argument> meant(const Field& field, const FieldPart& part, const Argument& given, const Units& units) {
    const auto* word = std::get_if<Word>(&given);
    if (word == nullptr) return given;
    if (takes_text(field)) return Argument(word->text);
    if (!is_number(field) && !is_list(field)) return parse_argument(word->text);
    auto value = evaluated(field, word->text, units);
    if (value) return *std::move(value);
    if (word->text.find_first_of("0123456789(") == std::string::npos) return Argument(word->text);
    return tl::unexpected(sentence("{name} is {found}; {problem}",
                                   {{"name", part.name}, {"found", word->text}, {"problem", value.error()}}));
}

// One case for each type of value.
struct ArgumentsOf {
    const Field& field;

    std::vector<Argument> operator()(Absent) const {
        return std::vector<Argument>(field.parts.size(), Argument(Absent{}));
    }
    std::vector<Argument> operator()(bool value) const { return {value}; }
    std::vector<Argument> operator()(std::int64_t value) const { return {static_cast<double>(value)}; }
    std::vector<Argument> operator()(double value) const { return {value}; }
    std::vector<Argument> operator()(const std::string& value) const { return {value}; }
    std::vector<Argument> operator()(core::Point pair) const {
        if (field.parts.size() == 1) return {Numbers{pair.x, pair.y}};
        return {pair.x, pair.y};
    }
    std::vector<Argument> operator()(const Numbers& numbers) const { return {numbers}; }
    std::vector<Argument> operator()(const std::vector<std::size_t>& indices) const {
        return {Numbers(indices.begin(), indices.end())};
    }
    std::vector<Argument> operator()(const std::vector<core::Point>& points) const {
        Numbers numbers;
        for (const core::Point point : points) numbers.insert(numbers.end(), {point.x, point.y});
        return {std::move(numbers)};
    }
};

}  // namespace

bool takes_text(const Field& field) {
    switch (field.kind) {
        case FieldKind::choice:
        case FieldKind::curve_name:
        case FieldKind::color:
        case FieldKind::text:
        case FieldKind::file:
            return true;
        default:
            return false;
    }
}

bool is_of_lengths(const Field& field) {
    switch (field.kind) {
        case FieldKind::length:
        case FieldKind::position:
        case FieldKind::positions:
        case FieldKind::vector:
            return true;
        default:
            return false;
    }
}

Outcome<FieldValue> read_field(const Field& field, std::span<const Argument> given, const Units& units) {
    std::vector<Argument> arguments;
    for (std::size_t k = 0; k < given.size(); ++k) {
        Outcome<Argument> argument = meant(field, field.parts[k], given[k], units);
        if (!argument) return tl::unexpected(argument.error());
        arguments.push_back(*std::move(argument));
    }
    if (field.is_optional && means_absent(field, arguments.front())) return FieldValue(Absent{});
    return read_kind(field, arguments);
}

std::vector<Argument> arguments_of(const Field& field, const FieldValue& value) {
    return std::visit(ArgumentsOf{field}, value);
}

}  // namespace batten::editor
