#include "app/editor/pointer/typed_place.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "app/editor/fields/expression.h"
#include "app/editor/pointer/direction.h"
#include "app/editor/pointer/snap.h"
#include "core/base/ascii.h"
#include "core/base/utf8.h"

namespace batten::editor {
namespace {

constexpr std::size_t longest_text = 60;
constexpr std::u32string_view first_characters = U"0123456789+-.(@<=\u2212";

enum class Frame { polar, offsets, absolute };

/// The expressions that were typed; an empty one leaves its number to the pointer.
struct Expressions {
    Frame frame = Frame::polar;
    std::string_view first;
    std::string_view second;
};

Expressions divided(std::string_view text, std::size_t at, Frame frame) {
    return {frame, core::trimmed(text.substr(0, at)), core::trimmed(text.substr(at + 1))};
}

Expressions expressions_of_text(std::string_view text, Frame frame) {
    const bool is_relative = text.starts_with('@');
    if (is_relative) text.remove_prefix(1);
    if (const std::size_t at = find_outside_parentheses(text, "<"); at != std::string_view::npos)
        return divided(text, at, Frame::polar);
    for (const char* separator : {";", ","})
        if (const std::size_t at = find_outside_parentheses(text, separator); at != std::string_view::npos)
            return divided(text, at, is_relative ? Frame::offsets : Frame::absolute);
    return {is_relative ? Frame::offsets : frame, core::trimmed(text), {}};
}

std::string_view expression_in(const TypedPlace& typed, std::size_t field) {
    std::string_view text = core::trimmed(typed.texts[field]);
    if (text.starts_with('=')) text.remove_prefix(1);
    return core::trimmed(text);
}

Expressions expressions_of(const TypedPlace& typed) {
    const Frame frame = typed.has_offsets ? Frame::offsets : Frame::polar;
    if (typed.active == 0 && typed.texts[1].empty()) return expressions_of_text(expression_in(typed, 0), frame);
    return {frame, expression_in(typed, 0), expression_in(typed, 1)};
}

Outcome<std::optional<double>> length_of(std::string_view text, const Units& units) {
    if (text.empty()) return std::nullopt;
    const auto value = parse_length(text, units);
    if (!value) return tl::make_unexpected(value.error());
    return *value;
}

Outcome<std::optional<double>> angle_of(std::string_view text) {
    if (text.empty()) return std::nullopt;
    const auto value = parse_expression(text, ExpressionUnit::degrees);
    if (!value) return tl::make_unexpected(value.error());
    return *value;
}

Outcome<std::optional<double>> factor_of(std::string_view text) {
    const bool is_percent = text.ends_with('%');
    if (is_percent) text.remove_suffix(1);
    if (text.empty()) return std::nullopt;
    const auto value = parse_expression(text);
    if (!value) return tl::make_unexpected(value.error());
    if (*value == 0.0) return tl::make_unexpected(Refusal("a factor of 0 would leave nothing"));
    return is_percent ? *value / 100.0 : *value;
}

core::Point polar_place(core::Point from, std::optional<double> length, std::optional<double> angle,
                        core::Point pointed) {
    const core::Vector way = pointed - from;
    if (angle) {
        const core::Vector along = direction_of(*angle);
        return from + length.value_or(core::dot(way, along)) * along;
    }
    // Where the pointer shows no direction it is to the right.
    return from + *length * (way == core::Vector(0.0, 0.0) ? core::Vector(1.0, 0.0) : direction_of(way));
}

core::Point place_of(Frame frame, std::optional<double> first, std::optional<double> second, core::Point from,
                     core::Point pointed) {
    if (frame == Frame::polar) return polar_place(from, first, second, pointed);
    const core::Vector origin = frame == Frame::offsets ? core::vector_to(from) : core::Vector(0.0, 0.0);
    return {first ? origin.x + *first : pointed.x, second ? origin.y + *second : pointed.y};
}

/// As it stands in an expression; a typographic minus is as good as any.
std::string_view utf8_of(char32_t character) {
    if (character == U'\u03c0') return "π";
    if (character == U'\u2212') return "−";
    return "°";
}

std::string with_character(std::string text, char32_t character) {
    constexpr char32_t last_ascii = 0x7f;
    if (character < last_ascii) return text.append(1, static_cast<char>(character));
    return text.append(utf8_of(character));
}

bool is_name_letter(char32_t character) {
    return (character >= U'a' && character <= U'z') || (character >= U'A' && character <= U'Z') ||
           character == U'\u03c0';
}

bool can_be_in_expression(char32_t character) {
    constexpr std::u32string_view others = U"\u03c0\u2212\u00b0";
    constexpr char32_t last_ascii = 0x7e;
    return (character >= U' ' && character <= last_ascii) || others.find(character) != std::u32string_view::npos;
}

}  // namespace

std::optional<TypedPlace> typed_character(TypedPlace typed, char32_t character, FirstLetters letters) {
    std::string& text = typed.texts[typed.active];
    const bool is_first = typed.texts[0].empty() && typed.texts[1].empty();
    if (is_first && (character == U'x' || character == U'y')) {
        typed.has_offsets = true;
        typed.active = character == U'y' ? 1 : 0;
        return typed;
    }
    const bool begins = first_characters.find(character) != std::u32string_view::npos ||
                        (letters == FirstLetters::begin_numbers && is_name_letter(character));
    if (typed.is_empty() ? !begins : !can_be_in_expression(character)) return std::nullopt;
    if (text.size() < longest_text) text = with_character(std::move(text), character);
    return typed;
}

std::optional<TypedPlace> typed_key(TypedPlace typed, Key key) {
    if (typed.is_empty()) return std::nullopt;
    if (key == Key::tab) {
        typed.active = 1 - typed.active;
        return typed;
    }
    if (key != Key::backspace) return std::nullopt;
    std::string& text = typed.texts[typed.active];
    while (!text.empty() && core::continues_utf8(text.back())) text.pop_back();
    if (!text.empty()) {
        text.pop_back();
        if (typed.texts[0].empty() && typed.texts[1].empty() && !typed.has_offsets) typed = {};
        return typed;
    }
    typed.active = 0;
    typed.has_offsets = typed.has_offsets && !typed.texts[0].empty();
    return typed;
}

Outcome<core::Point> place_typed(const TypedPlace& typed, std::optional<core::Point> from, core::Point pointed,
                                 const Units& units) {
    const Expressions expressions = expressions_of(typed);
    const bool is_polar = expressions.frame == Frame::polar;
    const auto first = length_of(expressions.first, units);
    if (!first) return tl::make_unexpected(first.error());
    const auto second = is_polar ? angle_of(expressions.second) : length_of(expressions.second, units);
    if (!second) return tl::make_unexpected(second.error());
    if (!*first && !*second) return pointed;
    const core::Point place =
        place_of(expressions.frame, *first, *second, from.value_or(core::Point(0.0, 0.0)), pointed);
    if (!core::is_finite(place)) return tl::make_unexpected("the place is too far away for a number");
    return place;
}

std::optional<double> typed_length(const TypedPlace& typed, const Units& units) {
    const Expressions expressions = expressions_of(typed);
    if (expressions.frame != Frame::polar || expressions.first.empty()) return std::nullopt;
    const auto length = parse_length(expressions.first, units);
    return length ? std::optional(*length) : std::nullopt;
}

std::optional<double> typed_length_alone(const TypedPlace& typed, const Units& units) {
    return expressions_of(typed).second.empty() ? typed_length(typed, units) : std::nullopt;
}

std::optional<double> typed_length_in(const TypedPlace& typed, std::size_t field, const Units& units) {
    return length_of(expression_in(typed, field), units).value_or(std::nullopt);
}

std::optional<double> typed_factor(const TypedPlace& typed, std::size_t field) {
    return factor_of(expression_in(typed, field)).value_or(std::nullopt);
}

std::optional<double> typed_angle(const TypedPlace& typed) {
    return angle_of(expression_in(typed, 0)).value_or(std::nullopt);
}

std::string typed_problem(const Placing& placing, core::Point pointed, const Units& units) {
    const TypedPlace& typed = placing.typed;
    const TypedFor typed_for = placing.place ? placing.place->typed_for : TypedFor::place;
    const bool is_number_in_fields =
        typed_for == TypedFor::factors || typed_for == TypedFor::angle || typed_for == TypedFor::sides;
    if (!is_number_in_fields) {
        const auto place = place_typed(typed, placing.place ? placing.place->from : std::nullopt, pointed, units);
        return place ? std::string() : place.error();
    }
    for (std::size_t field = 0; field < typed.texts.size(); ++field) {
        const std::string_view text = expression_in(typed, field);
        const auto number = typed_for == TypedFor::angle   ? angle_of(text)
                            : typed_for == TypedFor::sides ? length_of(text, units)
                                                           : factor_of(text);
        if (!number) return number.error();
    }
    return {};
}

const char* title_of_field(const TypedPlace& typed, std::size_t field) {
    if (typed.has_offsets) return field == 0 ? "dx" : "dy";
    return field == 0 ? "length" : "angle";
}

}  // namespace batten::editor
