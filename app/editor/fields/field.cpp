#include "app/editor/fields/field.h"

#include "app/editor/fields/field_text.h"
#include "app/editor/state/state.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/length.h"
#include "app/editor/words/wording.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

using core::sentence;

std::string shown_whole(const Field& field, std::int64_t value, const EditorState& state) {
    const auto index = static_cast<std::size_t>(value);
    if (field.kind == FieldKind::point_index) return point_text(index);
    const core::Document& document = state.history.present();
    const std::vector<core::DocumentCurve>& curves = document.curves;
    if (field.kind == FieldKind::knot_index && document.active_curve() != nullptr) {
        const std::span<const double> knots = document.active_curve()->curve->knots().stored();
        if (index < knots.size()) return core::shortest_text(knots[index]);
    }
    if (field.kind == FieldKind::curve_index && index < curves.size())
        return sentence("'{name}'", {{"name", curves[index].name}});
    return std::to_string(value);
}

std::string shown_curve(const std::string& value, const core::Document& document) {
    const std::optional<std::size_t> index = core::curve_meant_by(document, value);
    return sentence("'{name}'", {{"name", index ? document.curves[*index].name : value}});
}

std::string shown_string(const Field& field, const std::string& value, const EditorState& state) {
    if (field.kind == FieldKind::file) return std::filesystem::path(value).filename().string();
    if (field.kind == FieldKind::curve_name) return shown_curve(value, state.history.present());
    for (const Choice& choice : field.choices)
        if (value == choice.name) return choice.title;
    return value;
}

// One case for each type of value.
struct ShownText {
    const Field& field;
    const EditorState& state;

    std::string operator()(Absent) const { return "none"; }
    std::string operator()(bool value) const { return flag_text(value); }
    std::string operator()(std::int64_t value) const { return shown_whole(field, value, state); }
    std::string operator()(double value) const {
        if (field.kind == FieldKind::length) return length_words(units_of(state), value);
        return core::shortest_text(value);
    }
    std::string operator()(const std::string& value) const { return shown_string(field, value, state); }
    std::string operator()(core::Point value) const { return place_words(units_of(state), value); }
    std::string operator()(const std::vector<double>& values) const {
        return sentence({.one = "one number", .many = "{count} numbers"}, values.size());
    }
    std::string operator()(std::vector<std::size_t> indices) const {
        std::sort(indices.begin(), indices.end());
        indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
        return field.kind == FieldKind::curve_indices ? curves_text(state.history.present(), indices)
                                                      : points_text(indices);
    }
    std::string operator()(const std::vector<core::Point>& points) const {
        return sentence({.one = "one point", .many = "{count} points"}, points.size());
    }
};

std::string names_of(const std::vector<Choice>& choices) {
    std::vector<std::string> names;
    for (const Choice& choice : choices) names.emplace_back(choice.name);
    return core::listed_as_alternatives(names);
}

struct KindWords {
    const char* kind;
    const char* needed;
};

KindWords words_of(const Field& field) {
    switch (field.kind) {
        case FieldKind::number:
        case FieldKind::parameter:
        case FieldKind::length:
        case FieldKind::angle:
            return {"number", "a number"};
        case FieldKind::position:
        case FieldKind::vector:
            return field.parts.size() == 1 ? KindWords{"x,y", "a list of two numbers"}
                                           : KindWords{"number", "a number"};
        case FieldKind::count:
        case FieldKind::point_index:
        case FieldKind::knot_index:
            return {"whole number", "a whole number"};
        case FieldKind::curve_index:
            return {"number or name", "the number or name of a curve"};
        case FieldKind::flag:
            return {"yes or no", "yes or no"};
        case FieldKind::positions:
        case FieldKind::parameters:
        case FieldKind::point_indices:
        case FieldKind::curve_indices:
            return {"list", "a list of numbers"};
        case FieldKind::curve_name:
            return {"name or number", "the name or number of a curve"};
        case FieldKind::color:
            return {"color", "a color"};
        case FieldKind::file:
            return {"file", "a file"};
        case FieldKind::choice:
        case FieldKind::text:
            break;
    }
    return {"text", "a text"};
}

}  // namespace

FieldValue Field::initial(const EditorState& state) const {
    const FieldValue suggested = suggestion(state);
    return is_absent(suggested) && initial_from != nullptr ? initial_from(state) : suggested;
}

Field Field::above(double lower) && {
    limits.lower = lower;
    limits.excludes_lower = true;
    return std::move(*this);
}

Field Field::at_least(double lower) && {
    limits.lower = lower;
    return std::move(*this);
}

Field Field::at_most(double upper) && {
    limits.upper = upper;
    return std::move(*this);
}

Field Field::absent_as(const char* word) && {
    absent_word = word;
    return std::move(*this);
}

Field Field::or_one_more() && {
    allows_one_more = true;
    return std::move(*this);
}

Field Field::unasked() && {
    is_asked = false;
    return std::move(*this);
}

Field Field::required() && {
    must_be_given = true;
    return std::move(*this);
}

std::string shown_text(const Field& field, const FieldValue& value, const EditorState& state) {
    return std::visit(ShownText{field, state}, value);
}

std::string kind_text(const Field& field) {
    return field.kind == FieldKind::choice ? names_of(field.choices) : words_of(field).kind;
}

std::string needed_text(const Field& field) {
    return field.kind == FieldKind::choice ? names_of(field.choices) : words_of(field).needed;
}

}  // namespace batten::editor
