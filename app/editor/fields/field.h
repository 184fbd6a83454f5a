/// One field of a command as its description tells it: name, meaning, kind, what is allowed and what suggests itself.
/// Texts, logs, forms, completion and help are made from it.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "app/editor/fields/field_value.h"

namespace batten::editor {

struct EditorState;

/// One refusal as a sentence for the user.
using Refusal = std::string;
template <class T>
using Outcome = tl::expected<T, Refusal>;

/// What a field means, and with it how it is read, checked, shown and explained.
enum class FieldKind {
    number,         ///< any finite number
    parameter,      ///< of the active curve
    length,         ///< in the units of the points
    angle,          ///< in degrees
    count,          ///< a whole number from 0
    point_index,    ///< a control point of the active curve
    knot_index,     ///< a knot of the active curve, in stored()
    curve_index,    ///< a curve of the document
    flag,           ///< yes or no
    choice,         ///< one of a few names
    position,       ///< a point; two numbers
    vector,         ///< a displacement or derivative; two numbers
    positions,      ///< a list of points
    parameters,     ///< a list of parameters or knots
    point_indices,  ///< a list of control points
    curve_indices,  ///< a list of curves of the document
    curve_name,     ///< a curve of the document that is not the active one
    color,          ///< "#4c7fe0"
    text,
    file  ///< a path
};

/// One of the names that a choice allows.
struct Choice {
    const char* name;   ///< "clamped-uniform", as in texts and logs
    const char* title;  ///< "clamped uniform", as people read it
};

/// What a number must be, or how many items a list must have.
struct Limits {
    std::optional<double> lower{};
    std::optional<double> upper{};
    bool excludes_lower = false;
};

/// A name and what it stands for.
struct FieldPart {
    const char* name;     ///< "u"
    const char* meaning;  ///< "where in the domain"
};

/// Made by the functions of field_kinds.h, which know the member that it stands for.
struct Field {
    FieldKind kind;
    std::vector<FieldPart> parts;  ///< one for each word; a point that is written as two words has two
    FieldValue (*get)(const void* command) = nullptr;
    void (*set)(void* command, const FieldValue& value) = nullptr;  ///< a value that check_field accepts
    std::vector<Choice> choices{};
    Limits limits{};
    bool is_optional = false;           ///< may be absent for good
    bool must_be_given = false;         ///< also where absent is allowed, which must then be said
    const char* absent_word = nullptr;  ///< a further word for absent, beside "none"
    bool allows_one_more = false;       ///< the index may be that of a control point yet to come
    bool is_asked = true;               ///< false: a form takes what suggests itself without showing it
    FieldValue (*suggestion_from)(const EditorState& state) = nullptr;
    FieldValue usual{};  ///< suggests itself where suggestion_from is null
    FieldValue (*initial_from)(const EditorState& state) = nullptr;

    /// What stands for the field where it is left out; absent where nothing suggests itself now.
    FieldValue suggestion(const EditorState& state) const { return suggestion_from ? suggestion_from(state) : usual; }

    /// What a form begins with: what suggests itself, else what is there now.
    FieldValue initial(const EditorState& state) const;

    /// Whether it may be left out, at least when something suggests itself.
    bool can_be_left_out() const {
        return !must_be_given && (is_optional || suggestion_from != nullptr || !is_absent(usual));
    }

    // What a description says of a field, behind the function that makes it.
    Field above(double lower) &&;
    Field at_least(double lower) &&;  ///< of a list: so many items
    Field at_most(double upper) &&;
    Field absent_as(const char* word) &&;
    Field or_one_more() &&;
    Field unasked() &&;
    Field required() &&;

    /// This value suggests itself always.
    template <class T>
    Field usually(const T& value) && {
        usual = FieldConversion<T>::to(value);
        return std::move(*this);
    }

    /// What `function` makes of the state suggests itself: a value of the member's type, or an optional one.
    template <auto function>
    Field suggesting() && {
        suggestion_from = value_by<function>;
        return std::move(*this);
    }

    /// It must be given, but a form begins with what `function` makes of the state.
    template <auto function>
    Field beginning_with() && {
        initial_from = value_by<function>;
        return std::move(*this);
    }

  private:
    template <auto function>
    static FieldValue value_by(const EditorState& state) {
        const auto value = function(state);
        return FieldConversion<std::remove_const_t<decltype(value)>>::to(value);
    }
};

/// What is wrong with `value` for this field: not finite, out of range, no such thing in the committed document of
/// `state`. The sentence names the field, what was found and what is allowed.
std::optional<Refusal> check_field(const Field& field, const FieldValue& value, const EditorState& state);

/// What a person reads for `value`: "0.5", "P₅", "3 points", "'wave'", "clamped uniform"; for a knot its value.
std::string shown_text(const Field& field, const FieldValue& value, const EditorState& state);

/// The kind in a word or two, for help: "number", "list", "stop, push or snap".
std::string kind_text(const Field& field);

/// What is needed, for refusals: "a number", "a list of numbers", "stop, push or snap".
std::string needed_text(const Field& field);

}  // namespace batten::editor
