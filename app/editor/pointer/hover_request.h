/// Asks the editor to hover what lies under the pointer.
#pragma once

#include "app/editor/command.h"
#include "app/editor/state/state.h"

namespace batten::editor {

/// Puts SetHover into `queue` unless `hover` is hovered already, so that a resting pointer asks for nothing.
void request_hover(const Hover& hover, const EditorState& state, CommandQueue& queue);

}  // namespace batten::editor
