/// What commands about pictures have in common: which picture they are about.
#pragma once

#include <optional>

#include "app/editor/command_spec.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/state/state.h"

namespace batten::editor {

/// Refusal: the document has no picture.
std::optional<Refusal> no_picture(const EditorState& state);

/// Refusal: the committed document has no picture of this number.
std::optional<Refusal> no_such_picture(const EditorState& state, std::size_t index);

/// The picture that is being scaled, else the last one.
std::optional<std::size_t> present_picture(const EditorState& state);

/// The field `picture` of a command.
template <class Command>
Field picture_field() {
    return field::count<&Command::picture>("picture", "its number, the lowest one is 0")
        .template suggesting<present_picture>();
}

}  // namespace batten::editor
