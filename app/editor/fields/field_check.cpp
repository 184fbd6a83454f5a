#include <algorithm>
#include <cmath>

#include "app/editor/fields/field.h"
#include "app/editor/state/state.h"
#include "app/editor/words/length.h"
#include "app/editor/words/unknown_curve.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

using core::sentence;

constexpr std::int64_t greatest_whole = 1000000000;

const char* name_of(const Field& field) {
    return field.parts.front().name;
}

bool is_finite(const FieldValue& value) {
    const auto finite = [](double number) { return std::isfinite(number); };
    if (const auto* number = std::get_if<double>(&value)) return finite(*number);
    if (const auto* point = std::get_if<core::Point>(&value)) return finite(point->x) && finite(point->y);
    if (const auto* list = std::get_if<std::vector<double>>(&value))
        return std::all_of(list->begin(), list->end(), finite);
    if (const auto* points = std::get_if<std::vector<core::Point>>(&value))
        return std::all_of(points->begin(), points->end(), [&](core::Point p) { return finite(p.x) && finite(p.y); });
    return true;
}

Refusal not_finite(const Field& field) {
    return sentence(
        "{name} is not finite; {needed} is needed, {meaning}",
        {{"name", name_of(field)}, {"needed", needed_text(field)}, {"meaning", field.parts.front().meaning}});
}

// `words` is how a person would write the value and its limits.
template <class Words>
std::optional<Refusal> check_limits(const Field& field, double value, Words words) {
    const auto& [lower, upper, excludes_lower] = field.limits;
    const bool is_below = lower && (excludes_lower ? value <= *lower : value < *lower);
    if (!is_below && !(upper && value > *upper)) return std::nullopt;
    const core::Place name("name", name_of(field));
    const core::Place found("value", words(value));
    const core::Place least("lower", words(lower.value_or(0.0)));
    if (upper)
        return sentence("{name} is {value}; it must be from {lower} to {upper}",
                        {name, found, least, {"upper", words(*upper)}});
    if (excludes_lower) return sentence("{name} is {value}; it must be above {lower}", {name, found, least});
    return sentence("{name} is {value}; it must be {lower} or more", {name, found, least});
}

std::optional<Refusal> check_number(const Field& field, double value) {
    return check_limits(field, value, core::shortest_text);
}

std::optional<Refusal> check_length(const Field& field, double value, const Units& units) {
    return check_limits(field, value, [&](double length) { return length_words(units, length); });
}

std::optional<Refusal> check_item_count(const Field& field, std::size_t count) {
    const auto least = static_cast<std::size_t>(field.limits.lower.value_or(0.0));
    const bool is_exact = field.limits.upper == field.limits.lower && least > 0;
    if (count >= least && !(is_exact && count > least)) return std::nullopt;
    const std::initializer_list<core::Place> places{{"name", name_of(field)}, {"least", least}};
    if (field.kind != FieldKind::positions && is_exact)
        return sentence({.one = "one number was found for {name}; {least} are needed",
                         .many = "{count} numbers were found for {name}; {least} are needed"},
                        count, places);
    if (field.kind != FieldKind::positions)
        return sentence({.one = "one number was found for {name}; at least {least} are needed",
                         .many = "{count} numbers were found for {name}; at least {least} are needed"},
                        count, places);
    if (is_exact)
        return sentence({.one = "one point was found for {name}; {least} are needed",
                         .many = "{count} points were found for {name}; {least} are needed"},
                        count, places);
    return sentence({.one = "one point was found for {name}; at least {least} are needed",
                     .many = "{count} points were found for {name}; at least {least} are needed"},
                    count, places);
}

std::optional<Refusal> check_whole(const Field& field, std::int64_t value) {
    const core::Place name("name", name_of(field));
    const core::Place found("value", value);
    const auto words = [](double number) { return std::to_string(static_cast<std::int64_t>(number)); };
    if (std::optional<Refusal> refusal = check_limits(field, static_cast<double>(value), words)) return refusal;
    if (value < 0) return sentence("{name} is {value}; a whole number from 0 is needed", {name, found});
    if (value > greatest_whole)
        return sentence("{name} is {value}; a whole number from 0 to 1000000000 is needed", {name, found});
    return std::nullopt;
}

// `pattern` says that there is no {index}, the last one being {last}. Where there is nothing at all the command itself
// is refused.
std::optional<Refusal> check_index(const Field& field, std::int64_t value, std::size_t count, const char* pattern) {
    if (std::optional<Refusal> refusal = check_whole(field, value)) return refusal;
    if (count == 0 || static_cast<std::size_t>(value) < count) return std::nullopt;
    return sentence(pattern, {{"index", value}, {"last", count - 1}});
}

constexpr const char* no_control_point = "there is no control point {index}; the last one is {last}";
constexpr const char* no_knot = "there is no knot {index}; the last one is {last}";
constexpr const char* no_curve_of_index = "there is no curve {index}; the last one is {last}";

/// The curve that the fields are about; null without one.
const core::Curve* checked_curve(const EditorState& state) {
    const core::DocumentCurve* item = state.history.present().active_curve();
    return item == nullptr ? nullptr : item->curve.get();
}

std::size_t point_count(const EditorState& state) {
    const core::Curve* curve = checked_curve(state);
    return curve == nullptr ? 0 : curve->control_points().size();
}

std::size_t knot_count(const EditorState& state) {
    const core::Curve* curve = checked_curve(state);
    return curve == nullptr ? 0 : curve->knots().stored().size();
}

std::optional<Refusal> check_indices(const Field& field, const std::vector<std::size_t>& indices, std::size_t count,
                                     const char* pattern) {
    for (const std::size_t index : indices)
        if (auto refusal = check_index(field, static_cast<std::int64_t>(index), count, pattern)) return refusal;
    return check_item_count(field, indices.size());
}

std::optional<Refusal> check_choice(const Field& field, const std::string& value) {
    for (const Choice& choice : field.choices)
        if (value == choice.name) return std::nullopt;
    return sentence("{name} is '{value}'; it must be {choices}",
                    {{"name", name_of(field)}, {"value", value}, {"choices", needed_text(field)}});
}

std::optional<Refusal> check_curve_name(const std::string& value, const EditorState& state) {
    const core::Document& document = state.history.present();
    if (core::curve_meant_by(document, value)) return std::nullopt;
    return unknown_curve(document, value);
}

std::optional<Refusal> check_color(const Field& field, const std::string& value) {
    if (core::color_of_text(value)) return std::nullopt;
    return sentence("{name} is '{value}'; a color is written #4c7fe0", {{"name", name_of(field)}, {"value", value}});
}

// One case for each kind that has more to check than that its numbers are finite.
std::optional<Refusal> check_kind(const Field& field, const FieldValue& value, const EditorState& state) {
    switch (field.kind) {
        case FieldKind::number:
        case FieldKind::parameter:
        case FieldKind::angle:
            return check_number(field, std::get<double>(value));
        case FieldKind::length:
            return check_length(field, std::get<double>(value), units_of(state));
        case FieldKind::count:
            return check_whole(field, std::get<std::int64_t>(value));
        case FieldKind::point_index:
            return check_index(field, std::get<std::int64_t>(value),
                               point_count(state) + (field.allows_one_more ? 1 : 0), no_control_point);
        case FieldKind::knot_index:
            return check_index(field, std::get<std::int64_t>(value), knot_count(state), no_knot);
        case FieldKind::curve_index:
            return check_index(field, std::get<std::int64_t>(value), state.history.present().curves.size(),
                               no_curve_of_index);
        case FieldKind::point_indices:
            return check_indices(field, std::get<std::vector<std::size_t>>(value), point_count(state),
                                 no_control_point);
        case FieldKind::curve_indices:
            return check_indices(field, std::get<std::vector<std::size_t>>(value),
                                 state.history.present().curves.size(), no_curve_of_index);
        case FieldKind::positions:
            return check_item_count(field, std::get<std::vector<core::Point>>(value).size());
        case FieldKind::parameters:
            return check_item_count(field, std::get<std::vector<double>>(value).size());
        case FieldKind::choice:
            return check_choice(field, std::get<std::string>(value));
        case FieldKind::curve_name:
            return check_curve_name(std::get<std::string>(value), state);
        case FieldKind::color:
            return check_color(field, std::get<std::string>(value));
        case FieldKind::flag:
        case FieldKind::position:
        case FieldKind::vector:
        case FieldKind::text:
        case FieldKind::file:
            return std::nullopt;
    }
    return std::nullopt;
}

}  // namespace

std::optional<Refusal> check_field(const Field& field, const FieldValue& value, const EditorState& state) {
    if (is_absent(value)) return std::nullopt;
    if (!is_finite(value)) return not_finite(field);
    return check_kind(field, value, state);
}

}  // namespace batten::editor
