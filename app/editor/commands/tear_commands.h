/// Commands that let edits tear the active curve, and how edits of its knots use that.
#pragma once

#include "app/editor/command.h"
#include "app/editor/command_spec.h"
#include "app/editor/state/state.h"

namespace batten::editor {

struct AllowTears {
    static const CommandSpec& spec();
};

struct ForbidTears {
    static const CommandSpec& spec();
};

/// What edits may do to the active curve; there must be one.
core::Tears tears_of_active(const EditorState& state);

/// edit_active for an operation that was given tears_of_active; where leave to tear is all that it lacks, the refusal
/// says how to give it.
Outcome<Edit> edit_or_tear(const EditorState& state, core::Result<core::Curve> curve,
                           std::optional<Selection> selection = {});

}  // namespace batten::editor
