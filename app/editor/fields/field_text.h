/// Fields of commands as they stand in logs and as people type them.
#pragma once

#include <span>

#include "app/editor/fields/argument.h"
#include "app/editor/fields/field.h"
#include "app/editor/words/length.h"

namespace batten::editor {

/// How a flag is shown, and the first way to type it.
constexpr const char* flag_text(bool flag) {
    return flag ? "yes" : "no";
}

/// Whether a word that is typed for the field is taken as it stands, not as a number or a list.
bool takes_text(const Field& field);

/// Whether the field is a length or a place, which is read and typed in the document's unit.
bool is_of_lengths(const Field& field);

/// The value that `given` means, one argument for each part of the field. The sentence names the part, what was found
/// and what is needed; whether there is such a thing is check_field's to say. Lengths and coordinates may be typed with
/// a unit; those without one that are typed in words are in that of `units`, numbers are those of the world.
Outcome<FieldValue> read_field(const Field& field, std::span<const Argument> given, const Units& units = std::nullopt);

/// The arguments that mean `value`: as many as the field has parts.
std::vector<Argument> arguments_of(const Field& field, const FieldValue& value);

}  // namespace batten::editor
